#include "elsie/world/attributes.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "elsie/base/near_name.h"
#include "elsie/plugin/host.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/markup.h"
#include "elsie/world/values.h"

#include "path.h"

namespace elsie::world {

namespace {

// What an element of the tree stands for.
struct Meaning {
  const ElementSpec* spec = nullptr;  // none for an element that a plugin declares
  std::string path;                   // without a "/" at its end
  const Robot* robot = nullptr;
  const PluginUse* use = nullptr;
  std::optional<PluginKind> kind;  // of that plugin
  std::optional<std::size_t> nested;
};

// "robot[r1]/sensor[2]", where the brackets are needed.
std::string joined(const std::string& path, const std::string& step, const std::string& key) {
  return (path.empty() ? "" : path + "/") + step + (key.empty() ? "" : "[" + key + "]");
}

std::string id_of(const ElementSpec& spec, const void* object) {
  const AttributeSpec* id = spec.attribute("id");
  const auto value = id && id->get ? id->get(object) : std::nullopt;
  return value ? std::get<std::string>(*value) : "";
}

// The world as the tree of a file that says everything, so that paths mean here what they mean
// there. Element::object is the place of its meaning in the list.
class Tree {
 public:
  explicit Tree(const World& world) : root_(make(vocabulary(), &world, {})) {}

  Element& root() { return root_; }
  const std::vector<Meaning>& meanings() const { return meanings_; }

 private:
  Element make(const ElementSpec& spec, const void* object, Meaning meaning) {
    meaning.spec = &spec;
    if (spec.plugins) {
      meaning.use = spec.use(object);
      meaning.kind = spec.plugins;
    } else if (spec.name == "robot") {
      meaning.robot = static_cast<const Robot*>(object);
    }
    Element element;
    element.name = meaning.use ? meaning.use->plugin : spec.name;
    element.object = meanings_.size();
    if (const std::string id = id_of(spec, object); !id.empty()) {
      element.set("id", id, {});
    }
    meanings_.push_back(meaning);
    if (spec.plugins) {
      add_declared(element, meaning);
      if (const Coordination* held = spec.inside ? spec.inside(object) : nullptr) {
        add_children(element, coordination_vocabulary(), held, meaning);
      }
    } else {
      add_children(element, spec, object, meaning);
    }
    return element;
  }

  void add_children(Element& element, const ElementSpec& spec, const void* object,
                    const Meaning& meaning) {
    std::size_t number = 0;
    for (const auto& [part, child] : spec.parts_of(object)) {
      Meaning of_child = meaning;
      of_child.use = nullptr;
      of_child.kind.reset();
      if (!child->group) {
        const std::string id = id_of(*child, part.object);
        const bool is_listed = child->at_most > 1;
        of_child.path = joined(meaning.path, spec.group ? spec.members : child->name,
                               !is_listed   ? ""
                               : id.empty() ? std::to_string(++number)
                                            : id);
      }
      element.children.push_back(make(*child, part.object, std::move(of_child)));
    }
  }

  void add_declared(Element& element, const Meaning& meaning) {
    std::map<std::string, std::size_t> count;
    for (std::size_t i = 0; i < meaning.use->elements.size(); ++i) {
      const std::string& name = meaning.use->elements[i].element;
      Meaning of_child = meaning;
      of_child.spec = nullptr;
      of_child.nested = i;
      of_child.path = joined(meaning.path, name, std::to_string(++count[name]));
      Element child;
      child.name = name;
      child.object = meanings_.size();
      meanings_.push_back(std::move(of_child));
      element.children.push_back(std::move(child));
    }
  }

  std::vector<Meaning> meanings_;
  Element root_;
};

}  // namespace

class Attributes::Impl {
 public:
  Impl(const World& world, const plugin::Host& host, std::vector<std::string> data_directories)
      : world_(world), host_(host), files_(world.file, std::move(data_directories)) {}

