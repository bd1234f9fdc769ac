// Reading fuzzy models from Fuzzy Control Language (IEC 61131-7).
//
// The language of the standard is read, and what the tools in use write in its name: terms by shape
// (`Triangle 0 1 2`, `trian 0 1 2`, `gauss 5 1.5`...), RANGE statements, rules that end with their
// line, `//` and `/* */` comments, keywords in any letter case. Nothing that is not understood is
// passed over: it is an error, and all errors of a file are reported at once. What is untidy but
// means one thing is read, with a note (Model::notes()).
//
// Choices where the standard leaves one, or tools differ:
// - Names are compared without regard to letter case, as in all languages of IEC 61131. Two names
//   that differ in case only are an error, so that none is ever taken for the other.
// - A block that names one of AND and OR gets the other as its pair: MIN with MAX, PROD with ASUM,
//   BDIF with BSUM. With neither: MIN and MAX. Without ACT: MIN. Without ACCU: MAX. Without METHOD:
//   COG, or COGS where all terms are singletons. ACCU may stand in RULEBLOCK or in DEFUZZIFY.
// - An input beyond its RANGE is taken as the nearer end of it. An input without RANGE takes any
//   number: terms go on to both sides as they end.
// - An output without RANGE spans its terms, from the first point of any to the last.
// - `DEFAULT := nan` is no default. With `DEFAULT := NC` (no change) an output that no rule speaks
//   of keeps the value that the caller passes in; see Model::evaluate().
// - An output without DEFAULT must be decided by some rule wherever its inputs are; a gap is an
//   error when the file is read (see Gaps).
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
//   dsigm, dsigmf, psigmf slope centre slope centre
//   SShape, smf from to   ZShape, zmf from to   PiShape, pimf a b c d
//   Cosine centre width   Spike centre width    Concave inflection end
#pragma once

#include <string>
#include <string_view>

#include "elsie/fuzzy/model.h"

namespace elsie::fuzzy {

/// How far the straight lines that stand for a curved shape may be from it, in degrees of
/// membership.
inline constexpr double kCurveTolerance = 2.5e-4;

/// What to do about an output without DEFAULT that no rule decides for some inputs.
enum class Gaps {
  refused,  // an error: what steers a robot always has a value
  noted,    // a note; see OutputVariable::gap. For those who look at models of other tools
};

/// Reads a model from a file. `block`: the name of its function block, in any letter case; "" where
/// the file has one block only. Throws FclError, also when there is no such block, and when there
/// are several and none is named.
Model read_fcl(const std::string& path, const std::string& block = "", Gaps gaps = Gaps::refused);

/// Reads a model from text; `name` stands for the file in messages. Throws FclError.
Model parse_fcl(std::string_view text, const std::string& name = "model",
                const std::string& block = "", Gaps gaps = Gaps::refused);

}  // namespace elsie::fuzzy
