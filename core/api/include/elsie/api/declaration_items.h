// The items of which a plugin makes its declaration: parameters, elements, published numbers, what
// it needs, gives and hears. Each adds to the declaration under construction. `Class` is the
// plugin's class.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/declaration.h"
#include "elsie/api/message.h"
#include "elsie/api/reading.h"

namespace elsie {

template <class Class, class Value>
struct ParameterItem {
  std::string name;
  Value Class::*member;
  ParameterFacts facts;
};

/// A parameter `name` bound to a member of type double, float, bool, an integer, std::string,
/// FilePath or std::vector<double>.
template <class Class, class Value>
ParameterItem<Class, Value> parameter(const char* name, Value Class::*member,
                                      ParameterFacts facts = {}) {
  return {name, member, std::move(facts)};
}

template <class Item>
struct NestsItem;

/// `kNests`: it has nests().
template <class Item, bool kNests = false>
struct ElementItem {
  std::string name;
  std::string meaning;
  std::vector<ParameterDeclaration> parameters;
  std::vector<ElementDeclaration> elements;       // of lists inside it
  std::vector<Item> Item::*nested = nullptr;      // elements of its own list inside it
  std::string Item::*name_member = nullptr;       // gets its name
  std::function<Item(const ElementValue&)> make;  // without what is nested
  std::function<ElementValue(const Item&)> tell;
};

/// An element of this struct with these items.
template <class Item, class... Items>
using ElementOf = ElementItem<Item, (std::is_same_v<Items, NestsItem<Item>> || ...)>;

/// An element that stands for one object of the plain struct `Item`; its parameters are bound to
/// members of that struct, like a plugin's to members of its class. Besides parameter(), its items
/// may be elements(), nests() and element_name().
template <class Item, class... Items>
ElementOf<Item, Items...> element(const char* name, const char* meaning, Items... items);

template <class Class, class Value, class... Elements>
struct ElementsItem {
  std::vector<Value> Class::*list;
  std::tuple<Elements...> items;
};

/// A list of nested elements, bound to a member of the plugin's class, or of the struct of an
/// element: a std::vector of the struct that element() describes, or of a std::variant of several
/// such structs.
template <class Class, class Value, class... Items, bool... kNests>
ElementsItem<Class, Value, ElementItem<Items, kNests>...> elements(
    std::vector<Value> Class::*list, ElementItem<Items, kNests>... items) {
  constexpr bool kMayNest = ((!kNests || std::is_same_v<Value, Items>)&&...);
  static_assert(kMayNest, "nests() needs a list of one struct, and this is one of a std::variant");
  return {list, {std::move(items)...}};
}

template <class Item>
struct NestsItem {
  std::vector<Item> Item::*member;
};
/// Of an element: the elements of its own list may stand inside it, too, to any depth. All elements
/// of such a list stand for objects of one struct.
template <class Item>
NestsItem<Item> nests(std::vector<Item> Item::*member) {
  return {member};
}

template <class Item>
struct ElementNameItem {
  std::string Item::*member;
};
/// Of an element: the member gets its name, for a list whose elements of several names stand for
/// objects of one struct.
template <class Item>
ElementNameItem<Item> element_name(std::string Item::*member) {
  return {member};
}

template <class Class>
struct HoldsItem {
  Coordination* Class::*member;
};
/// A behaviour made of behaviours and their coordinator; the member will point to them.
template <class Class>
HoldsItem<Class> holds_behaviors(Coordination* Class::*member) {
  return {member};
}

template <class Class, class Value>
struct PublishesItem {
  const char* name;
  Value Class::*member;
  PublishedFacts facts;
};
/// A number that the plugin shows, read from a member of its class, or from a const member function
/// without arguments, when somebody looks. A number that is not finite stands for none.
template <class Class, class Value>
PublishesItem<Class, Value> publishes(const char* name, Value Class::*member,
                                      PublishedFacts facts = {}) {
  return {name, member, std::move(facts)};
}

/// The behaviour needs these readings: a robot without a sensor that produces them is refused.
template <class Reading>
auto needs() {
  return [](Declaration& declaration) {
    declaration.needs.push_back(ReadingDeclaration::of<Reading>());
  };
}

/// The readings that a sensor produces; ELSIE_SENSOR adds this item.
template <class Reading>
auto produces(bool updates_all = false) {
  return [updates_all](Declaration& declaration) {
    declaration.produces.push_back(ReadingDeclaration::of<Reading>());
    declaration.updates_all = updates_all;
  };
}

/// The behaviour gives such commands: a robot without an actuator that takes them is refused.
template <class Command>
auto commands() {
  return [](Declaration& declaration) {
    declaration.commands.push_back(ReadingDeclaration::of<Command>());
  };
}

/// The commands that an actuator takes; ELSIE_ACTUATOR adds this item.
template <class Command>
auto takes() {
  return [](Declaration& declaration) {
    declaration.takes.push_back(ReadingDeclaration::of<Command>());
  };
}

/// The behaviour or coordinator listens to such messages: tests make them up.
template <class Content>
auto hears() {
  return [](Declaration& declaration) {
    declaration.hears.push_back({ReadingDeclaration::of<Content>(), [](const FieldVisit& change) {
                                   Content content{};
                                   visit_fields(content, change);
                                   return AnyMessage(std::move(content));
                                 }});
  };
}

/// The behaviour never moves the robot: it grips, signals, says. It is asked in every control
/// period, whatever the coordinator, which does not see it; what it answers for motion counts
/// nowhere.
inline auto only_acts() {
  return [](Declaration& declaration) { declaration.only_acts = true; };
}

/// The plugin's objects share data that they change (a cache, a file, a library that is not safe):
/// a simulation with several threads calls them from one thread only, in the order of the robots.
inline auto one_thread() {
  return [](Declaration& declaration) { declaration.may_share_threads = false; };
}

/// An event that the plugin may raise.
inline auto raises(const char* name, const char* meaning) {
  return [=](Declaration& declaration) { declaration.events.push_back({name, meaning}); };
}

/// An event that the behaviour or coordinator reacts to. The plugin is refused on a robot if
/// neither the simulator nor a behaviour of the robot raises the event.
inline auto reacts_to(std::string_view event) {
  return [=](Declaration& declaration) { declaration.reacts_to.emplace_back(event); };
}

/// A text parameter of a sensor or an actuator that names a field of the world, which is refused if
/// it has none of that name. The parameter must not be live.
inline auto names_field(std::string_view parameter) {
  return [=](Declaration& declaration) { declaration.field_parameters.emplace_back(parameter); };
}

/// A text parameter of a behaviour, a coordinator or a rule that names an event, or the parameter
/// of the elements of a name inside it, at any depth: names_event("event/name"). A world is refused
/// if nothing in it raises that: for behaviours and coordinators the simulator, a rule or a
/// behaviour of the robot. Empty: none.
inline auto names_event(std::string_view parameter) {
  return [=](Declaration& declaration) { declaration.event_parameters.emplace_back(parameter); };
}

/// The plugin's own version; the default is "1.0".
inline auto version(const char* version) {
  return [=](Declaration& declaration) { declaration.version = version; };
}

namespace detail {

template <class Value>
constexpr ParameterType type_of() {
  if constexpr (std::is_same_v<Value, bool>) {
    return ParameterType::boolean;
  } else if constexpr (std::is_integral_v<Value>) {
    return ParameterType::integer;
  } else if constexpr (std::is_floating_point_v<Value>) {
    return ParameterType::real;
  } else if constexpr (std::is_same_v<Value, std::string>) {
    return ParameterType::text;
  } else if constexpr (std::is_same_v<Value, FilePath>) {
    return ParameterType::file;
  } else {
    static_assert(
        std::is_same_v<Value, std::vector<double>>,
        "a parameter is a number, bool, std::string, elsie::FilePath or std::vector<double>");
    return ParameterType::reals;
  }
}

/// Sets the limits of a number type that is narrower than the type of the value.
template <class Value>
void limit(ParameterDeclaration& declaration) {
  if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool> &&
                (sizeof(Value) < sizeof(double) || std::is_unsigned_v<Value>)) {
    declaration.lowest = static_cast<double>(std::numeric_limits<Value>::lowest());
    if constexpr (sizeof(Value) < sizeof(double)) {
      declaration.highest = static_cast<double>(std::numeric_limits<Value>::max());
    }
  }
}

template <class Value>
ParameterValue to_value(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return value;
  } else if constexpr (std::is_integral_v<Value>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::is_floating_point_v<Value>) {
    return static_cast<double>(value);
  } else if constexpr (std::is_same_v<Value, FilePath>) {
    return value.path;
  } else {
    return value;
  }
}

