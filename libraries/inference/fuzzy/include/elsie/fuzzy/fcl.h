// Reads fuzzy models from Fuzzy Control Language (IEC 61131-7).
//
// The reader takes the language of the standard, and what common tools write under its name: terms
// by shape (`Triangle 0 1 2`, `trian 0 1 2`, `gauss 5 1.5`...), RANGE statements, rules that end
// with their line, `//` and `/* */` comments, keywords in any letter case. Nothing is skipped: what
// the reader does not understand is an error, and all errors of a file are reported at once. Untidy
// statements with one possible meaning are read, with a note (Model::notes()).
//
// Choices where the standard leaves one, or tools differ:
// - Names are compared without letter case, as in all languages of IEC 61131. Two names that differ
//   in case only are an error.
// - A block that names one of AND and OR gets the other as its pair: MIN with MAX, PROD with ASUM,
//   BDIF with BSUM. With neither: MIN and MAX. Without ACT: MIN. Without ACCU: MAX. Without METHOD:
//   COG, or COGS if all terms are singletons. ACCU may be in RULEBLOCK or in DEFUZZIFY.
// - An input beyond its RANGE counts as the nearer end. An input without RANGE takes any number:
//   its terms continue to both sides with their last degree.
// - An output without RANGE spans its terms, from the first point of any to the last.
// - `DEFAULT := nan` is no default. With `DEFAULT := NC` (no change) an output that no rule decides
//   keeps the value that the caller passes in; see Model::evaluate().
// - Some rule must decide an output without DEFAULT for all inputs; a gap is an error when the file
//   is read (see Gaps).
// - Curved shapes become straight lines that stay within kCurveTolerance of the curve.
//
// Shapes and their parameters; an optional last number is the height (default 1):
//   Triangle, triangular, trian, trimf a b c
//   Trapezoid, trapezoidal, trape, trapmf a b c d
//   Rectangle a b     Ramp from to          Discrete x y x y ...     Binary start direction
//   Gaussian, gauss mean deviation          gaussmf deviation mean
//   GaussianProduct, gauss2 mean deviation mean deviation
//   gauss2mf deviation mean deviation mean  Bell centre width slope
//   gbell, gbellmf width slope centre       Sigmoid centre slope     sigm, sigmf slope centre
//   SigmoidDifference, SigmoidProduct left rising falling right
//   dsigm (at least 0), dsigmf (the absolute value), psigmf slope centre slope centre
//   SShape, smf from to   ZShape, zmf from to   PiShape, pimf a b c d
//   Cosine centre width   Spike centre width    Concave inflection end
#pragma once

#include <string>
#include <string_view>

#include "elsie/fuzzy/model.h"

namespace elsie::fuzzy {

/// The largest distance of straight lines from the curved shape that they replace, in degrees of
/// membership.
inline constexpr double kCurveTolerance = 2.5e-4;

/// How to treat a block without outputs, and an output without DEFAULT that no rule decides for
/// some inputs.
enum class Gaps {
  refused,  // an error, because a robot always needs a value
  noted,    // a note; see OutputVariable::gap. For viewing models of other tools
};

/// Reads a model from a file. `block`: the name of its function block, in any letter case; "" if
/// the file has only one. Throws FclError, also when there is no such block, or there are several
/// and none is named.
Model read_fcl(const std::string& path, const std::string& block = "", Gaps gaps = Gaps::refused);

/// Reads a model from text; `name` is its name in messages. Throws FclError.
Model parse_fcl(std::string_view text, const std::string& name = "model",
                const std::string& block = "", Gaps gaps = Gaps::refused);

}  // namespace elsie::fuzzy
