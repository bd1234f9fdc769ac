// Builds the table of a vocabulary. An element is bound to the class of its objects, an attribute
// to the member that it sets.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "elsie/api/declaration_items.h"
#include "elsie/world/values.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// Properties of an attribute besides its facts.
struct AttributeExtras {
  TextForm form = TextForm::any;
  Reference refers_to = Reference::none;
  bool required = false;
  std::optional<Cost> cost = std::nullopt;  // none: the cost of its element
};

// The value of a member; none if the member is empty.
template <class Value>
Value held_by(const std::optional<Value>&);
template <class Value>
Value held_by(const Value&);

template <class Object>
class Describe {
 public:
  Describe(std::string name, std::string meaning) {
    spec_.name = std::move(name);
    spec_.meaning = std::move(meaning);
  }

  /// Sets the cost of adding or removing the element, and of changing the attributes that follow.
  Describe&& costs(Cost cost) && {
    spec_.cost = cost;
    return std::move(*this);
  }

  /// An attribute stored in a member of type double, int, std::int64_t, bool, std::string, Colour
  /// or an optional of these. Its default is the member's value in a default-constructed object.
  template <class Owner, class Member>
  Describe&& attribute(const char* name, Member Owner::*member, ParameterFacts facts,
                       AttributeExtras extras = {}) && {
    using Value = decltype(held_by(std::declval<Member>()));
    const auto set = [member](void* object, const ParameterValue& value) {
      Value read{};
      if constexpr (std::is_same_v<Value, Colour>) {
        read = colour_of(std::get<std::string>(value));
      } else {
        detail::from_value(value, read);
      }
      static_cast<Object*>(object)->*member = std::move(read);
    };
    const auto get = [member](const void* object) -> std::optional<ParameterValue> {
      const std::optional<Value> held = static_cast<const Object*>(object)->*member;
      if constexpr (std::is_same_v<Value, Colour>) {
        return held ? std::optional(format_colour(*held)) : std::nullopt;
      } else {
        return held ? std::optional(detail::to_value(*held)) : std::nullopt;
      }
    };
    ParameterType type = ParameterType::text;
    if constexpr (std::is_same_v<Value, Colour>) {
      extras.form = TextForm::colour;
    } else {
      type = detail::type_of<Value>();
    }
    auto&& described = std::move(*this).attribute(name, type, std::move(facts), extras, set, get);
    if constexpr (std::is_same_v<Value, std::int64_t>) {
      AttributeSpec& attribute = spec_.attributes.back();
      attribute.lowest = static_cast<double>(std::numeric_limits<std::int64_t>::min());
      attribute.highest = static_cast<double>(std::numeric_limits<std::int64_t>::max());
    }
    return std::move(described);
  }

  /// An attribute with its own setter and getter.
  Describe&& attribute(const char* name, ParameterType type, ParameterFacts facts,
                       AttributeExtras extras, decltype(AttributeSpec::set) set,
                       decltype(AttributeSpec::get) get) && {
    AttributeSpec attribute;
    attribute.name = name;
    attribute.type = type;
    attribute.facts = std::move(facts);
    attribute.form = extras.form;
    attribute.refers_to = extras.refers_to;
    attribute.required = extras.required;
    attribute.cost = extras.cost.value_or(spec_.cost);
    if (type == ParameterType::integer) {
      attribute.lowest = std::numeric_limits<int>::min();
      attribute.highest = std::numeric_limits<int>::max();
    }
    if (get && !extras.required) {
      const Object defaults{};
      attribute.default_value = get(&defaults);
    }
    attribute.set = std::move(set);
    attribute.get = std::move(get);
    spec_.attributes.push_back(std::move(attribute));
    return std::move(*this);
  }

  /// An attribute for templates, which is used before objects are made.
  Describe&& attribute_before_reading(const char* name, ParameterType type,
                                      ParameterFacts facts) && {
    return std::move(*this).attribute(name, type, std::move(facts), {}, nullptr, nullptr);
  }