template <class Value>
void from_value(const ParameterValue& value, Value& member) {
  if constexpr (std::is_same_v<Value, bool>) {
    member = std::get<bool>(value);
  } else if constexpr (std::is_integral_v<Value>) {
    member = static_cast<Value>(std::get<std::int64_t>(value));
  } else if constexpr (std::is_floating_point_v<Value>) {
    member = static_cast<Value>(std::get<double>(value));
  } else if constexpr (std::is_same_v<Value, FilePath>) {
    member.path = std::get<std::string>(value);
  } else {
    member = std::get<Value>(value);
  }
}

/// The declaration of a parameter without `set` and `get`.
template <class Object, class Class, class Value>
ParameterDeclaration describe(const Object& defaults, const ParameterItem<Class, Value>& item) {
  ParameterDeclaration parameter;
  parameter.name = item.name;
  parameter.type = type_of<Value>();
  parameter.facts = item.facts;
  parameter.default_value = to_value(defaults.*(item.member));
  limit<Value>(parameter);
  return parameter;
}

template <class Plugin, class Class, class Value>
void apply(Declaration& declaration, const Plugin& defaults, ParameterItem<Class, Value> item) {
  static_assert(std::is_base_of_v<Class, Plugin>,
                "a parameter must be a member of the plugin's class");
  const auto member = item.member;
  ParameterDeclaration& parameter = declaration.parameters.emplace_back(describe(defaults, item));
  parameter.set = [member](Component& object, const ParameterValue& value) {
    from_value(value, static_cast<Plugin&>(object).*member);
  };
  parameter.get = [member](const Component& object) {
    return to_value(static_cast<const Plugin&>(object).*member);
  };
}

