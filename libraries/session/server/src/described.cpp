#include "described.h"

#include "elsie/reference/json.h"
#include "elsie/world/warnings.h"

namespace elsie::server {
namespace {

// With a document, also marks elements of templates.
Json element_json(const world::Element& element, const editing::Document* document) {
  Json attributes = Json::object(), children = Json::array();
  bool is_named_here = false;
  for (const world::Attribute& each : element.attributes) {
    attributes[each.name] = each.value;
    is_named_here |= each.completed;
  }
  for (const world::Element& child : element.children) {
    children.push_back(element_json(child, document));
  }
  Json all = {{"name", element.name}, {"line", element.where.line}};
  if (document) {
    const world::Element* written = document->written(element);
    if (!written) {
      all["inherited"] = true;
    } else if (written->find("template")) {
      attributes["template"] = written->value("template");
      all["written"] = element_json(*written, nullptr);
    }
  }
  all["attributes"] = std::move(attributes);
  if (is_named_here) all["named"] = true;
  if (!element.text.empty()) all["text"] = element.text;
  if (!children.empty()) all["children"] = std::move(children);
  return all;
}

}  // namespace

Json problems_json(std::span<const base::Problem> problems) {
  Json all = Json::array();
  for (const base::Problem& each : problems) {
    all.push_back({{"file", each.file}, {"line", each.line}, {"message", each.message}});
  }
  return all;
}

Json problem_json(const std::string& sentence) {
  return problems_json(std::vector<base::Problem>{{"", 0, sentence}});
}

Json warnings_json(const world::World& world) {
  std::vector<base::Problem> warnings;
  for (const world::Warning& each : world::warnings(world)) {
    warnings.push_back({each.location.file, each.location.line, each.message});
  }
  return problems_json(warnings);
}

Json tree_json(const editing::Document& document) {
  return element_json(document.tree(), &document);
}

Json catalog_json(const plugin::Host& host) {
  return {{"elements", reference::world_json()},
          {"plugins", reference::plugins_json(host)["plugins"]},
          {"events", reference::events_json(host)}};
}

}  // namespace elsie::server
