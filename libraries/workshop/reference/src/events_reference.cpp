// The events of the simulator and of plugins, as a part of a page.
#include "elsie/api/simulator_events.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/reference/reference.h"

#include "reference_table.h"

namespace elsie::reference {

std::string events_reference(const plugin::Host& host) {
  std::string text =
      "The simulator raises:\n\n"
      "| event | raised when | detail | perceived by behaviours |\n|---|---|---|---|\n";
  for (const events::Facts& event : events::of_simulator()) {
    text += table_row({"`" + std::string(event.name) + "`", std::string(event.meaning),
                       std::string(event.detail.empty() ? "none" : event.detail),
                       event.is_perceived ? "yes" : "no"});
  }
  text += "\nPlugins raise, without a detail:\n\n| event | plugin | raised when |\n|---|---|---|\n";
  for (const PluginKind kind : plugin::kPluginKinds) {
    for (const Declaration* declaration : host.all(kind)) {
      for (const EventDeclaration& event : declaration->events) {
        text += table_row({"`" + event.name + "`", declaration->name, event.meaning});
      }
    }
  }
  return text;
}

}  // namespace elsie::reference
