// A fuzzy model after Mamdani (1975): rules over words, numbers in, numbers out.
//
//   inputs -> degrees of terms -> degree of each rule -> its conclusion's term, cut off at or
//   scaled to that degree -> all conclusions on an output accumulated into one set -> one number
//
// Terms are made of straight lines, and so is the accumulated set (of polynomials with the
// algebraic sum). Its centre of gravity is computed from the exact integral, not by sampling.
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

/// Computes a number from the accumulated set.
enum class Defuzzification {
  centroid,                // COG
  centroid_of_singletons,  // COGS: the mean of the singletons, weighted by their degrees
  bisector,                // COA: halves the area
  leftmost_maximum,        // LM
  rightmost_maximum,       // RM
  mean_of_maxima,          // MM, MOM: the mean of all places where the set is highest
};

/// Combines the conclusions on an output.
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
  /// Its membership function. A singleton is a spike: three points with the same x.
  FuzzySet set;
  std::optional<double> singleton;
  /// Only for an output's term after Takagi and Sugeno (1985): a singleton at the sum of the
  /// inputs, each times its number here, plus the last number. `singleton` and `set` are then those
  /// for inputs in the middle of their ranges.
  std::vector<double> linear;
  /// Only for an output's term that is a formula of the inputs, as in the file: a singleton at its
  /// value. `singleton` and `set` are as with `linear`.
  std::string formula;
};

struct Variable {
  std::string name;
  /// As in the file; else the extent of the terms, for pictures (inputs are then not clamped).
  Range range;
  bool range_given = false;
  std::vector<Term> terms;

  /// The term of this name, in any letter case; or none.
  const Term* term(std::string_view term_name) const;
};

struct OutputVariable : Variable {
  Defuzzification method = Defuzzification::centroid;
  Accumulation accumulation = Accumulation::max;
  std::optional<double> default_value;
  bool keeps_last = false;  // DEFAULT := NC
  /// With Gaps::noted: inputs for which no rule decides the output, in words. It has no DEFAULT
  /// then, and is NaN for these.
  std::optional<std::string> gap;
};

/// A rule in readable form.
struct Rule {
  std::string block;
  std::string label;
  std::string text;  // "IF range IS near AND azimuth IS left THEN speed IS fast"
  double weight = 1.0;
  int line = 0;
};

/// The memory of an evaluation. It grows with the first evaluation of a model; later ones do not
/// allocate. Each thread needs one; it may serve several models in turn.
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

/// A checked model. It never changes: copies share it, and several threads may evaluate it at once,
/// each with its own workspace.
class Model {
 public:
  explicit Model(std::shared_ptr<const ModelData> data);

  const std::string& name() const;
  std::span<const Variable> inputs() const;
  std::span<const OutputVariable> outputs() const;
  std::span<const Rule> rules() const;
  /// Harmless irregularities of the file, in the order of its lines: unused inputs, repeated rule
  /// numbers...
  std::span<const Problem> notes() const;
  /// The index of an input or output by its name, in any letter case.
  std::optional<std::size_t> input_index(std::string_view name) const;
  std::optional<std::size_t> output_index(std::string_view name) const;

  /// An input for which no rule decides the output, in words: "range = 0.5, azimuth = 90". None
  /// when some rule always does. If neither can be shown within a second (with thousands of rules),
  /// an input for which no rule may decide it.
  std::optional<std::string> undecided_at(std::size_t output) const;

  /// Computes all outputs. `inputs` and `outputs` are in the order of the declarations.
  ///
  /// An output that no rule decides gets its DEFAULT. With DEFAULT := NC it keeps the value that
  /// the caller passed in, which is the last value when the same memory is passed each time; with
  /// `value | NC`, a NaN that is passed in (no last value yet) becomes that value. Without DEFAULT
  /// some rule decides it for all inputs, unless the model was read with Gaps::noted: then it may
  /// be NaN.
  ///
  /// Throws std::invalid_argument when an input or a formula's value is not finite (1 / 0), or a
  /// size does not match.
  void evaluate(std::span<const double> inputs, std::span<double> outputs,
                Workspace& workspace) const;

  /// The accumulated set of an output before defuzzification, over the whole range of the output;
  /// without points when no rule decides it. With the algebraic sum, straight lines within 2.5e-4
  /// of the polynomials. A set of singletons has a spike for each. Throws as evaluate().
  FuzzySet output_set(std::size_t output, std::span<const double> inputs,
                      Workspace& workspace) const;
  /// The same into a set whose memory is reused.
  void output_set(std::size_t output, std::span<const double> inputs, Workspace& workspace,
                  FuzzySet& set) const;

  /// The degree of each rule, including its weight, in the order of rules(). Throws as evaluate().
  void rule_degrees(std::span<const double> inputs, std::span<double> degrees,
                    Workspace& workspace) const;

 private:
  void activate(std::span<const double> inputs, Workspace& workspace) const;

  std::shared_ptr<const ModelData> data_;
};

}  // namespace elsie::fuzzy