/// How the elements of a list become objects, and back.
template <class Value, class... Elements>
class ElementList {
 public:
  explicit ElementList(const std::tuple<Elements...>& items) : items_(items) {}

  /// Their declarations, as the list of this number, without `clear` and `append`.
  std::vector<ElementDeclaration> declared(std::size_t number) const {
    std::vector<ElementDeclaration> all;
    each([&](const auto& item) {
      ElementDeclaration& element = all.emplace_back();
      element.name = item.name;
      element.meaning = item.meaning;
      element.parameters = item.parameters;
      element.elements = item.elements;
      element.nests = item.nested != nullptr;
      element.list = number;
    });
    return all;
  }
  /// Appends the object of an element, if it is one of these.
  void append(const ElementValue& value, std::vector<Value>& list) const {
    each([&](const auto& item) {
      if (item.name == value.element) list.emplace_back(made(item, value));
    });
  }
  /// Appends the element that stands for an object.
  void tell(const Value& value, std::vector<ElementValue>& told) const {
    each([&](const auto& item) {
      if (const auto* const own = as(item, value)) told.push_back(told_of(item, *own));
    });
  }

 private:
  template <class Visit>
  void each(const Visit& visit) const {
    std::apply([&](const auto&... item) { (visit(item), ...); }, items_);
  }
  template <class Item, bool kNests>
  Item made(const ElementItem<Item, kNests>& item, const ElementValue& value) const {
    Item object = item.make(value);
    if constexpr (kNests) {
      for (const ElementValue& inner : value.elements) append(inner, object.*item.nested);
    }
    return object;
  }
  template <class Item, bool kNests>
  ElementValue told_of(const ElementItem<Item, kNests>& item, const Item& object) const {
    ElementValue value = item.tell(object);
    if constexpr (kNests) {
      for (const Item& inner : object.*item.nested) tell(inner, value.elements);
    }
    return value;
  }
  /// The object as such an element describes it; null: another one does.
  template <class Item, bool kNests>
  static const Item* as(const ElementItem<Item, kNests>& item, const Value& value) {
    if constexpr (std::is_same_v<Value, Item>) {
      return !item.name_member || value.*item.name_member == item.name ? &value : nullptr;
    } else {
      return std::get_if<Item>(&value);
    }
  }

  std::tuple<Elements...> items_;
};

