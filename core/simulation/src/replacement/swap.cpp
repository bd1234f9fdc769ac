#include "replacement/swap.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <variant>

#include "elsie/plugin/declared_element.h"
#include "elsie/world/files.h"

namespace elsie::simulation {
namespace {

using plugin::find_declared;

/// Removes parameters and elements that are not declared; calls `removed` for each.
template <class Elements>
void strip(const plugin::DeclaredElement& declared, const std::string& whose,
           std::map<std::string, ParameterValue>& parameters, Elements& elements,
           const std::function<void(const std::string&)>& removed) {
  std::erase_if(parameters, [&](const auto& parameter) {
    const bool gone = !find_declared(declared.parameters(), parameter.first);
    if (gone) removed("the parameter '" + parameter.first + "'" + whose);
    return gone;
  });
  std::erase_if(elements, [&](auto& given) {
    const auto known = declared.inside(given.element);
    if (known) {
      strip(*known, " of <" + given.element + ">", given.parameters, given.elements, removed);
    } else {
      removed("the element <" + given.element + ">");
    }
    return !known;
  });
}

template <class Elements>
void require(const plugin::DeclaredElement& declared, const std::string& whose,
             const std::map<std::string, ParameterValue>& given, const Elements& elements) {
  for (const ParameterDeclaration& parameter : declared.parameters()) {
    if (parameter.facts.required && !given.contains(parameter.name)) {
      throw std::invalid_argument("it needs the parameter '" + parameter.name + "'" + whose +
                                  " now, which the world does not give; give it there, or give it "
                                  "a default in the plugin");
    }
  }
  for (const auto& each : elements) {
    require(*declared.inside(each.element), " of <" + each.element + ">", each.parameters,
            each.elements);
  }
}

/// The default files of parameters that are not given, with their paths. They are searched for as
/// when the world was read.
std::map<std::string, std::string> default_files(const Declaration& declaration,
                                                 const std::map<std::string, ParameterValue>& given,
                                                 const world::Files& files) {
  std::map<std::string, std::string> found;
  for (const ParameterDeclaration& parameter : declaration.parameters) {
    const auto* const name = std::get_if<std::string>(&parameter.default_value);
    if (parameter.type != ParameterType::file || given.contains(parameter.name) || name->empty()) {
      continue;
    }
    const auto file = files.find_data(*name);
    if (!file) {
      throw std::invalid_argument("it takes '" + *name + "' for its parameter '" + parameter.name +
                                  "', but there is no such file in the data directories");
    }
    found[parameter.name] = world::Files::absolute(*file);
  }
  return found;
}

/// Removes what is not declared, and adds default files; calls `removed` for each thing that goes.
void adapt(world::PluginUse& use, const Declaration& declaration, const world::Files& files,
           const std::function<void(const std::string&)>& removed) {
  strip(plugin::DeclaredElement(declaration), "", use.parameters, use.elements, removed);
  std::erase_if(use.file_names,
                [&](const auto& named) { return !use.parameters.contains(named.first); });
  for (const auto& [name, file] : default_files(declaration, use.parameters, files)) {
    use.parameters[name] = file;
    use.file_names[name] = {file, ""};
  }
}

}  // namespace

world::World Swap::adapted(world::World world) const {
  const world::Files files("", data_directories_);
  const auto fit = [&](PluginKind kind, world::PluginUse& use) {
    if (const Declaration* const fresh = host_.find(kind, use.plugin)) {
      adapt(use, *fresh, files, [](const std::string&) {});
    }
  };
  const std::function<void(world::Coordination&)> fit_all = [&](world::Coordination& all) {
    for (world::BehaviorUse& use : all.behaviors) {
      fit(PluginKind::behavior, use);
      for (world::Coordination& inside : use.inside) fit_all(inside);
    }
    if (all.coordinator) fit(PluginKind::coordinator, *all.coordinator);
  };
  for (world::Robot& robot : world.robots) {
    for (world::MountedUse& use : robot.sensors) fit(PluginKind::sensor, use);
    for (world::MountedUse& use : robot.actuators) fit(PluginKind::actuator, use);
    fit_all(robot);
    if (robot.drive) fit(PluginKind::drive, *robot.drive);
    if (robot.localisation) fit(PluginKind::localisation, *robot.localisation);
  }
  return world;
}

bool Swap::exchange(PluginObject& object, const std::string& path) {
  const Declaration* const fresh = host_.find(object.kind, object.use->plugin);
  if (!fresh) refuse(path, host_.explain_missing(object.kind, object.use->plugin));
  if (static_cast<bool>(fresh->hold) != static_cast<bool>(object.declaration->hold)) {
    refuse(path,
           std::string(fresh->hold ? "it holds behaviours now" : "it no longer holds behaviours") +
               "; replace its element by an edit, or start a new run");
  }
  if (fresh->only_acts != object.declaration->only_acts) {
    refuse(path, std::string(fresh->only_acts ? "it only acts now, and moved the robot before"
                                              : "it moves the robot now, and only acted before") +
                     "; replace its element by an edit, or start a new run");
  }
  if (fresh == object.declaration) return false;
  exchanged_.push_back({&object, object.held.get()});
  replacement_.objects.push_back({robot_, path, object.use->plugin, false});
  run(object, path, [&] {
    undo_.keep(object.declaration, object.own_extras().heap);
    object.own_extras().heap = {};
    object.declaration = fresh;
    fit(object, path);
    const auto old =
        std::make_shared<plugin::Object<Component>>(object.made(host_, object.setup()));
    object.held.swap(*old);
    undo_.add([&object, old] { object.held.swap(*old); });
  });
  return true;
}

/// Adapts the parameters to the new declaration.
void Swap::fit(PluginObject& object, const std::string& path) {
  const Declaration& declaration = *object.declaration;
  // The simulation owns the robot; all others only read it.
  auto& use = const_cast<world::PluginUse&>(*object.use);
  undo_.keep(use.parameters, use.elements, use.file_names);
  adapt(use, declaration, world::Files("", data_directories_), [&](const std::string& what) {
    replacement_.notes.push_back("robot '" + robot_ + "', " + path + ": " + what +
                                 " is no longer declared by " + declaration.name +
                                 " and was left out");
  });
  require(plugin::DeclaredElement(declaration), "", use.parameters, use.elements);
}

void Swap::hand_over(const Example& example) {
  const auto each = [&](auto action) {
    for (std::size_t i = first_; i < exchanged_.size(); ++i) {
      Replacement::Object& said = replacement_.objects[i];
      PluginObject& object = *exchanged_[i].object;
      run(object, said.path, [&] { action(object, *exchanged_[i].before, said); });
    }
  };
  each([&](PluginObject& object, auto&, auto&) { object.equip(*object.held, example); });
  each([&](PluginObject& object, Component& before, Replacement::Object& said) {
    undo_.keep(object.random);
    const Random there = object.random;
    object.random = Random(seed_, "robot[" + robot_ + "]/" + said.path);
    object.held->reset(object.random);
    object.random = there;  // the stream continues, whatever reset() drew
    auto* const now = dynamic_cast<Remembers*>(object.held.get());
    if (now && dynamic_cast<Remembers*>(&before)) {
      Memory memory = memory_of(before);
      now->remember(memory);
      said.remembers = true;
    }
  });
  for (const auto& [object, path] : staying_) {
    Memory memory;
    run(*object, path, [&, object = object] { memory = memory_of(*object->held); });
    const auto equip = [this, object = object, path = path, memory, example] {
      run(*object, path, [&] { object->equip_again({}, memory, example); });
    };
    again_.add(equip);
    equip();
  }
}

Replacement Swap::settle() {
  undo_.settle();
  again_.settle();
  return std::move(replacement_);
}

}  // namespace elsie::simulation