  /// A text attribute with two choices; the choice `yes` makes the member true.
  template <class Owner>
  Describe&& choice(const char* name, bool Owner::*member, ParameterFacts facts,
                    const std::string& yes) && {
    const std::string no = facts.choices[facts.choices[0] == yes ? 1 : 0];
    const auto set = [member, yes](void* object, const ParameterValue& value) {
      static_cast<Object*>(object)->*member = std::get<std::string>(value) == yes;
    };
    const auto get = [member, yes, no](const void* object) -> std::optional<ParameterValue> {
      return static_cast<const Object*>(object)->*member ? yes : no;
    };
    return std::move(*this).attribute(name, ParameterType::text, std::move(facts), {}, set, get);
  }

  /// A child that may occur at most once. It describes a member that always exists.
  template <class Child>
  Describe&& one(ElementSpec child, Child Object::*member) && {
    return std::move(*this).child(
        std::move(child), [member](Object& parent) { return &(parent.*member); },
        [member](const Object& parent) { return only(&(parent.*member)); });
  }

  /// A child that may occur at most once and only holds other elements, which describe parts of
  /// this object or of its base class. Paths name its members by the first one, or by members().
  template <class Base>
  Describe&& group(Describe<Base> child) && {
    static_assert(std::is_base_of_v<Base, Object>, "a group describes parts of the object itself");
    ElementSpec spec = std::move(child);
    spec.group = true;
    if (spec.members.empty()) {
      spec.members = spec.children.front().name;
    }
    return std::move(*this).child(
        std::move(spec), [](Object& parent) -> Base* { return &parent; },
        [](const Object& parent) { return only(static_cast<const Base*>(&parent)); });
  }

  /// Children that each describe one object in a list. If the list also has other objects, `is`
  /// recognizes the objects of these children, and `begin` prepares a new object as one of them.
  template <class List>
  Describe&& each(
      ElementSpec child, List Object::*list,
      const std::function<bool(const typename List::value_type&)>& is =
          [](const auto&) { return true; },
      const std::function<void(typename List::value_type&)>& begin = [](auto&) {}) && {
    using Child = typename List::value_type;
    child.at_most = ElementSpec::kAnyNumber;
    child.copy = copied(list);
    if constexpr (kShared<List>) {
      child.share = [list](void* parent, const void* from) {
        static_cast<Object*>(parent)->*list = static_cast<const Object*>(from)->*list;
      };
    }
    child.reserve = [list](void* parent, std::size_t more) {
      auto& all = static_cast<Object*>(parent)->*list;
      all.reserve(all.size() + more);
    };
    return std::move(*this).child(
        std::move(child),
        [list, begin](Object& parent) {
          Child* made = &(parent.*list).emplace_back();
          begin(*made);
          return made;
        },
        [list, is](const Object& parent) {
          return listed(parent.*list,
                        [&](const Child& each) { return is(each) ? &each : nullptr; });
        });
  }

  /// Children that each describe one alternative in a list of variants.
  template <class Alternative, class Owner, class Variant>
  Describe&& each_of(Describe<Alternative> alternative, std::vector<Variant> Owner::*in) && {
    std::vector<Variant> Object::*const list = in;
    ElementSpec child = std::move(alternative);
    child.at_most = ElementSpec::kAnyNumber;
    child.copy = copied(list);
    return std::move(*this).child(
        std::move(child),
        [list](Object& parent) {
          return &std::get<Alternative>((parent.*list).emplace_back(Alternative{}));
        },
        [list](const Object& parent) {
          return listed(parent.*list,
                        [](const Variant& each) { return std::get_if<Alternative>(&each); });
        });
  }

  /// A child that may occur at most once. It describes a member that may be empty.
  template <class Child>
  Describe&& optional(ElementSpec child, std::optional<Child> Object::*member) && {
    return std::move(*this).child(
        std::move(child), [member](Object& parent) { return &(parent.*member).emplace(); },
        [member](const Object& parent) {
          return only(parent.*member ? &*(parent.*member) : nullptr);
        });
  }