template <class Plugin, class Class, class Value, class... Elements>
void apply(Declaration& declaration, const Plugin& defaults,
           ElementsItem<Class, Value, Elements...> item) {
  static_assert(std::is_base_of_v<Class, Plugin>,
                "a list of elements must be a member of the plugin's class");
  const auto list = item.list;
  const auto elements = std::make_shared<ElementList<Value, Elements...>>(item.items);
  const std::size_t number =
      declaration.elements.empty() ? 0 : declaration.elements.back().list + 1;
  for (ElementDeclaration& element : elements->declared(number)) {
    element.clear = [list](Component& object) { (static_cast<Plugin&>(object).*list).clear(); };
    element.append = [list, elements](Component& object, const ElementValue& value) {
      elements->append(value, static_cast<Plugin&>(object).*list);
    };
    declaration.elements.push_back(std::move(element));
  }
  for (const Value& value : defaults.*list) elements->tell(value, declaration.default_elements);
}
template <class Plugin, class Class>
void apply(Declaration& declaration, const Plugin&, HoldsItem<Class> item) {
  static_assert(std::is_base_of_v<Class, Plugin>,
                "what holds behaviors must be a member of the plugin's class");
  declaration.hold = [member = item.member](Component& object, Coordination& inside) {
    static_cast<Plugin&>(object).*member = &inside;
  };
}
template <class Plugin, class Class, class Value>
void apply(Declaration& declaration, const Plugin&, PublishesItem<Class, Value> item) {
  static_assert(std::is_base_of_v<Class, Plugin>,
                "a published number must be a member of the plugin's class");
  const auto get = [member = item.member](const Component& object) {
    return static_cast<double>(std::invoke(member, static_cast<const Plugin&>(object)));
  };
  declaration.published.push_back({item.name, std::move(item.facts), get});
}
/// An item that does not depend on the class.
template <class Plugin, std::invocable<Declaration&> Item>
void apply(Declaration& declaration, const Plugin&, const Item& item) {
  item(declaration);
}

/// Adds an item to an element, whose `make` and `tell` are so far those of the items before.
template <class Item, bool kNests, class Value>
void add(ElementItem<Item, kNests>& element, ParameterItem<Item, Value> parameter) {
  element.parameters.push_back(describe(Item{}, parameter));
  element.make = [before = element.make, parameter](const ElementValue& value) {
    Item made = before(value);
    if (const auto given = value.parameters.find(parameter.name); given != value.parameters.end()) {
      from_value(given->second, made.*(parameter.member));
    }
    return made;
  };
  element.tell = [before = element.tell, parameter](const Item& told) {
    ElementValue value = before(told);
    value.parameters.emplace(parameter.name, to_value(told.*(parameter.member)));
    return value;
  };
}
template <class Item, bool kNests, class Value, class... Elements>
void add(ElementItem<Item, kNests>& element, ElementsItem<Item, Value, Elements...> item) {
  const std::size_t number = element.elements.empty() ? 0 : element.elements.back().list + 1;
  const auto elements = std::make_shared<ElementList<Value, Elements...>>(item.items);
  for (ElementDeclaration& inner : elements->declared(number)) {
    element.elements.push_back(std::move(inner));
  }
  element.make = [before = element.make, list = item.list, elements](const ElementValue& value) {
    Item made = before(value);
    std::vector<Value> given;
    for (const ElementValue& inner : value.elements) elements->append(inner, given);
    if (!given.empty()) made.*list = std::move(given);
    return made;
  };
  element.tell = [before = element.tell, list = item.list, elements](const Item& told) {
    ElementValue value = before(told);
    for (const Value& inner : told.*list) elements->tell(inner, value.elements);
    return value;
  };
}
template <class Item>
void add(ElementItem<Item, true>& element, NestsItem<Item> item) {
  element.nested = item.member;
}
template <class Item, bool kNests>
void add(ElementItem<Item, kNests>& element, ElementNameItem<Item> item) {
  element.name_member = item.member;
  element.make = [before = element.make, item](const ElementValue& value) {
    Item made = before(value);
    made.*(item.member) = value.element;
    return made;
  };
}

}  // namespace detail

template <class Item, class... Items>
ElementOf<Item, Items...> element(const char* name, const char* meaning, Items... items) {
  ElementOf<Item, Items...> made;
  made.name = name;
  made.meaning = meaning;
  made.make = [](const ElementValue&) { return Item{}; };
  made.tell = [name = made.name](const Item&) { return ElementValue{name, {}}; };
  (detail::add(made, std::move(items)), ...);
  return made;
}

/// The declaration of a plugin class; the ELSIE_... macros call this.
template <class Plugin, class... Items>
Declaration declare(PluginKind kind, const char* name, const char* description, Items... items) {
  Declaration declaration;
  declaration.kind = kind;
  declaration.name = name;
  declaration.description = description;
  declaration.create = [] { return std::make_unique<Plugin>(); };
  const Plugin defaults;
  (detail::apply(declaration, defaults, std::move(items)), ...);
  if constexpr (requires { Plugin::declare_for_all(declaration); }) {
    Plugin::declare_for_all(declaration);  // what all plugins of this kind have
  }
  return declaration;
}

}  // namespace elsie
