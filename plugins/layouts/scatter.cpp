#include "scatter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/world/markup.h"

#include "regions.h"

namespace elsie::layouts {

namespace {

using base::number_text;

constexpr std::size_t kMost = 1'000'000;         // things
constexpr std::size_t kFewest = 16;              // things that are made together
constexpr std::uint64_t kMostTries = 2'000'000;  // places for the things of one <scatter>: seconds
constexpr std::string_view kHeading = "heading_deg";

class Scattering {
 public:
  Scattering(Drawing& drawing, const Scatter& scatter, const Element& thing, PathDraws& draws,
             Occupied& occupied)
      : drawing_(drawing),
        scatter_(scatter),
        thing_(thing),
        list_(list_of(thing.name)),
        draws_(draws),
        are_alike_(draws.empty() && scatter.draws.empty()),
        occupied_(occupied),
        places_(drawing, scatter) {
    const Element* const list = drawing.world.child(list_);
    first_ = list ? list->children.size() : 0;
  }

  void draw() {
    if (!check() || !places_.is_right() || !count_things()) {
      return;
    }
    // Of none at all, one is made to check what it says.
    if (count_ == 0 && !make(1)) return;
    places_.expect(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      if (!place(i)) return;
    }
    forget_from(count_);
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
    if (const auto* given = thing_.find(kHeading); given && scatter_.heading) {
      drawing_.problems.add(given->where, world::in_words(*given, thing_) +
                                              ": <heading> draws it; take one of them out");
      return false;
    }
    if (scatter_.heading && !has_heading(thing_.name)) {
      return drawing_.refuse(scatter_.heading->location, scatter_.id,
                             "has a <heading>, but " + faceless() + " no way; leave it out");
    }
    for (const Draw& draw : scatter_.draws) {
      if (draw.path == "@x" || draw.path == "@y" || draw.path == "@id" ||
          (draw.path == "@heading_deg" && scatter_.heading)) {
        return refuse_draw(draw.location, draw.path.substr(1));
      }
    }
    return true;
  }

  std::string faceless() const {
    return thing_.name == "charger" ? "chargers face" : "a <" + thing_.name + "> faces";
  }

  /// The n-th thing (from 0) without a place.
  Element thing(std::size_t i) const {
    Element made = thing_;
    draw_in(drawing_, scatter_, made, list_, i);
    const std::string name = thing_.find("id") ? thing_.value("id") : scatter_.id;
    made.set("id", count_ == 1 ? name : name + std::to_string(i + 1), scatter_.location);
    return made;
  }

  /// Things that have been added to the world, with or without a place.
  std::span<Element> made() {
    Element* const list = drawing_.world.child(list_);
    return list ? std::span(list->children).subspan(first_) : std::span<Element>();
  }

  void forget_from(std::size_t count) {
    if (made().size() > count) {
      auto& list = drawing_.world.child(list_)->children;
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(first_ + count), list.end());
    }
    bodies_.resize(std::min(bodies_.size(), count));
  }

  /// Adds things to the world until there are `count`, with all their drawn attributes, and finds
  /// their bodies: one for all if they are alike. Returns whether they are valid.
  bool make(std::size_t count) {
    const std::size_t from = made().size(), before = drawing_.problems.size();
    for (std::size_t i = from; i < count; ++i) {
      drawing_.add(list_, thing(i));
    }
    draws_.apply(drawing_);
    std::span<Element> fresh = made().subspan(from);
    if (are_alike_) fresh = fresh.first(bodies_.empty() && !fresh.empty() ? 1 : 0);
    if (fresh.empty()) {
      return true;
    }
    std::vector<Element> things(fresh.begin(), fresh.end());
    if (!std::all_of(things.begin(), things.end(),
                     [&](auto& each) { return has_no_place(each); })) {
      return false;
    }
    Problems problems;
    const auto bodies = bodies_of(drawing_, list_, std::move(things), problems);
    bodies_.insert(bodies_.end(), bodies.begin(), bodies.end());
    const std::vector<base::Problem> found = problems.sorted(drawing_.file);
    // Of things that differ, each may be wrong in the same way.
    drawing_.problems.add(
        std::span(found).first(are_alike_ ? found.size() : std::min<std::size_t>(1, found.size())));
    return drawing_.problems.size() == before;
  }

  /// Whether no <draw> of the world draws what the layout itself decides.
  bool has_no_place(const Element& thing) {
    for (const std::string_view name : {std::string_view("x"), std::string_view("y"), kHeading}) {
      const auto* drawn = thing.find(name);
      if (drawn && (name != kHeading || scatter_.heading)) {
        return refuse_draw(drawn->where, std::string(name));
      }
    }
    return true;
  }
  bool refuse_draw(const Location& where, const std::string& name) {
    return drawing_.refuse(where, scatter_.id,
                           "decides about '" + name + "' of what it scatters, which a <draw> " +
                               "draws as well; leave out this <draw>" +
                               (name == kHeading ? " or <heading>" : ""));
  }

