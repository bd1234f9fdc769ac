#include "draws.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/world/tree.h"

namespace elsie::layouts {

namespace {

using base::number_text;

constexpr int kMostDraws = 10'000;  // of a normal distribution with bounds
// If the bounds of a normal distribution were closer than this share of its deviation, too many
// values would be drawn again.
constexpr double kLeastShare = 0.01;

std::optional<double> least_of(const Draw& draw) {
  return draw.from && draw.whole ? std::ceil(*draw.from) : draw.from;
}
std::optional<double> most_of(const Draw& draw) {
  return draw.to && draw.whole ? std::floor(*draw.to) : draw.to;
}

/// Rounded to six decimals, so that the last bits of logarithms do not count.
double drawn_value(const Draw& draw, Random& random) {
  const auto rounded = [&](double value) {
    return (draw.whole ? std::round(value) : std::round(value * 1e6) / 1e6) + 0.0;
  };
  const std::optional<double> least = least_of(draw), most = most_of(draw);
  if (!draw.mean) {
    const double value = draw.whole ? std::floor(random.uniform(*least, *most + 1.0))
                                    : rounded(random.uniform(*least, *most));
    return std::clamp(value, *least, *most);
  }
  double value = *draw.mean;
  for (int i = 0; i < kMostDraws; ++i) {
    value = rounded(random.normal(*draw.mean, *draw.sd));
    if (value >= least.value_or(value) && value <= most.value_or(value)) break;
  }
  return std::clamp(value, least.value_or(value), most.value_or(value));
}

/// A value that the user has set stays.
void set(Element& element, const std::string& attribute, double value, const Location& where) {
  const world::Attribute* const there = element.find(attribute);
  if (!there || !there->where.file.text().starts_with("--set ")) {
    element.set(attribute, number_text(value), where);
  }
}

/// The part of the world that is read before anything is drawn, if the path leads into it; else "".
std::string read_before(const std::string& path) {
  for (const char* name : {"layouts", "layout", "scatter"}) {
    if (path.starts_with(name + std::string("/")) || path.starts_with(name + std::string("["))) {
      return "layouts";
    }
  }
  return path.ends_with("/@template") ? "templates" : "";
}

/// The problem with a distribution; "" if there is none.
std::string mistake(const Draw& draw) {
  if (draw.mean.has_value() != draw.sd.has_value() || (!draw.mean && !(draw.from && draw.to))) {
    return "without a distribution; expected from and to, or mean and sd";
  }
  const std::string bounds = (draw.from ? " from " + number_text(*draw.from) : "") +
                             (draw.to ? " to " + number_text(*draw.to) : "");
  if (draw.from && draw.to && *draw.from > *draw.to) {
    return bounds.substr(1) + "; expected the least value first";
  }
  if (draw.from && draw.to && *least_of(draw) > *most_of(draw)) {
    return "as a whole number" + bounds + ", where there is none; expected a whole number in it";
  }
  if (!draw.mean) {
    return "";
  }
  if (*draw.mean < draw.from.value_or(*draw.mean) || *draw.mean > draw.to.value_or(*draw.mean)) {
    return "with the mean " + number_text(*draw.mean) + " and values" + bounds +
           "; expected a mean among these values";
  }
  if (draw.from && draw.to &&
      *most_of(draw) - *least_of(draw) + (draw.whole ? 1.0 : 0.0) < kLeastShare * *draw.sd) {
    return "with the standard deviation " + number_text(*draw.sd) + " and values" + bounds +
           ", which is less than a hundredth of it; leave out mean and sd, or widen the bounds";
  }
  return "";
}

}  // namespace

bool check_draws(Drawing& drawing, const std::vector<Draw>& draws,
                 const std::optional<std::string>& layout) {
  bool is_right = true;
  std::set<std::string> paths;
  for (const Draw& draw : draws) {
    const std::string before = layout ? "" : read_before(draw.path);
    const std::string problem =
        !paths.insert(draw.path).second ? "a second time; leave out one of the two <draw>s"
        : !before.empty()
            ? "too late: " + before + " are read before anything is drawn; draw another attribute"
            : mistake(draw);
    is_right &= problem.empty() || drawing.refuse(draw.location, layout.value_or(draw.id),
                                                  "draws '" + draw.path + "' " + problem);
  }
  return is_right;
}

void draw_in(const Drawing& drawing, const Scatter& scatter, Element& thing,
             const std::string& list, std::size_t number) {
  if (scatter.draws.empty()) {
    return;
  }
  Element world;
  world.name = "world";
  Element holder;
  holder.name = list;
  holder.children.push_back(std::move(thing));
  world.children.push_back(std::move(holder));
  const std::string member = world.children.front().children.front().name;
  for (const Draw& draw : scatter.draws) {
    Random random = drawing.stream(scatter.id + "/" + std::to_string(number + 1) + "/" + draw.path);
    try {
      const auto [elements, attribute] = world::elements_at(world, member + "/" + draw.path);
      for (Element* const element : elements) {
        set(*element, attribute, drawn_value(draw, random), draw.location);
      }
    } catch (const std::invalid_argument& error) {
      drawing.problems.add(draw.location, "path=\"" + draw.path + "\" of <draw>: " + error.what());
    }
  }
  thing = std::move(world.children.front().children.front());
}

PathDraws::PathDraws(const Drawing& drawing, const std::vector<Draw>& draws) {
  for (const Draw& draw : draws) {
    draws_.push_back({draw, drawing.stream(draw.id), {}, ""});
  }
}

void PathDraws::apply(Drawing& drawing) {
  for (One& one : draws_) {
    try {
      const auto [elements, attribute] = world::elements_at(drawing.world, one.draw.path);
      while (one.values.size() < elements.size()) {
        one.values.push_back(drawn_value(one.draw, one.random));
      }
      for (std::size_t i = 0; i < elements.size(); ++i) {
        set(*elements[i], attribute, one.values[i], one.draw.location);
      }
      one.why_not.clear();
    } catch (const std::invalid_argument& error) {
      if (one.values.empty()) one.why_not = error.what();
    }
  }
}

void PathDraws::finish(Drawing& drawing) {
  apply(drawing);
  for (const One& one : draws_) {
    if (!one.why_not.empty()) {
      drawing.problems.add(one.draw.location,
                           "path=\"" + one.draw.path + "\" of <draw>: " + one.why_not);
    }
  }
}

}  // namespace elsie::layouts
