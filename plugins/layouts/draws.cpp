#include "draws.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/world/tree.h"

namespace elsie::layouts {

namespace {

constexpr int kMostDraws = 10'000;  // of a normal distribution with bounds

/// Rounded to six decimals, so that the last bits of logarithms do not count.
double drawn_value(const world::Draw& draw, Random& random) {
  const auto rounded = [&](double value) {
    return (draw.whole ? std::round(value) : std::round(value * 1e6) / 1e6) + 0.0;
  };
  if (!draw.mean) {
    const double value = draw.whole ? std::floor(random.uniform(*draw.from, *draw.to + 1.0))
                                    : random.uniform(*draw.from, *draw.to);
    return std::clamp(rounded(value), *draw.from, *draw.to);
  }
  double value = *draw.mean;
  for (int i = 0; i < kMostDraws; ++i) {
    value = rounded(random.normal(*draw.mean, *draw.sd));
    if (value >= draw.from.value_or(value) && value <= draw.to.value_or(value)) break;
  }
  return std::clamp(value, draw.from.value_or(value), draw.to.value_or(value));
}

void set(Element& element, const std::string& attribute, const world::Draw& draw, Random& random) {
  element.set(attribute, base::number_text(drawn_value(draw, random)), draw.location);
}

}  // namespace

bool check_draw(Drawing& drawing, const world::Draw& draw, const std::string& layout) {
  const std::string what = "draws '" + draw.path + "' ";
  if (draw.mean.has_value() != draw.sd.has_value() ||
      (!draw.mean && !(draw.from && draw.to))) {
    return drawing.refuse(draw.location, layout,
                          what + "without saying from what; expected from and to, or mean and sd");
  }
  if (draw.from && draw.to && *draw.from > *draw.to) {
    return drawing.refuse(draw.location, layout,
                          what + "from " + base::number_text(*draw.from) + " to " +
                              base::number_text(*draw.to) + "; expected the least value first");
  }
  return true;
}

void draw_in(const Drawing& drawing, const world::Scatter& scatter, Element& thing,
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
  for (const world::Draw& draw : scatter.draws) {
    Random random =
        drawing.stream(scatter.id + "/" + std::to_string(number + 1) + "/" + draw.path);
    try {
      const auto [elements, attribute] = world::elements_at(world, member + "/" + draw.path);
      for (Element* const element : elements) {
        set(*element, attribute, draw, random);
      }
    } catch (const std::invalid_argument& error) {
      drawing.problems.add(draw.location, "path=\"" + draw.path + "\" of <draw>: " + error.what());
    }
  }
  thing = std::move(world.children.front().children.front());
}

void PathDraw::apply(Drawing& drawing, bool is_more_expected) {
  try {
    const auto [elements, attribute] = world::elements_at(drawing.world, draw_.path);
    for (; drawn_ < elements.size(); ++drawn_) {
      set(*elements[drawn_], attribute, draw_, random_);
    }
  } catch (const std::invalid_argument& error) {
    if (!is_more_expected && drawn_ == 0) {
      drawing.problems.add(draw_.location,
                           "path=\"" + draw_.path + "\" of <draw>: " + error.what());
    }
  }
}

}  // namespace elsie::layouts
