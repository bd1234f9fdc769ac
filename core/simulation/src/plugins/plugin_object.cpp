#include "plugins/plugin_object.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "elsie/plugin/parameters.h"

namespace elsie::simulation {

Setup as_described(const world::PluginUse& use) {
  return {use.parameters, world::values_of(use.elements)};
}

Memory memory_of(Component& object) {
  Memory memory;
  if (auto* const remembers = dynamic_cast<Remembers*>(&object)) {
    remembers->remember(memory);
  }
  memory.begin_recall();
  return memory;
}

void PluginObject::make(const plugin::Host& host, std::vector<base::Problem>& problems) {
  held = blaming(*use, problems, [&] {
    if (!declaration) {
      throw std::invalid_argument("no such plugin was found");
    }
    return made(host, as_described(*use));
  });
}

plugin::Object<Component> PluginObject::made(const plugin::Host& host, const Setup& setup) {
  plugin::Object<Component> object = create(host);
  if (declaration->hold) {
    declaration->hold(*object, *inside_of_it());
  }
  plugin::apply_parameters(*declaration, *object, setup.parameters, setup.elements);
  return object;
}

Setup PluginObject::completed(Setup setup, const Setup& now) const {
  for (const ParameterDeclaration& parameter : declaration->parameters) {
    if (now.parameters.contains(parameter.name)) {
      setup.parameters.try_emplace(parameter.name, parameter.default_value);
    }
  }
  return setup;
}

void PluginObject::set(const Setup& setup, const Example& example) {
  apply(*held, setup, example);
  if (extras().camera) own_extras().camera = camera_of(*held);
}

std::optional<Camera> PluginObject::try_out(const Setup& setup, const Example& example) const {
  const std::unique_ptr<Component> object = declaration->create();
  plugin::hold_nothing(*declaration, *object);
  apply(*object, setup, example);
  return camera_of(*object);
}

void PluginObject::apply(Component& object, const Setup& setup, const Example& example) const {
  plugin::apply_parameters(*declaration, object, setup.parameters, setup.elements);
  equip(object, example);
}

void PluginObject::equip_again(const std::optional<Setup>& setup, Memory memory,
                               const Example& example) {
  if (setup) plugin::apply_parameters(*declaration, *held, setup->parameters, setup->elements);
  equip(*held, example);
  if (auto* const remembers = dynamic_cast<Remembers*>(held.get())) remembers->remember(memory);
}

void PluginObject::reset(std::uint64_t seed, const std::string& path) {
  random = Random(seed, path);
  if (extras_) {
    extras_->picture.reset();
    extras_->heap = {};
  }
  forget();
  held->reset(random);
  is_new = false;
}

void list_published(const PluginObject& object, const std::string& within, Guard& guard,
                    const VisitPublished& visit) {
  if (object.declaration->published.empty()) return;
  const std::string path = within + object.use->id;
  for (const PublishedNumber& number : object.declaration->published) {
    const double value = guard.look(*object.use, [&] { return number.get(*object.held); });
    visit({path, number, std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN()});
  }
}

void add_sketch(const PluginObject& object, const std::string& within, const Frame& frame,
                Guard& guard, std::vector<PluginSketch>& sketches) {
  Sketch sketch(frame);
  guard.look(*object.use, [&] { object.held->sketch(sketch); });
  if (!sketch.empty()) {
    sketches.push_back({within + object.use->id, object.kind, std::move(sketch)});
  }
}

void Statements::ask(const PluginObject& object, const std::string& path, Guard& guard) {
  ask_notes(object, guard);
  ask_curves(object, path, guard);
}

void Statements::ask_notes(const PluginObject& object, Guard& guard) {
  const world::PluginUse& use = *object.use;
  for (std::string& note : guard.run(use, [&] { return object.held->notes(); })) {
    notes.push_back({guard.robot(), use.id, std::move(note)});
  }
}

void Statements::ask_curves(const PluginObject& object, const std::string& path, Guard& guard) {
  const world::PluginUse& use = *object.use;
  const auto has = [&](std::size_t from, const std::string& of, const std::string* name) {
    return std::any_of(curves.begin() + static_cast<std::ptrdiff_t>(from), curves.end(),
                       [&](const LearningCurve& other) {
                         return other.robot == guard.robot() && other.plugin == of &&
                                (!name || other.curve.name == *name);
                       });
  };
  // A behaviour and a coordinator may have the same id.
  std::string called = path + use.id;
  for (int number = 2; has(0, called, nullptr); ++number) {
    called = path + use.id + "_" + std::to_string(number);
  }
  const std::size_t first = curves.size();
  for (Curve& curve : guard.run(use, [&] { return object.held->curves(); })) {
    for (const Curve::Point& point : curve.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        guard.fail(use, "its curve '" + curve.name + "' has a point that is not finite");
      }
    }
    if (has(first, called, &curve.name)) {
      guard.fail(use, "two of its curves have the name '" + curve.name + "'");
    }
    curves.push_back({guard.robot(), called, std::move(curve)});
  }
}

}  // namespace elsie::simulation
