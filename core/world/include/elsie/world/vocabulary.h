// The vocabulary of world files: every element and attribute with its type, unit, range, default
// and meaning, and the member that it sets.
//
// The reader, the writer, paths, the XML schema, the reference page and forms all use this table.
// Field also describes the parameters of plugins. Experiments have a table of their own.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/world/description.h"

namespace elsie::world {

/// The version of the vocabulary: the attribute `format` of a file.
inline constexpr int kFormat = 1;

/// The required form of a text.
enum class TextForm {
  any,
  id,      // a letter or underscore, then letters, digits, "_", "-" and "."
  colour,  // "#rrggbb"
};

/// The kind of object that an attribute refers to by its id.
enum class Reference { none, team, robot, obstacle };

/// The cost of a change in a running world, in ascending order. Objects that are created again take
/// over the state of the objects that remain.
enum class Cost {
  nothing,  // the new value is taken over
  value,    // the value is changed in place: Simulation::change()
  object,   // the plugin's object is created again, and loses its memory
  body,     // the body of the robot is created again, and so is the physics engine
  engine,   // the physics engine is created again
};

/// The value of an attribute: its type, range and default.
struct Field {
  std::string name;
  ParameterType type = ParameterType::real;
  ParameterFacts facts;
  /// Empty: the member is set only if the file has the attribute.
  std::optional<ParameterValue> default_value;
  // The range of the member's type.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  TextForm form = TextForm::any;
  Reference refers_to = Reference::none;
  bool required = false;
  Cost cost = Cost::nothing;
  bool is_live() const { return cost == Cost::value; }
  /// Whether an empty text stands for no file, as the default does.
  bool may_be_no_file() const { return default_value == ParameterValue(std::string()); }
};

/// A plugin's parameter as a field.
Field field_of(const ParameterDeclaration& parameter);

/// An attribute of the core's vocabulary, bound to a member of its element's object.
struct AttributeSpec : Field {
  std::function<void(void* object, const ParameterValue& value)> set;
  std::function<std::optional<ParameterValue>(const void* object)> get;
};

/// An object that an element describes, and its index in a list.
struct DescribedObject {
  std::size_t order = 0;
  const void* object = nullptr;
};

/// An element of the core's vocabulary. If `plugins` is set, it stands for the use of any plugin of
/// that kind: the file's element has the name of the plugin and content that the plugin declares.
struct ElementSpec {
  static constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

  std::string name;
  std::string meaning;
  std::vector<AttributeSpec> attributes;
  std::vector<ElementSpec> children;
  std::size_t at_least = 0;  // the least number of them in a parent
  std::size_t at_most = 1;
  bool root = false;                  // of a file
  bool group = false;                 // only holds other elements and has no object of its own
  std::string members;                // of a group: the word for its children in paths
  std::optional<PluginKind> plugins;  // if set, `name` is a word for it, not the element's name
  Cost cost = Cost::nothing;          // of adding or removing one; the default for its attributes

  /// Creates the object of a new element in `parent` and sets its location.
  std::function<void*(void* parent, const Location& where)> make;
  /// Prepares the parent's list for so many more of these objects; may be empty.
  std::function<void(void* parent, std::size_t more)> reserve;
  /// Lists all objects of such elements in the parent, in order.
  std::function<std::vector<DescribedObject>(const void* parent)> parts;
  /// The place of such an object in its file; may be empty.
  std::function<const Location&(const void* object)> location;
  /// For members of lists: appends a copy of an object, by its index in the list of another parent.
  std::function<void(void* parent, const void* from, std::size_t order)> copy;
  /// Copies the whole list, if copies share its objects; else empty.
  std::function<void(void* parent, const void* from)> share;
  /// The PluginUse that is the base of an object that uses a plugin.
  std::function<const PluginUse*(const void* object)> use;
  /// For behaviours: the coordination that the behaviour holds, if any. coordination_vocabulary()
  /// describes it, so behaviours nest to any depth.
  std::function<Coordination&(void* object)> make_inside;
  std::function<const Coordination*(const void* object)> inside;

  /// For groups of goals: describes what such an element holds in place of `children`, so that
  /// these elements nest to any depth.
  const ElementSpec& (*nested)() = nullptr;

  /// If set, the element may hold one element of a world besides its `children`; the object
  /// receives the markup of that element.
  std::function<void(void* object, const std::string& markup)> take;
  /// An attribute whose values must differ between elements inside this one, for the schema.
  struct Unique {
    std::string elements;  // their path: "worlds/world"
    std::string attribute;
  };
  std::vector<Unique> unique;

  const AttributeSpec* attribute(const std::string& attribute_name) const;
  const ElementSpec* child(const std::string& child_name) const;
  /// The elements that an element of this kind holds, unless it is a behaviour.
  const std::vector<ElementSpec>& held() const { return nested ? nested().children : children; }
  /// The same or, for a behaviour, those of the coordination that it may hold.
  const std::vector<ElementSpec>& below() const;
  /// The parts of an object with the elements that describe them, in the order of the file:
  /// elements of several kinds may describe the objects of one list.
  std::vector<std::pair<DescribedObject, const ElementSpec*>> parts_of(const void* object) const;
};

/// The element <world> with all elements inside it.
const ElementSpec& vocabulary();
/// The element <robot>.
const ElementSpec& robot_spec();
/// The element <robot_template>: a robot without an id, in a file of its own.
const ElementSpec& template_vocabulary();
/// The elements <behaviors> and <coordinator>, in a robot or in a behaviour that holds others.
const ElementSpec& coordination_vocabulary();

}  // namespace elsie::world
