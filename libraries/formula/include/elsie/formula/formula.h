// A number that is computed from others: "collisions / robots / minute"; and conditions:
// "battery < 0.2 or not(leader_seen)".
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace elsie::formula {

/// Numbers, names, + - * / ^ ( ), and the functions min, max (of any number of values), abs, sqrt,
/// log (natural) and exp. ^ binds from the right and closer than a sign: -2^2 is -4. A name is a
/// letter or "_", then letters, digits, "_" and ".".
///
/// A condition has, besides, < <= > >= == !=, `and`, `or` and the function not, whose values are 1
/// (true) and 0; any number but 0 is true. What is compared with no number is false.
class Formula {
 public:
  enum class Kind { number, condition };
  /// Throws std::invalid_argument with what was found at which column of the text, from 1, and what
  /// was expected.
  explicit Formula(const std::string& text, Kind kind = Kind::number);
  ~Formula();
  Formula(Formula&&) noexcept;
  Formula& operator=(Formula&&) noexcept;

  /// A name in the text.
  struct Name {
    std::string text;
    std::size_t column = 1;  // the first place where it is, from 1
  };
  /// Each name once, in the order of the text.
  const std::vector<Name>& names() const;

  /// The value for these values of the names, in their order; none where a division by 0, the
  /// logarithm or the root of a negative number, or a number beyond all bounds is in it.
  std::optional<double> value(std::span<const double> values) const;
  /// Whether the value is there and not 0.
  bool is_true(std::span<const double> values) const { return value(values).value_or(0.0) != 0.0; }

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace elsie::formula
