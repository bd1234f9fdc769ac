// The vocabulary of world files: every element and attribute with its type, unit, range, default
// and meaning, and the member that it sets.
//
// Reading, writing, paths, the XML schema, the reference page and forms all use this table.
// Plugins' parameters are described in the same terms (Field), and experiments have a table of
// their own.
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

class LiveRobot;
struct AttributePlace;

/// The version of the vocabulary: the attribute `format` of a file.
inline constexpr int kFormat = 1;

/// The form of a text.
enum class TextForm {
  any,
  id,      // a letter or underscore, then letters, digits, "_", "-" and "."
  colour,  // "#rrggbb"
};

/// The kind of thing in the world that an attribute names.
enum class Reference { none, team, robot, box };

/// What a difference costs in a world that runs, from the least on. Whatever is made anew takes
/// over the state of what stays.
enum class Cost {
  nothing,  // it is taken over
  value,    // it is put in place: Field::change
  object,   // the plugin's object is made anew, and forgets
  body,     // the body of the robot is made anew, and with it the physics engine
  engine,   // the engine is
};

/// The value of an attribute: its type, range and default.
struct Field {
  std::string name;
  ParameterType type = ParameterType::real;
  ParameterFacts facts;
  /// None: the member is set only if the file has the attribute.
  std::optional<ParameterValue> default_value;
  // The range of the member's type.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  TextForm form = TextForm::any;
  Reference refers_to = Reference::none;
  bool required = false;
  Cost cost = Cost::nothing;
  /// What puts a change of it in place while a run goes on (Simulation::change()). None: what has
  /// the attribute is made anew.
  void (*change)(LiveRobot&, const AttributePlace&, const ParameterValue&) = nullptr;
  bool is_live() const { return change != nullptr; }
};

/// A plugin's parameter in the same terms.
Field field_of(const ParameterDeclaration& parameter);

/// An attribute of the core's vocabulary, bound to a member of its element's object.
struct AttributeSpec : Field {
  std::function<void(void* object, const ParameterValue& value)> set;
  std::function<std::optional<ParameterValue>(const void* object)> get;
};

/// An object that an element describes, and its place in a list.
struct DescribedObject {
  std::size_t order = 0;
  const void* object = nullptr;
};

/// An element of the core's vocabulary or, if `plugins` is set, the use of any plugin of that kind,
/// whose element has the plugin's name and content that the plugin declares.
struct ElementSpec {
  static constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

  std::string name;
  std::string meaning;
  std::vector<AttributeSpec> attributes;
  std::vector<ElementSpec> children;
  std::size_t at_least = 0;  // times in its parent
  std::size_t at_most = 1;
  bool root = false;                  // of a file
  bool group = false;                 // only holds other elements and has no object of its own
  std::string members;                // of a group: the word for its children in paths
  std::optional<PluginKind> plugins;  // then `name` is a word for it, not the element's name
  Cost cost = Cost::nothing;          // of one more or less; of an attribute that says nothing else

  /// Makes the object of a new element under `parent` and sets its location.
  std::function<void*(void* parent, const Location& where)> make;
  /// All such objects of the parent, in order.
  std::function<std::vector<DescribedObject>(const void* parent)> parts;
  /// The base of an object that uses a plugin.
  std::function<const PluginUse*(const void* object)> use;
  /// For behaviours: the coordination that the behaviour holds, if any. coordination_vocabulary()
  /// describes it, so behaviours nest to any depth.
  std::function<Coordination&(void* object)> make_inside;
  std::function<const Coordination*(const void* object)> inside;

  /// If set, the element may hold one element of a world besides its `children`; the object gets
  /// its markup.
  std::function<void(void* object, const std::string& markup)> take;
  /// An attribute that must differ between the elements in it, for the schema.
  struct Unique {
    std::string elements;  // their path: "worlds/world"
    std::string attribute;
  };
  std::vector<Unique> unique;

  const AttributeSpec* attribute(const std::string& attribute_name) const;
  const ElementSpec* child(const std::string& child_name) const;
  /// Its children or, of a behaviour, those of the coordination that it may hold.
  const std::vector<ElementSpec>& below() const;
  /// The parts of an object with the elements that describe them, in the order of the file:
  /// elements of several kinds may describe the objects of one list.
  std::vector<std::pair<DescribedObject, const ElementSpec*>> parts_of(const void* object) const;
};

/// <world> with all its elements.
const ElementSpec& vocabulary();
/// <robot>.
const ElementSpec& robot_spec();
/// <robot_template>: a robot without an id, in a file of its own.
const ElementSpec& template_vocabulary();
/// <behaviors> and <coordinator>, in a robot or in a behaviour that holds others.
const ElementSpec& coordination_vocabulary();

}  // namespace elsie::world