  std::vector<AttributePlace> find(std::string_view text) {
    const Path path = parse_path(text);
    if (path.attribute.empty()) {
      throw std::invalid_argument(
          "the path leads to an element; expected an attribute at its end, as in "
          "robot[r1]/@max_speed");
    }
    if (path.attribute == "remove") {
      throw std::invalid_argument(
          "an element can be removed before a run only: by --set, or by <set> in an experiment");
    }
    if (!tree_) {
      tree_.emplace(world_);
    }
    std::vector<AttributePlace> places;
    for (const Place& found : find_places(tree_->root(), path)) {
      if (!found.element->object) {  // find_places() made it
        tree_.reset();
        throw std::invalid_argument("there is no such element in this world");
      }
      places.push_back(
          place(*found.element, tree_->meanings()[*found.element->object], path.attribute));
    }
    return places;
  }

  ParameterValue read(const AttributePlace& place, std::string_view text) const {
    Parsed parsed = parse_value(place.field, text);
    if (!parsed.value) {
      throw std::invalid_argument(parsed.problem);
    }
    if (place.field.type != ParameterType::file || (text.empty() && !place.field.required)) {
      return std::move(*parsed.value);
    }
    const Location where{world_.file, 0};
    const auto file = files_.find(std::string(text), where);
    if (!file) {
      throw std::invalid_argument(files_.why_not(where, place.field.name, std::string(text)));
    }
    return Files::absolute(*file);
  }

 private:
  AttributePlace place(const Element& element, const Meaning& meaning,
                       const std::string& name) const {
    AttributePlace place;
    place.path = joined(meaning.path, "@" + name, "");
    place.element = element.name;
    place.robot = meaning.robot;
    place.use = meaning.use;
    place.nested = meaning.nested;
    bool found = false;
    std::vector<std::string> names;
    const auto add = [&](const Field& field) {
      names.push_back(field.name);
      if (field.is_live()) {
        place.live.push_back(field.name);
      }
      if (!found && field.name == name) {
        found = true;
        place.field = field;
      }
    };
    for (const ParameterDeclaration& parameter : parameters(meaning)) {
      Field field = field_of(parameter);
      if (meaning.kind == PluginKind::measure) {
        field.change = nullptr;
      }
      add(field);
    }
    if (meaning.spec) {
      for (const AttributeSpec& attribute : meaning.spec->attributes) {
        add(attribute);
      }
    }
    if (!found) {
      throw std::invalid_argument("<" + element.name + "> has no attribute '" + name + "'" +
                                  base::near_or_all(name, names, "it may have"));
    }
    return place;
  }

  // Those that the plugin declares for its element, or for one in it.
  std::vector<ParameterDeclaration> parameters(const Meaning& meaning) const {
    const Declaration* plugin =
        meaning.use ? host_.find(*meaning.kind, meaning.use->plugin) : nullptr;
    if (!plugin) {
      return {};
    }
    if (!meaning.nested) {
      return plugin->parameters;
    }
    for (const ElementDeclaration& element : plugin->elements) {
      if (element.name == meaning.use->elements[*meaning.nested].element) {
        return element.parameters;
      }
    }
    return {};
  }

  const World& world_;
  const plugin::Host& host_;
  Files files_;
  std::optional<Tree> tree_;  // once it was needed
};

Attributes::Attributes(const World& world, const plugin::Host& host,
                       std::vector<std::string> data_directories)
    : impl_(std::make_unique<Impl>(world, host, std::move(data_directories))) {}
Attributes::Attributes(Attributes&&) noexcept = default;
Attributes& Attributes::operator=(Attributes&&) noexcept = default;
Attributes::~Attributes() = default;

std::vector<AttributePlace> Attributes::find(std::string_view path) const {
  return impl_->find(path);
}

ParameterValue Attributes::read(const AttributePlace& place, std::string_view text) const {
  return impl_->read(place, text);
}

std::string text_of(const ParameterValue& value) { return format_value(value); }

}  // namespace elsie::world
