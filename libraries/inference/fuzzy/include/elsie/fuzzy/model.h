// A fuzzy model after Mamdani (1975): rules over words, numbers in, numbers out.
//
//   inputs -> degrees of the terms -> how far each rule fires -> its conclusion's term, cut or
//   scaled to that degree -> all conclusions on an output accumulated into one set -> one number
//
// The terms are made of straight lines, so the accumulated set is too (pieces of polynomials with
// the algebraic sum), and its centre of gravity is computed from the exact integral, not by
// sampling.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/fuzzy_set.h"
#include "elsie/fuzzy/error.h"

namespace elsie::fuzzy {

struct ModelData;

/// From the accumulated set to a number.
enum class Defuzzification {
  centroid,                // COG
  centroid_of_singletons,  // COGS: the mean of the singletons, weighted by their degrees
  bisector,                // COA: halves the area
  leftmost_maximum,        // LM
  rightmost_maximum,       // RM
  mean_of_maxima,          // MM, MOM: the mean of all places where the set is highest
};

/// How the conclusions on an output are put together.
enum class Accumulation {
  max,             // MAX
  algebraic_sum,   // ASUM: a + b - a b
  bounded_sum,     // BSUM: min(1, a + b)
  normalized_sum,  // NSUM: the sum, divided by its height where that is above 1
};

struct Range {
  double low = 0.0;
  double high = 0.0;

  friend bool operator==(const Range&, const Range&) = default;
};

/// A word for some values of a variable.
struct Term {
  std::string name;
  /// Its membership function. A singleton is a spike: three points of one x.
  FuzzySet set;
  std::optional<double> singleton;
  /// Of an output's term after Takagi and Sugeno (1985): a singleton at the sum of the inputs, each
  /// times its number here, and of the last number. `singleton` and `set` are then those for inputs
  /// in the middle of their ranges. Empty for other terms.
  std::vector<double> linear;
  /// Of an output's term that is a formula of the inputs, as the file has it: a singleton at its
  /// value. `singleton` and `set` are as with `linear`. Empty for other terms.
  std::string formula;
};

struct Variable {
  std::string name;
  /// As the file says; else what the terms span (for a picture; nothing is clamped then).
  Range range;
  bool range_given = false;
  std::vector<Term> terms;

  /// The term of that name, in any letter case, or none.
  const Term* term(std::string_view term_name) const;
};

struct OutputVariable : Variable {
  Defuzzification method = Defuzzification::centroid;
  Accumulation accumulation = Accumulation::max;
  std::optional<double> default_value;
  bool keeps_last = false;  // DEFAULT := NC
  /// With Gaps::noted: inputs at which no rule decides it, in words. It has no DEFAULT, and is NaN
  /// there.
  std::optional<std::string> gap;
};

/// A rule as a person reads it.
struct Rule {
  std::string block;
  std::string label;
  std::string text;  // "IF range IS near AND azimuth IS left THEN speed IS fast"
  double weight = 1.0;
  int line = 0;
};

/// The memory that an evaluation works in. It grows when it meets a model for the first time; from
/// then on nothing is allocated. One for each thread; it may serve any number of models in turn.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(Workspace&&) noexcept;
  Workspace& operator=(Workspace&&) noexcept;

  struct Memory;

 private:
  friend class Model;
  std::unique_ptr<Memory> memory_;
};

/// A model that was read and checked. It never changes: copies share it, and any number of threads
/// may evaluate it at once, each with a workspace of its own.
class Model {
 public:
  explicit Model(std::shared_ptr<const ModelData> data);

  const std::string& name() const;
  std::span<const Variable> inputs() const;
  std::span<const OutputVariable> outputs() const;
  std::span<const Rule> rules() const;
  /// What is untidy in the file but does no harm, in the order of its lines: inputs that no rule
  /// asks for, rule numbers that come twice...
  std::span<const Problem> notes() const;
  /// The place of an input or output by its name, in any letter case.
  std::optional<std::size_t> input_index(std::string_view name) const;
  std::optional<std::size_t> output_index(std::string_view name) const;

  /// An input for which no rule speaks of the output, in words: "range = 0.5, azimuth = 90". None
  /// when some rule always does. Where neither can be shown within a second (with thousands of
  /// rules), an input for which it may be so.
  std::optional<std::string> undecided_at(std::size_t output) const;

  /// Computes all outputs. `inputs` and `outputs` are in the order of the declarations.
  ///
  /// Where no rule speaks of an output, it gets its DEFAULT. With DEFAULT := NC it is left as the
  /// caller passed it in, which is the last value when the same memory is passed each time; with
  /// `value | NC`, a NaN that is passed in (no last value yet) becomes that value. Without DEFAULT
  /// some rule speaks of it wherever the inputs are, but for models read with Gaps::noted: there it
  /// may be NaN.
  ///
  /// Throws std::invalid_argument when an input is not finite, a formula is not (1 / 0), or a size
  /// does not fit.
  void evaluate(std::span<const double> inputs, std::span<double> outputs,
                Workspace& workspace) const;

  /// The accumulated set of one output before defuzzification, over the whole range of the output;
  /// without points when no rule speaks of it. With the algebraic sum, straight lines within 2.5e-4
  /// of the polynomials. A set of singletons has a spike for each. Throws as evaluate().
  FuzzySet output_set(std::size_t output, std::span<const double> inputs,
                      Workspace& workspace) const;
  /// The same into a set whose memory is used again.
  void output_set(std::size_t output, std::span<const double> inputs, Workspace& workspace,
                  FuzzySet& set) const;

  /// How far each rule fires, its weight included, in the order of rules(). Throws as evaluate().
  void rule_degrees(std::span<const double> inputs, std::span<double> degrees,
                    Workspace& workspace) const;

 private:
  void activate(std::span<const double> inputs, Workspace& workspace) const;

  std::shared_ptr<const ModelData> data_;
};

}  // namespace elsie::fuzzy
