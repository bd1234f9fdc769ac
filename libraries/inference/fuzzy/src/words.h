// The language's words for operators and algorithms.
#pragma once

#include <array>
#include <string_view>

#include "model_data.h"

namespace elsie::fuzzy {

/// A word of the language and its meaning.
template <class Value>
struct Word {
  const char* word;
  Value value;
};

inline constexpr std::array<Word<Operator>, 3> kAnd = {
    {{"MIN", Operator::min}, {"PROD", Operator::product}, {"BDIF", Operator::bounded_difference}}};
inline constexpr std::array<Word<Operator>, 4> kOr = {{{"MAX", Operator::max},
                                                       {"ASUM", Operator::algebraic_sum},
                                                       {"PROBOR", Operator::algebraic_sum},
                                                       {"BSUM", Operator::bounded_sum}}};
inline constexpr std::array<Word<bool>, 2> kActivation = {{{"MIN", false}, {"PROD", true}}};
inline constexpr std::array<Word<Accumulation>, 6> kAccumulation = {
    {{"MAX", Accumulation::max},
     {"ASUM", Accumulation::algebraic_sum},
     {"PROBOR", Accumulation::algebraic_sum},
     {"BSUM", Accumulation::bounded_sum},
     {"NSUM", Accumulation::normalized_sum},
     {"SUM", Accumulation::normalized_sum}}};
inline constexpr std::array<Word<Defuzzification>, 8> kMethod = {
    {{"COG", Defuzzification::centroid},
     {"COGS", Defuzzification::centroid_of_singletons},
     {"COGF", Defuzzification::centroid_of_singletons},
     {"COA", Defuzzification::bisector},
     {"LM", Defuzzification::leftmost_maximum},
     {"RM", Defuzzification::rightmost_maximum},
     {"MM", Defuzzification::mean_of_maxima},
     {"MOM", Defuzzification::mean_of_maxima}}};

/// The tool that extends the language by this word; or none.
const char* tool_of(std::string_view word);

/// The operator on the complements: NOT (a op b) = (NOT a) dual(op) (NOT b).
constexpr Operator dual(Operator op) {
  switch (op) {
    case Operator::min:
      return Operator::max;
    case Operator::product:
      return Operator::algebraic_sum;
    case Operator::bounded_difference:
      return Operator::bounded_sum;
    case Operator::max:
      return Operator::min;
    case Operator::algebraic_sum:
      return Operator::product;
    case Operator::bounded_sum:
      return Operator::bounded_difference;
    case Operator::leaf:
      break;
  }
  return Operator::leaf;
}

}  // namespace elsie::fuzzy
