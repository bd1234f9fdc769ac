#include "scatter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/world/markup.h"

#include "draws.h"
#include "regions.h"

namespace elsie::layouts {

namespace {

using base::number_text;

constexpr std::size_t kMost = 1'000'000;  // things

class Scattering {
 public:
  Scattering(Drawing& drawing, const Scatter& scatter, const Element& thing, Occupied& occupied)
      : drawing_(drawing),
        scatter_(scatter),
        thing_(thing),
        list_(list_of(thing.name)),
        occupied_(occupied),
        places_(drawing, scatter) {}

  void draw() {
    if (!check() || !places_.is_right() || !make_things()) {
      return;
    }
    places_.expect(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      if (!place(i)) return;
    }
  }

 private:
  bool refuse(const std::string& problem) {
    return drawing_.refuse(scatter_.location, scatter_.id, problem);
  }

  bool check() {
    if (scatter_.count && scatter_.density) {
      return refuse("has a count and a density; expected one of them");
    }
    if (scatter_.density && !places_.area()) {
      return refuse(
          "has a density, but its things stand along a line or about a point, which has "
          "no area; give a count instead");
    }
    for (const char* name : {"x", "y"}) {
      if (const auto* given = thing_.find(name)) {
        drawing_.problems.add(given->where, world::in_words(*given, thing_) +
                                                ": it is scattered, so its place is drawn; take it "
                                                "out, or say where in <" +
                                                "in_box> or another region");
        return false;
      }
    }
    if (const auto* given = thing_.find("heading_deg"); given && scatter_.heading) {
      drawing_.problems.add(given->where, world::in_words(*given, thing_) +
                                              ": <heading> draws it; take one of them out");
      return false;
    }
    return true;
  }

  /// The n-th thing (from 0) without a place and a name.
  Element thing(std::size_t i) const {
    Element made = thing_;
    draw_in(drawing_, scatter_, made, list_, i);
    return made;
  }

  std::vector<Body> bodies_of_things(std::size_t from, std::size_t count) {
    std::vector<Element> things;
    for (std::size_t i = from; i < from + count; ++i) {
      things.push_back(thing(i));
      things.back().set("id", "thing_" + std::to_string(i + 1), scatter_.location);
    }
    Problems problems;
    std::vector<Body> bodies = bodies_of(drawing_, list_, std::move(things), problems);
    const std::vector<base::Problem> found = problems.sorted(drawing_.file);
    // Of things that differ, each may be wrong in the same way.
    const bool are_alike = scatter_.draws.empty();
    drawing_.problems.add(
        std::span(found).first(are_alike ? found.size() : std::min<std::size_t>(1, found.size())));
    return bodies;
  }

  /// Finds out how many there are, and their bodies: one for all if they are alike.
  bool make_things() {
    const bool are_alike = scatter_.draws.empty();
    const std::size_t before = drawing_.problems.size();
    if (!scatter_.density) {
      count_ = static_cast<std::size_t>(scatter_.count.value_or(1));
      bodies_ = bodies_of_things(0, are_alike ? 1 : count_);
    } else {
      bodies_ = bodies_of_things(0, 1);
      double missing = *scatter_.density * *places_.area();
      count_ = 0;
      for (std::size_t known = 0; !bodies_.empty() && drawing_.problems.size() == before;) {
        const double area = covered(bodies_[are_alike ? 0 : known]);
        // The nearest count: the last may be left out.
        if (missing < 0.5 * area || count_ == kMost) break;
        missing -= area;
        ++count_;
        if (!are_alike && ++known == bodies_.size()) {
          const auto more = bodies_of_things(known, known);
          bodies_.insert(bodies_.end(), more.begin(), more.end());
        }
      }
    }
    if (drawing_.problems.size() > before) {
      return false;
    }
    if (count_ == 0) {
      return refuse("has a density of " + number_text(*scatter_.density) +
                    ", which is less than one thing; raise it, or give a count");
    }
    if (places_.most() && count_ > *places_.most()) {
      return refuse("has " + base::counted(count_, "thing") + ", but its grid has " +
                    base::counted(*places_.most(), "cell") + "; give it more columns or rows");
    }
    return true;
  }

