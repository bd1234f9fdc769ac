// The declaration of a plugin. Reading XML, checking, the schema, `elsie describe`, the reference
// pages and forms all use this one declaration. A plugin makes it of items: declaration_items.h.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/message.h"
#include "elsie/api/reading.h"

namespace elsie {

class Coordination;

enum class PluginKind {
  sensor,
  behavior,
  coordinator,
  measure,
  drive,
  localisation,
  actuator,
  rule
};

/// A parameter that names a data file. A path in a world file is resolved against the folder of
/// that file, then against the data directories; the member holds the resolved path.
struct FilePath {
  std::string path;
};

enum class ParameterType { real, integer, boolean, text, file, reals };

/// A value of any parameter type; `text` and `file` are both held as a string.
using ParameterValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

/// Facts about a parameter besides its name; the order matters for designated initialisers.
struct ParameterFacts {
  std::string unit{};                                       // "rad/s"; "" for a pure number
  double min = -std::numeric_limits<double>::infinity();    // smallest allowed value
  double above = -std::numeric_limits<double>::infinity();  // the value must be greater than this
  double max = std::numeric_limits<double>::infinity();     // largest allowed value
  std::vector<std::string> choices{};                       // of a text: the only allowed values
  std::string meaning{};                                    // one line
  bool required = false;                                    // a world file must give it
  bool live = true;  // may change during a run; false: its value is only used before a run
};

/// A parameter bound to a member of the plugin's class; type and default come from the member.
struct ParameterDeclaration {
  std::string name;
  ParameterType type = ParameterType::real;
  ParameterFacts facts;
  ParameterValue default_value;
  /// Writes the member. `value` holds the alternative that belongs to `type`.
  std::function<void(Component&, const ParameterValue& value)> set;
  /// Reads the member.
  std::function<ParameterValue(const Component&)> get;
  // The numbers that the member's type can hold, whatever `facts` allow.
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
};

/// One element nested in a plugin's element, as a world file gives it. Missing parameters keep
/// their defaults.
struct ElementValue {
  std::string element;  // its name
  std::map<std::string, ParameterValue> parameters;
  std::vector<ElementValue> elements{};  // inside it

  friend bool operator==(const ElementValue&, const ElementValue&) = default;
};

/// An element that may stand inside a plugin's element, any number of times: a link, a candidate, a
/// step of a pipeline. Elements of one list keep the order of the file, whatever their names.
struct ElementDeclaration {
  std::string name;
  std::string meaning;
  std::vector<ParameterDeclaration> parameters;  // `set` and `get` are empty
  std::vector<ElementDeclaration> elements{};    // that may stand inside it
  bool nests = false;       // those of its own list may stand inside it, too, to any depth
  std::size_t list = 0;     // which of the lists of what holds it
  bool is_of_kind = false;  // every plugin of this kind has it: <noise>, <failure>
  // Of a plugin's own elements; empty for those inside them.
  /// Empties the list: elements in a file replace the default elements.
  std::function<void(Component&)> clear;
  std::function<void(Component&, const ElementValue&)> append;
};

/// An event that a plugin may raise.
struct EventDeclaration {
  std::string name;
  std::string meaning;
};

/// Facts about a published number besides its name.
struct PublishedFacts {
  std::string unit{};     // "m"; "" for a pure number
  std::string meaning{};  // one line
};

/// A number that a plugin shows: a column and a channel of recordings, a curve in the window.
struct PublishedNumber {
  std::string name;
  PublishedFacts facts;
  /// The number now; NaN: there is none.
  std::function<double(const Component&)> get;
};

/// A kind of message that a plugin hears.
struct HeardDeclaration : ReadingDeclaration {
  std::function<AnyMessage(const FieldVisit& change)> make;  // for tests: `change` sets its numbers
};

struct Declaration {
  PluginKind kind = PluginKind::behavior;
  std::string name;
  std::string version = "1.0";
  std::string description;
  std::vector<ParameterDeclaration> parameters;
  std::vector<ElementDeclaration> elements;
  std::vector<ElementValue> default_elements;  // of the lists, when a file gives none
  /// Gives a behaviour that holds others its Coordination, before configured(). Empty: the plugin
  /// holds none.
  std::function<void(Component&, Coordination&)> hold;
  std::vector<ReadingDeclaration> needs;     // behaviours: a robot without such a sensor is refused
  std::vector<ReadingDeclaration> produces;  // sensors: exactly one
  std::vector<ReadingDeclaration> commands;  // behaviours: a robot without such an actuator, too
  std::vector<ReadingDeclaration> takes;     // actuators: exactly one
  std::vector<HeardDeclaration> hears;       // behaviours and coordinators: see hears()
  bool hears_messages = false;               // actuators: see hears_messages()
  bool only_acts = false;                    // behaviours: see only_acts()
  std::vector<std::string> field_parameters;  // see names_field()
  std::vector<std::string> event_parameters;  // see names_event()
  std::vector<EventDeclaration> events;       // the events that it may raise
  std::vector<std::string> reacts_to;         // names of events
  std::vector<PublishedNumber> published;     // in the order of the declaration
  bool feels_contacts = false;                // sensors: see feels_contacts()
  bool updates_all = false;                   // sensors: those of a robot are updated in one call
  /// Its objects may be called from several threads at once, each from one of them.
  bool may_share_threads = true;
  /// Makes an object with every parameter at its default; configured() has not been called yet.
  std::function<std::unique_ptr<Component>()> create;
};

}  // namespace elsie
