// A measure that is computed from others: "collisions / robots / minute".
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace elsie::experiment {

/// Numbers, names, + - * / ^ ( ), and the functions min, max (of any number of values), abs, sqrt,
/// log (natural) and exp. ^ binds from the right and closer than a sign: -2^2 is -4. A name is a
/// letter or "_", then letters, digits, "_" and ".".
class Formula {
 public:
  /// Throws std::invalid_argument with what was found at which column of the text, from 1, and what
  /// was expected.
  explicit Formula(const std::string& text);
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

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

/// Whether a formula may use this name whatever is measured: `robots`, those of the run at its end,
/// and `minute` or `minutes`, the simulated time of the run by 60 s.
bool is_of_every_run(const std::string& name);

/// The number that a label is: "0.25"; none for any other text.
std::optional<double> number_in(const std::string& label);

}  // namespace elsie::experiment
