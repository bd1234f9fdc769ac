// Which events a world raises, and whether those that its plugins name are among them.
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "elsie/api/simulator_events.h"
#include "elsie/base/near_name.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/host.h"

#include "reading.h"

namespace elsie::world {
namespace {

void list_events(PluginKind kind, const PluginUse& use, const plugin::Host& host,
                 std::vector<std::string>& raised) {
  if (const Declaration* declaration = host.find(kind, use.plugin)) {
    for (const EventDeclaration& event : declaration->events) raised.push_back(event.name);
  }
}

}  // namespace

void list_events(const std::vector<PluginUse>& rules, const plugin::Host& host,
                 std::vector<std::string>& raised) {
  for (const PluginUse& rule : rules) list_events(PluginKind::rule, rule, host, raised);
}

void list_events(const Coordination& coordination, const plugin::Host& host,
                 std::vector<std::string>& raised) {
  for (const BehaviorUse& use : coordination.behaviors) {
    list_events(PluginKind::behavior, use, host, raised);
    for (const Coordination& inside : use.inside) list_events(inside, host, raised);
  }
}

std::vector<std::string> simulator_events() {
  std::vector<std::string> names;
  for (const events::Facts& event : events::of_simulator()) {
    if (event.is_perceived) names.emplace_back(event.name);
  }
  return names;
}

void require_event(const std::string& what, const std::string& event,
                   std::vector<std::string> raised, const std::string& whose, const Location& where,
                   Problems& problems) {
  if (std::find(raised.begin(), raised.end(), event) != raised.end()) return;
  std::sort(raised.begin(), raised.end());
  raised.erase(std::unique(raised.begin(), raised.end()), raised.end());
  problems.add(where, what + " '" + event +
                          "', which neither the simulator nor a rule nor a behaviour of " + whose +
                          " raises" + base::near_or_all(event, raised, "there are"));
}

void check_named_events(const PluginUse& use, const Declaration& declaration,
                        const std::vector<std::string>& raised, const std::string& whose,
                        Problems& problems) {
  const auto check = [&](const std::map<std::string, ParameterValue>& given,
                         const std::vector<ParameterDeclaration>& declared, const std::string& name,
                         const Location& where) {
    const auto set = given.find(name);
    const auto* const parameter = plugin::find_declared(declared, name);
    if (!parameter) return;  // another element of that name has it
    const auto& event =
        std::get<std::string>(set == given.end() ? parameter->default_value : set->second);
    if (event.empty()) return;
    require_event("'" + use.plugin + "' is for the event", event, raised, whose, where, problems);
  };
  for (const std::string& path : declaration.event_parameters) {
    const std::size_t slash = path.find('/');
    if (slash == std::string::npos) {
      check(use.parameters, declaration.parameters, path, use.location);
      continue;
    }
    const std::string name = path.substr(0, slash);
    const std::function<void(const plugin::DeclaredElement&, const std::vector<ElementUse>&)>
        check_all = [&](const plugin::DeclaredElement& around, const auto& uses) {
          for (const ElementUse& each : uses) {
            const auto declared = around.inside(each.element);
            if (each.element == name) {
              check(each.parameters, declared->parameters(), path.substr(slash + 1), each.location);
            }
            check_all(*declared, each.elements);
          }
        };
    check_all(plugin::DeclaredElement(declaration), use.elements);
  }
}

void check_rules(const Reading& reading, const plugin::Host& host, Problems& problems) {
  if (!reading.incomplete_robots.empty()) return;  // what they raise is not known
  const World& world = reading.world;
  std::vector<std::string> raised;
  for (const PluginUse& rule : world.rules) {
    const Declaration* const declaration = host.find(PluginKind::rule, rule.plugin);
    if (!declaration || declaration->event_parameters.empty() || reading.has_flaw(rule.location)) {
      continue;
    }
    if (raised.empty()) {
      // A rule sees also those that robots do not perceive.
      for (const events::Facts& event : events::of_simulator()) raised.emplace_back(event.name);
      list_events(world.rules, host, raised);
      for (const Robot& robot : world.robots) list_events(robot, host, raised);
    }
    check_named_events(rule, *declaration, raised, "this world", problems);
  }
}

}  // namespace elsie::world
