// How a plugin object passes its memory to its successor.
//
// During a run, a newer library may replace a plugin's library (docs/hot-reload.md). A new object
// of the new class, with the same parameters, then replaces each object of the old one. A class
// that also derives from Remembers passes on what it remembers:
//
//   class Wander final : public elsie::Behavior, public elsie::Remembers {
//     void remember(elsie::Memory& memory) override { memory("bias", bias_); }
//     ...
//     double bias_ = 0.0;
//   };
//
// One function, called twice: on the old object, which writes, and on the new one, which reads. The
// two only have to agree on names, so a class may gain and lose members between versions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace elsie {

/// Values by name.
class Memory {
 public:
  using Value = std::variant<bool, std::int64_t, double, std::string, std::vector<double>>;

  /// An empty memory, for writing.
  Memory() = default;

  /// From now on, calls read from it.
  void begin_recall() { recalls_ = true; }
  /// Returns whether calls read from it. Use this to recompute members that depend on others.
  bool recalls() const { return recalls_; }
  std::size_t size() const { return values_.size(); }

  /// Writes or reads the value: a bool, an integer, an enumeration, a number, a std::string or a
  /// std::vector<double>. A value that the old object did not write under this name, or wrote as
  /// another type, stays unchanged (integers can be read as numbers).
  template <class T>
  void operator()(std::string_view name, T& value) {
    if (!recalls_) {
      values_.insert_or_assign(std::string(name), written(value));
    } else if (const auto known = values_.find(name); known != values_.end()) {
      read(known->second, value);
    }
  }
  /// The same for an optional value. An empty one is not written: a new object whose member is
  /// empty after reset() keeps it empty.
  template <class T>
  void operator()(std::string_view name, std::optional<T>& value) {
    if (recalls_ && values_.contains(name)) {
      T known = value.value_or(T());
      value = read(values_.find(name)->second, known) ? std::optional<T>(known) : value;
    } else if (!recalls_ && value) {
      (*this)(name, *value);
    }
  }

 private:
  template <class T>
  static Value written(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      return value;
    } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
      return static_cast<std::int64_t>(value);
    } else if constexpr (std::is_floating_point_v<T>) {
      return static_cast<double>(value);
    } else {
      static_assert(std::is_same_v<T, std::string> || std::is_same_v<T, std::vector<double>>,
                    "a memory holds bools, numbers, enumerations, std::string and "
                    "std::vector<double>");
      return value;
    }
  }

  /// Returns whether the value has a matching type.
  template <class T>
  static bool read(const Value& from, T& value) {
    if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string> ||
                  std::is_same_v<T, std::vector<double>>) {
      if (const T* known = std::get_if<T>(&from)) {
        value = *known;
        return true;
      }
      return false;
    } else {
      if (const auto* whole = std::get_if<std::int64_t>(&from)) {
        value = static_cast<T>(*whole);
        return true;
      }
      if constexpr (std::is_floating_point_v<T>) {
        if (const auto* number = std::get_if<double>(&from)) {
          value = static_cast<T>(*number);
          return true;
        }
      }
      return false;
    }
  }

  std::map<std::string, Value, std::less<>> values_;
  bool recalls_ = false;
};

/// A sensor, behaviour or coordinator class that passes on its memory also derives from this. The
/// simulator finds it by dynamic_cast.
class Remembers {
 public:
  /// Names every member that should survive a replacement. Called between two steps, first on the
  /// old object, then on the new one after configured(), equipped() and reset(). When an edit
  /// equips an object again, both are the same object. May throw (std::invalid_argument, with a
  /// sentence) when it cannot use what it reads: then the old object stays in use, or the edit is
  /// refused.
  virtual void remember(Memory& memory) = 0;

 protected:
  ~Remembers() = default;
};

}  // namespace elsie
