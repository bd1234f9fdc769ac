#include "replacement/swap.h"

#include <algorithm>
#include <stdexcept>
#include <variant>

#include "elsie/api/remember.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/files.h"

namespace elsie::simulation {
namespace {

using plugin::find_declared;

/// Removes what the declaration does not have; calls `removed` for each.
template <class Elements>
void strip(const Declaration& declaration, std::map<std::string, ParameterValue>& parameters,
           Elements& elements, const std::function<void(const std::string&)>& removed) {
  std::erase_if(parameters, [&](const auto& given) {
    const bool gone = !find_declared(declaration.parameters, given.first);
    if (gone) {
      removed("the parameter '" + given.first + "'");
    }
    return gone;
  });
  std::erase_if(elements, [&](auto& given) {
    const ElementDeclaration* const known = find_declared(declaration.elements, given.element);
    if (!known) {
      removed("the element <" + given.element + ">");
      return true;
    }
    std::erase_if(given.parameters, [&](const auto& parameter) {
      const bool gone = !find_declared(known->parameters, parameter.first);
      if (gone) {
        removed("the parameter '" + parameter.first + "' of <" + given.element + ">");
      }
      return gone;
    });
    return false;
  });
}

void require(const std::vector<ParameterDeclaration>& declared,
             const std::map<std::string, ParameterValue>& given, const std::string& whose) {
  for (const ParameterDeclaration& parameter : declared) {
    if (parameter.facts.required && !given.contains(parameter.name)) {
      throw std::invalid_argument("it needs the parameter '" + parameter.name + "'" + whose +
                                  " now, which the world does not give; give it there, or give it "
                                  "a default in the plugin");
    }
  }
}

}  // namespace

Swap::~Swap() {
  while (!undo_.empty()) {
    undo_.back()();
    undo_.pop_back();
  }
}

const Declaration* Swap::checked(PluginKind kind, const world::PluginUse& use,
                                 const std::string& path, const Declaration& before) const {
  const Declaration* const fresh = host_.find(kind, use.plugin);
  if (!fresh) {
    refuse(robot_, path, host_.explain_missing(kind, use.plugin));
  }
  if (static_cast<bool>(fresh->hold) != static_cast<bool>(before.hold)) {
    refuse(robot_, path,
           std::string(fresh->hold ? "it holds behaviours now" : "it no longer holds behaviours") +
               "; replace its element by an edit, or run the world anew");
  }
  return fresh;
}

Setup Swap::setup_for(Exchanged& exchanged) {
  const Declaration& declaration = *exchanged.declaration;
  const auto fitted = [&](Setup setup, const std::function<void(const std::string&)>& removed) {
    strip(declaration, setup.parameters, setup.elements, removed);
    add_default_files(declaration, setup);
    return setup;
  };
  Setup setup = fitted(as_described(*exchanged.use), [&](const std::string& what) {
    notes_.push_back("robot '" + exchanged.robot + "', " + exchanged.path + ": " + what +
                     " is no longer declared by " + declaration.name + " and was left out");
  });
  require(declaration.parameters, setup.parameters, "");
  for (const ElementValue& element : setup.elements) {
    require(find_declared(declaration.elements, element.element)->parameters, element.parameters,
            " of <" + element.element + ">");
  }
  exchanged.described = setup;
  if (tuning_->is_changed(*exchanged.use)) {
    setup = fitted(tuning_->setup(*exchanged.use), [](const std::string&) {});
    exchanged.changed = setup;
  }
  return setup;
}

/// A file that a parameter names by default is looked for as when the world was read.
void Swap::add_default_files(const Declaration& declaration, Setup& setup) const {
  const world::Files files("", data_directories_);
  for (const ParameterDeclaration& parameter : declaration.parameters) {
    const auto* const name = std::get_if<std::string>(&parameter.default_value);
    if (parameter.type != ParameterType::file || setup.parameters.contains(parameter.name) ||
        name->empty()) {
      continue;
    }
    const auto file = files.find_data(*name);
    if (!file) {
      throw std::invalid_argument("it takes '" + *name + "' for its parameter '" + parameter.name +
                                  "', but there is no such file in the data directories");
    }
    setup.parameters[parameter.name] = world::Files::absolute(*file);
  }
}

void Swap::hand_over(std::size_t first) {
  for (std::size_t i = first; i < all_.size(); ++i) {
    Exchanged& exchanged = all_[i];
    run(exchanged, [&] {
      struct Keep {  // the stream goes on where it was, whatever reset() draws
        Random& stream;
        const Random there;
        ~Keep() { stream = there; }
      } const keep{*exchanged.random, *exchanged.random};
      *exchanged.random = Random(seed_, "robot[" + exchanged.robot + "]/" + exchanged.path);
      exchanged.now->reset(*exchanged.random);
    });
    auto* const before = dynamic_cast<Remembers*>(exchanged.before);
    auto* const now = dynamic_cast<Remembers*>(exchanged.now);
    if (before && now) {
      run(exchanged, [&] {
        Memory memory;
        before->remember(memory);
        memory.begin_recall();
        now->remember(memory);
      });
      exchanged.remembers = true;
    }
  }
}

Replacement Swap::result() const {
  Replacement result;
  for (const Exchanged& exchanged : all_) {
    result.objects.push_back(
        {exchanged.robot, exchanged.path, exchanged.use->plugin, exchanged.remembers});
  }
  result.notes = notes_;
  return result;
}

void Swap::settle(const std::function<Tuning&(const std::string& robot)>& tuning_of) {
  for (Exchanged& exchanged : all_) {
    // The world is the simulation's own; everything else only looks at it.
    auto& use = const_cast<world::PluginUse&>(*exchanged.use);
    strip(*exchanged.declaration, use.parameters, use.elements, [](const std::string&) {});
    std::erase_if(use.file_names,
                  [&](const auto& named) { return !use.parameters.contains(named.first); });
    for (const auto& [name, value] : exchanged.described.parameters) {  // files by default are new
      if (use.parameters.try_emplace(name, value).second) {
        use.file_names[name] = {std::get<std::string>(value), ""};
      }
    }
    if (exchanged.changed) {
      tuning_of(exchanged.robot).take_over(use, *std::move(exchanged.changed));
    }
  }
  for (const auto& action : when_settled_) {
    action();
  }
  undo_.clear();  // and with it the old objects
}

}  // namespace elsie::simulation