  bool count_things() {
    if (scatter_.density) {
      if (!count_by_density()) return false;
    } else {
      count_ = static_cast<std::size_t>(scatter_.count.value_or(1));
    }
    if (places_.most() && count_ > *places_.most()) {
      return refuse("has " + base::counted(count_, "thing") + ", but its grid has " +
                    base::counted(*places_.most(), "cell") + "; give it more columns or rows");
    }
    return true;
  }

  bool count_by_density() {
    double missing = *scatter_.density * *places_.area();
    std::size_t count = 0;
    while (true) {
      if (!are_alike_ || bodies_.empty()) {
        if (count >= bodies_.size() && !make(std::max(kFewest, 2 * count))) return false;
      }
      const double area = covered(bodies_[are_alike_ ? 0 : count]);
      // The nearest count: the last may be left out.
      if (missing < 0.5 * area) break;
      if (count == kMost) {
        return refuse("has a density of " + number_text(*scatter_.density) +
                      ", which takes more than " + std::to_string(kMost) +
                      " things; lower the density, or scatter larger things");
      }
      missing -= area;
      ++count;
    }
    count_ = count;
    forget_from(count == 1 ? 0 : count);  // a single thing has another name
    return true;
  }

  bool place(std::size_t i) {
    if (i == made().size() && !make(std::min(count_, std::max(kFewest, 2 * i)))) {
      return false;
    }
    Element& thing = made()[i];
    const Body& body = bodies_[are_alike_ ? 0 : i];
    const std::string own_heading = thing.value(kHeading);
    double own_heading_deg = 0.0;  // of ""
    std::from_chars(own_heading.data(), own_heading.data() + own_heading.size(), own_heading_deg);
    Random random = drawing_.stream(scatter_.id + "/" + std::to_string(i + 1));
    for (int attempt = 0;; ++attempt) {
      const auto spot = places_.next(i, attempt, random);
      if (!spot || tried_ == kMostTries) {
        return no_room(i, attempt);
      }
      ++tried_;
      const auto heading = places_.heading_deg(*spot, random);
      const Body there = moved(body, spot->x, spot->y, heading.value_or(own_heading_deg));
      if (is_kept_clear(there) || !occupied_.has_room_for(there, scatter_.gap)) {
        continue;
      }
      occupied_.add(there);
      places_.take();
      const Location& where = scatter_.location;
      thing.where = where;
      thing.set("x", number_text(spot->x), where);
      thing.set("y", number_text(spot->y), where);
      if (heading) thing.set(kHeading, number_text(*heading), where);
      return true;
    }
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
    const bool is_all = tried_ == kMostTries;
    return refuse("has no room for the " + std::string(placed == 0 ? "first" : "next") +
                  " of its " + base::counted(count_, "thing") +
                  (placed == 0 ? "" : " after " + std::to_string(placed)) + ": " +
                  base::counted(is_all ? tried_ : static_cast<std::uint64_t>(tries), "place was",
                                "places were") +
                  " tried" + (is_all ? " for all of them, and no layout tries more" : "") +
                  ", with a gap of " + number_text(scatter_.gap) +
                  " m to everything else; lower the " + (scatter_.density ? "density" : "count") +
                  " or the gap, or give them more area");
  }

  Drawing& drawing_;
  const Scatter& scatter_;
  const Element& thing_;
  const char* const list_;
  PathDraws& draws_;
  const bool are_alike_;
  std::size_t first_ = 0;  // in the list of the world
  Occupied& occupied_;
  Places places_;
  std::size_t count_ = 0;
  std::vector<Body> bodies_;
  std::uint64_t tried_ = 0;
};

}  // namespace

void draw_scatter(Drawing& drawing, const Scatter& scatter, PathDraws& draws, Occupied& occupied) {
  if (scatter.things.size() != 1) {
    drawing.refuse(
        scatter.location, scatter.id,
        (scatter.things.empty() ? "does not say what it scatters" : "scatters several things") +
            std::string("; expected one of <static_box> or another obstacle, <resource>, "
                        "<charger>, <nest>, <lamp>, <disc_patch> or another patch, and <robot>"));
    return;
  }
  const Element& thing = *scatter.things.front();
  // An edit may have removed all of them; that a template could not be read is a problem already.
  if (!thing.removed_by && !thing.incomplete) {
    Scattering(drawing, scatter, thing, draws, occupied).draw();
  }
}

}  // namespace elsie::layouts
