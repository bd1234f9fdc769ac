#include "published.h"

#include <cmath>
#include <utility>

#include "messages.h"
#include "schemas.h"

namespace elsie::recording {

using simulation::PublishedValue;

std::string published_schema(const std::string& title, const VisitAllPublished& visit_all) {
  Json plugins = Json::object();
  visit_all([&](const PublishedValue& each) {
    Json& plugin = plugins[std::string(each.path)];
    plugin["type"] = "object";
    const PublishedFacts& facts = each.number.facts;
    Json number{{"type", "number"}};
    if (!facts.unit.empty()) number["unit"] = facts.unit;
    if (!facts.meaning.empty()) number["description"] = facts.meaning;
    plugin["properties"][each.number.name] = std::move(number);
  });
  if (plugins.empty()) return "";
  Json schema = schema_of("elsie.Published");
  schema["title"] = title;
  schema["properties"]["plugins"]["properties"] = std::move(plugins);
  return text_of(schema);
}

std::string numbers_text(const VisitAllPublished& visit_all) {
  Json numbers = Json::array();
  visit_all([&](const PublishedValue& each) {
    numbers.push_back(
        {{"path", each.path}, {"name", each.number.name}, {"unit", each.number.facts.unit}});
  });
  return text_of(numbers);
}

Json published_message(std::uint64_t time_ns, const VisitAllPublished& visit_all) {
  Json plugins = Json::object();
  visit_all([&](const PublishedValue& each) {
    Json& plugin = plugins[std::string(each.path)];
    if (plugin.is_null()) plugin = Json::object();
    if (std::isfinite(each.value)) plugin[each.number.name] = each.value;
  });
  return {{"timestamp", time_json(time_ns)}, {"plugins", std::move(plugins)}};
}

}  // namespace elsie::recording
