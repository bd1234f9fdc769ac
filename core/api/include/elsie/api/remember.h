// What a plugin object remembers, for its successor.
//
// While a world runs, a plugin's library may be replaced by a newer one (docs/hot-reload.md). Each
// of its objects then makes room for one of the new class: with the same parameters, at the start
// of its life. A class that derives from Remembers as well hands over what it has in mind:
//
//   class Wander final : public elsie::Behavior, public elsie::Remembers {
//     void remember(elsie::Memory& memory) override { memory("bias", bias_); }
//     ...
//     double bias_ = 0.0;
//   };
//
// One function, called twice: on the old object, which writes, and on the new one, which reads.
// Names are all that the two have to agree on, so a class may gain and lose members from one
// version to the next.
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

  /// An empty one, to write to.
  Memory() = default;

  /// From now on it is read from.
  void begin_recall() { recalls_ = true; }
  /// Whether it is read from: for what has to be worked out afterwards.
  bool recalls() const { return recalls_; }
  std::size_t size() const { return values_.size(); }

  /// Writes the value, or reads it. A bool, an integer, an enumeration, a number, a std::string or
  /// a std::vector<double>. What the old object did not write under this name, or with another type
  /// (whole numbers are read as numbers), is left as it is.
  template <class T>
  void operator()(std::string_view name, T& value) {
    if (!recalls_) {
      values_.insert_or_assign(std::string(name), written(value));
    } else if (const auto known = values_.find(name); known != values_.end()) {
      read(known->second, value);
    }
  }
  /// An optional one of these. An empty one is not written: a new object that reset() left without
  /// a value stays without.
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

  /// Whether it could be read as that.
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

/// A sensor, behaviour or coordinator class that hands over what it remembers derives from this,
/// too. The simulator finds it by dynamic_cast.
class Remembers {
 public:
  /// Names every member that should outlive a replacement. Called between two steps: on the old
  /// object; then on the new one, which was configured, equipped and reset before. Where an edit
  /// has an object equipped again, both are the same. May throw (std::invalid_argument, with a
  /// sentence) when it cannot use what it reads: the old object goes on then, or the edit is
  /// refused.
  virtual void remember(Memory& memory) = 0;

 protected:
  ~Remembers() = default;
};

}  // namespace elsie