  bool place(std::size_t i) {
    const Body& body = bodies_[bodies_.size() == 1 ? 0 : i];
    const std::string number = std::to_string(i + 1);
    Random random = drawing_.stream(scatter_.id + "/" + number);
    const std::string own = thing_.value("heading_deg");
    for (int attempt = 0;; ++attempt) {
      const auto spot = places_.next(i, attempt, random);
      if (!spot) {
        return no_room(i, attempt);
      }
      const auto heading = places_.heading_deg(*spot, random);
      const Body there = moved(body, spot->x, spot->y, heading ? *heading : own_heading_deg());
      if (is_kept_clear(there) || !occupied_.has_room_for(there, scatter_.gap)) {
        continue;
      }
      occupied_.add(there);
      places_.take();
      add(i, *spot, heading);
      return true;
    }
  }

  double own_heading_deg() const {
    const std::string text = thing_.value("heading_deg");
    return text.empty() ? 0.0 : std::strtod(text.c_str(), nullptr);
  }

  bool is_kept_clear(const Body& body) const {
    return std::any_of(scatter_.clear.begin(), scatter_.clear.end(), [&](const auto& disc) {
      Footprint kept;
      kept.x = disc.x;
      kept.y = disc.y;
      kept.half_length = kept.half_width = disc.radius;
      kept.top = 1e6;
      kept.round = true;
      return std::any_of(body.begin(), body.end(),
                         [&](const Footprint& each) { return world::overlap(each, kept); });
    });
  }

  bool no_room(std::size_t placed, int tries) {
    return refuse("has no room for the " + std::string(placed == 0 ? "first" : "next") +
                  " of its " + base::counted(count_, "thing") + (placed == 0 ? "" : " after ") +
                  (placed == 0 ? "" : std::to_string(placed)) + ": " +
                  base::counted(static_cast<std::uint64_t>(tries), "place was", "places were") +
                  " tried, with a gap of " + number_text(scatter_.gap) +
                  " m to everything else; lower the " + (scatter_.density ? "density" : "count") +
                  " or the gap, or give them more area");
  }

  void add(std::size_t i, const Spot& spot, const std::optional<double>& heading) {
    Element made = thing(i);
    const Location& where = scatter_.location;
    made.where = where;
    const std::string name = thing_.find("id") ? thing_.value("id") : scatter_.id;
    made.set("id", count_ == 1 ? name : name + std::to_string(i + 1), where);
    made.set("x", number_text(spot.x), where);
    made.set("y", number_text(spot.y), where);
    if (heading && thing_.name != "charger") {
      made.set("heading_deg", number_text(*heading), where);
    }
    drawing_.add(list_, std::move(made));
  }

  Drawing& drawing_;
  const Scatter& scatter_;
  const Element& thing_;
  const char* const list_;
  Occupied& occupied_;
  Places places_;
  std::size_t count_ = 0;
  std::vector<Body> bodies_;
};

}  // namespace

void draw_scatter(Drawing& drawing, const Scatter& scatter, Occupied& occupied) {
  if (scatter.things.size() != 1) {
    drawing.refuse(
        scatter.location, scatter.id,
        (scatter.things.empty() ? "does not say what it scatters" : "scatters several things") +
            std::string("; expected one of <static_box> or another obstacle, <resource>, "
                        "<charger> and <robot>"));
    return;
  }
  const Element& thing = *scatter.things.front();
  // An edit may have removed all of them; that a template could not be read is a problem already.
  if (!thing.removed_by && !thing.incomplete) {
    Scattering(drawing, scatter, thing, occupied).draw();
  }
}

}  // namespace elsie::layouts
