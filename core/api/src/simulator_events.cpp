#include "elsie/api/simulator_events.h"

#include <algorithm>
#include <array>

namespace elsie::events {
namespace {

template <class... Simulators>
constexpr auto table(const std::variant<Raised, Simulators...>*) {
  return std::array{Simulators::kFacts...};
}
constexpr auto kTable = table(static_cast<const AnyEvent*>(nullptr));

}  // namespace

std::string Collision::detail() const {
  switch (with) {
    case With::wall:
      return "wall";
    case With::charger:
      return "charger";
    case With::box:
    case With::robot:
      break;
  }
  return id;
}

std::string Changed::detail() const {
  const char* const step = attribute.empty() ? "" : element.empty() ? "@" : "/@";
  return element + step + attribute + "=" + value +
         (rule.empty() ? "" : ", by the rule '" + rule + "'");
}

Changed Changed::of(const std::string& path, std::string value) {
  const std::size_t at = path.rfind('@');
  if (at == std::string::npos) return {path, "", std::move(value)};
  return {path.substr(0, at > 0 ? at - 1 : 0), path.substr(at + 1), std::move(value)};
}

std::string_view name_of(const AnyEvent& event) {
  const auto* const raised = std::get_if<Raised>(&event);
  return raised ? std::string_view(raised->name) : facts_of(event)->name;
}

std::string detail_of(const AnyEvent& event) {
  return std::visit(
      [](const auto& one) -> std::string {
        if constexpr (requires { one.detail(); }) {
          return one.detail();
        } else {
          return "";
        }
      },
      event);
}

const Facts* facts_of(const AnyEvent& event) {
  return event.index() == 0 ? nullptr : &kTable[event.index() - 1];
}

std::span<const Facts> of_simulator() { return kTable; }

const Facts* find(std::string_view name) {
  const auto at = std::find_if(kTable.begin(), kTable.end(),
                               [&](const Facts& facts) { return facts.name == name; });
  return at == kTable.end() ? nullptr : &*at;
}

}  // namespace elsie::events