  /// The name of the element is the name of a plugin of this kind.
  Describe&& plugins(PluginKind kind) && {
    spec_.plugins = kind;
    spec_.use = [](const void* object) -> const PluginUse* {
      return static_cast<const Object*>(object);
    };
    return std::move(*this);
  }

  /// The member for the coordination that such a plugin may hold.
  Describe&& holds(std::vector<Coordination> Object::*member) && {
    spec_.make_inside = [member](void* object) -> Coordination& {
      auto& inside = static_cast<Object*>(object)->*member;
      return inside.empty() ? inside.emplace_back() : inside.front();
    };
    spec_.inside = [member](const void* object) -> const Coordination* {
      const auto& inside = static_cast<const Object*>(object)->*member;
      return inside.empty() ? nullptr : &inside.front();
    };
    return std::move(*this);
  }

  /// The element holds what this one describes.
  Describe&& nested(const ElementSpec& (*inside)()) && {
    spec_.nested = inside;
    return std::move(*this);
  }

  /// The element may hold one element of a world; the member gets its markup.
  Describe&& takes_element(std::optional<std::string> Object::*member) && {
    spec_.take = [member](void* object, const std::string& markup) {
      static_cast<Object*>(object)->*member = markup;
    };
    return std::move(*this);
  }

  /// Requires different values of this attribute in all elements that this path ("worlds/world")
  /// leads to.
  Describe&& unique(std::string elements, std::string attribute) && {
    spec_.unique.push_back({std::move(elements), std::move(attribute)});
    return std::move(*this);
  }

  /// The element is the root element of a file.
  Describe&& root() && {
    spec_.root = true;
    return std::move(*this);
  }

  /// The element must occur in its parent at least once.
  Describe&& required() && {
    spec_.at_least = 1;
    return std::move(*this);
  }

  /// Sets the word for any child of this group in paths.
  Describe&& members(const char* name) && {
    spec_.members = name;
    return std::move(*this);
  }

  operator ElementSpec() && { return std::move(spec_); }  // NOLINT(google-explicit-constructor)

 private:
  /// A child element. `make` makes its object, `parts` lists all; a group's object is the parent.
  template <class Make, class Parts>
  Describe&& child(ElementSpec child, Make make, Parts parts) && {
    using Made = std::remove_pointer_t<decltype(make(std::declval<Object&>()))>;
    constexpr bool kHasPlace = requires(Made & made) { made.location; }
    &&!std::is_same_v<Made, Object>;
    child.make = [make](void* parent, const Location& where) -> void* {
      Made* const made = make(*static_cast<Object*>(parent));
      if constexpr (kHasPlace) made->location = where;
      return made;
    };
    if constexpr (kHasPlace) {
      child.location = [](const void* object) -> const Location& {
        return static_cast<const Made*>(object)->location;
      };
    }
    child.parts = [parts](const void* parent) {
      return parts(*static_cast<const Object*>(parent));
    };
    spec_.children.push_back(std::move(child));
    return std::move(*this);
  }

  template <class List>
  static constexpr bool kShared = requires(List& list, const List& from) {
    list.share(from, std::size_t{});
  };
  template <class List>
  static decltype(ElementSpec::copy) copied(List Object::*list) {
    return [list](void* parent, const void* from, std::size_t order) {
      List& to = static_cast<Object*>(parent)->*list;
      const List& there = static_cast<const Object*>(from)->*list;
      if constexpr (kShared<List>) {
        to.share(there, order);
      } else {
        to.push_back(there[order]);
      }
    };
  }

  static std::vector<DescribedObject> only(const void* object) {
    return object ? std::vector<DescribedObject>{{0, object}} : std::vector<DescribedObject>{};
  }

  /// The objects of a list for which `described` is not null.
  template <class List, class Function>
  static std::vector<DescribedObject> listed(const List& objects, const Function& described) {
    std::vector<DescribedObject> parts;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      if (const void* object = described(objects[i])) {
        parts.push_back({i, object});
      }
    }
    return parts;
  }

  ElementSpec spec_;
};

}  // namespace elsie::world
