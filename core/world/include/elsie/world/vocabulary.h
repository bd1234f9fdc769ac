// The vocabulary of world files, said once: every element and attribute with its type, unit, range,
// default and meaning, and the member that it fills.
//
// Reading, writing, paths, the XML schema, the reference page and forms all walk this one table. A
// plugin's parameters are described in the same terms (Field), so that all of those serve plugins
// too; and so are files of another kind (experiments), with a table of their own.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
#include "elsie/world/description.h"

namespace elsie::world {

class LiveRobot;
struct AttributePlace;

/// The version of the vocabulary: the attribute `format` of a file.
inline constexpr int kFormat = 1;

/// What a text may be.
enum class TextForm {
  any,
  id,      // a letter or underscore, then letters, digits, "_", "-" and "."
  colour,  // "#rrggbb"
};

/// What must exist elsewhere in the world under the name that an attribute holds.
enum class Reference { none, team, robot, box };

/// What may stand in an attribute.
struct Field {
  std::string name;
  ParameterType type = ParameterType::real;
  ParameterFacts facts;
  /// None: nothing is set unless the file says so.
  std::optional<ParameterValue> default_value;
  // The numbers that the member's type can hold, whatever `facts` allow.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  TextForm form = TextForm::any;
  Reference refers_to = Reference::none;
  bool required = false;
  /// What a change of it does while a run goes on (Simulation::change()). None: it is settled when
  /// the world is made.
  void (*change)(LiveRobot&, const AttributePlace&, const ParameterValue&) = nullptr;
  bool is_live() const { return change != nullptr; }
};

/// A plugin's parameter in the same terms.
Field field_of(const ParameterDeclaration& parameter);

/// An attribute of the core's own vocabulary, bound to a member of the object that its element
/// describes.
struct AttributeSpec : Field {
  std::function<void(void* object, const ParameterValue& value)> set;
  std::function<std::optional<ParameterValue>(const void* object)> get;
};

/// An object that an element of the file stands for, and its place among those of its parent.
struct Part {
  std::size_t order = 0;
  const void* object = nullptr;
};

/// An element: of the core's vocabulary by its name, or, when `plugins` is set, the use of any
/// plugin of that kind, by the plugin's name. What may stand inside a plugin's element is for the
/// plugin to declare.
struct ElementSpec {
  static constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

  std::string name;
  std::string meaning;
  std::vector<AttributeSpec> attributes;
  std::vector<ElementSpec> children;
  std::size_t at_least = 0;  // times in its parent
  std::size_t at_most = 1;
  bool root = false;                  // of a file
  bool group = false;                 // only holds others and stands for no object of its own
  std::string members;                // of a group: what a path calls any of its children
  std::optional<PluginKind> plugins;  // then `name` is a word for it, not the element's name

  /// The object for a new element under `parent`; where it stands is noted in it.
  std::function<void*(void* parent, const Location& where)> make;
  /// All such objects of the parent, in order.
  std::function<std::vector<Part>(const void* parent)> parts;
  /// The use of a plugin as what all such uses have in common.
  std::function<const PluginUse*(const void* object)> use;
  /// Uses of behaviours only: what the behaviour holds, if it holds others. Described by
  /// coordination_vocabulary(), which in turn has such uses in it: nesting goes to any depth.
  std::function<Coordination&(void* object)> make_inside;
  std::function<const Coordination*(const void* object)> inside;

  /// It may hold one element of a world, whatever that is, besides its own `children`: the object
  /// gets its markup as it stands.
  std::function<void(void* object, const std::string& markup)> take;
  /// What no two of the elements in it have in common, for the schema.
  struct Unique {
    std::string elements;  // the way down to them: "worlds/world"
    std::string attribute;
  };
  std::vector<Unique> unique;

  const AttributeSpec* attribute(const std::string& attribute_name) const;
  /// The child of this name.
  const ElementSpec* child(const std::string& child_name) const;
};

/// <world> with all that it may hold.
const ElementSpec& vocabulary();
/// <robot_template>: a robot without an id, in a file of its own.
const ElementSpec& template_vocabulary();
/// <behaviors> and <coordinator>, as they stand in a robot and in a behaviour that holds others.
const ElementSpec& coordination_vocabulary();
/// <robot>, <sensors>'s children and so on, by the names on the way down from <world>. Throws
/// std::out_of_range.
const ElementSpec& vocabulary_at(const std::vector<std::string>& names);

}  // namespace elsie::world
