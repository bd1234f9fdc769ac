// Random models are also evaluated by fuzzylite, an independent implementation that samples the
// output set. The results must agree to half a percent of the output's range.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>
#include <fl/Headers.h>

#include "elsie/base/random.h"
#include "elsie/fuzzy/fcl.h"

using elsie::Random;
using elsie::fuzzy::Model;
using elsie::fuzzy::Workspace;

namespace {

constexpr double kAgreement = 0.005;
constexpr int kResolution = 1000;
/// fuzzylite ignores rules with degrees below 1e-6.
constexpr double kFires = 0.01;

std::string text_of(double value) {
  std::string text = std::to_string(value);  // six digits: both sides read the same number
  return text;
}

struct TermText {
  std::string name;
  std::string shape;  // in fuzzylite's notation
  std::string parameters;
};

/// A random model for both implementations.
struct Twin {
  std::string fcl;
  std::unique_ptr<fl::Engine> engine;
};

struct Algorithms {
  std::string conjunction = "MIN";
  std::string disjunction = "MAX";
  std::string activation = "MIN";
  std::string accumulation = "MAX";
  std::string method = "COG";
};

const std::vector<std::string>& polygons() {
  static const std::vector<std::string> kShapes = {"Triangle", "Trapezoid", "Rectangle",
                                                   "Ramp",     "Discrete",  "Binary"};
  return kShapes;
}

const std::vector<std::string>& curves() {
  static const std::vector<std::string> kShapes = {
      "Gaussian",          "GaussianProduct", "Bell",   "Sigmoid",
      "SigmoidDifference", "SigmoidProduct",  "SShape", "ZShape",
      "PiShape",           "Cosine",          "Spike",  "Concave"};
  return kShapes;
}

/// A term of the shape, around `centre`, about as wide as `width`; neither is small.
TermText random_term(Random& random, const std::string& name, const std::string& shape,
                     double centre, double width, bool heights) {
  TermText term{name, shape, ""};
  const auto add = [&](double value) {
    term.parameters += (term.parameters.empty() ? "" : " ") + text_of(value);
  };
  const double a = centre - width * random.uniform(0.8, 1.2);
  const double b = centre - width * random.uniform(0.1, 0.5);
  const double c = centre + width * random.uniform(0.1, 0.5);
  const double d = centre + width * random.uniform(0.8, 1.2);
  const double sign = random.chance(0.5) ? 1.0 : -1.0;
  if (shape == "Triangle") {
    add(a), add(centre), add(d);
  } else if (shape == "Trapezoid" || shape == "PiShape") {
    add(a), add(b), add(c), add(d);
  } else if (shape == "Rectangle") {
    add(b), add(c);
  } else if (shape == "Ramp") {
    sign > 0.0 ? (add(b), add(c)) : (add(c), add(b));
  } else if (shape == "SShape" || shape == "ZShape") {
    add(b), add(c);
  } else if (shape == "Discrete") {
    for (const double x : {a, b, centre, c, d}) {
      add(x), add(x == a || x == d ? 0.0 : random.uniform(0.3, 1.0));
    }
  } else if (shape == "Binary") {
    term.parameters = text_of(centre) + (sign > 0.0 ? " inf" : " -inf");
  } else if (shape == "Gaussian") {
    add(centre), add(0.5 * width);
  } else if (shape == "GaussianProduct") {
    add(b), add(0.3 * width), add(c), add(0.5 * width);
  } else if (shape == "Bell") {
    add(centre), add(0.6 * width), add(random.uniform(1.0, 4.0));
  } else if (shape == "Sigmoid") {
    add(centre), add(sign * 6.0 / width);
  } else if (shape == "SigmoidDifference") {
    add(b), add(8.0 / width), add(6.0 / width), add(d);
  } else if (shape == "SigmoidProduct") {
    add(b), add(8.0 / width), add(-6.0 / width), add(d);
  } else if (shape == "Cosine") {
    add(centre), add(2.0 * width);
  } else if (shape == "Spike") {
    add(centre), add(4.0 * width);
  } else if (shape == "Concave") {
    sign > 0.0 ? (add(b), add(c)) : (add(c), add(b));
  }
  if (heights && shape != "Discrete" && random.chance(0.2)) {
    add(random.uniform(0.5, 1.0));  // the height
  }
  return term;
}

std::vector<TermText> random_terms(Random& random, const std::vector<std::string>& shapes,
                                   double low, double high, bool heights) {
  const int terms_in_all = 3 + static_cast<int>(random.uniform(0.0, 3.0));
  const double spacing = (high - low) / terms_in_all;
  std::vector<TermText> terms;
  for (int i = 0; i < terms_in_all; ++i) {
    const auto& shape =
        shapes[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(shapes.size())))];
    terms.push_back(random_term(random, "t" + std::to_string(i), shape, low + spacing * (i + 0.5),
                                spacing, heights));
  }
  return terms;
}

fl::Term* oracle_term(const TermText& text) {
  fl::Term* term = fl::FactoryManager::instance()->term()->constructObject(text.shape);
  term->setName(text.name);
  term->configure(text.parameters);
  return term;
}

fl::TNorm* oracle_and(const std::string& name) {
  static const std::map<std::string, const char*> kNames{
      {"MIN", "Minimum"}, {"PROD", "AlgebraicProduct"}, {"BDIF", "BoundedDifference"}};
  return fl::FactoryManager::instance()->tnorm()->constructObject(kNames.at(name));
}

fl::SNorm* oracle_or(const std::string& name) {
  static const std::map<std::string, const char*> kNames{
      {"MAX", "Maximum"},
      {"ASUM", "AlgebraicSum"},
      {"NSUM", "UnboundedSum"},  // the same up to a factor that no method depends on
      {"BSUM", "BoundedSum"}};
  return fl::FactoryManager::instance()->snorm()->constructObject(kNames.at(name));
}

fl::Defuzzifier* oracle_method(const std::string& name) {
  static const std::map<std::string, const char*> kNames{
      {"COG", "Centroid"},        {"COA", "Bisector"},     {"LM", "SmallestOfMaximum"},
      {"RM", "LargestOfMaximum"}, {"MM", "MeanOfMaximum"}, {"COGS", "WeightedAverage"}};
  return fl::FactoryManager::instance()->defuzzifier()->constructDefuzzifier(
      kNames.at(name), kResolution, fl::WeightedDefuzzifier::Automatic);
}

std::string random_condition(Random& random, const std::vector<std::vector<TermText>>& inputs) {
  std::string text;
  bool open = false;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (i > 0) {
      text += random.chance(0.6) ? " and " : " or ";
    }
    if (!open && i + 1 < inputs.size() && random.chance(0.3)) {
      text += "( ";
      open = true;
    }
    const auto term =
        static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(inputs[i].size())));
    text +=
        "x" + std::to_string(i) + (random.chance(0.2) ? " is not " : " is ") + inputs[i][term].name;
    if (open && i > 0 && random.chance(0.7)) {
      text += " )";
      open = false;
    }
  }
  return text + (open ? " )" : "");
}

constexpr double kLow = -10.0;
constexpr double kHigh = 30.0;

Twin random_twin(Random& random, const Algorithms& use, const std::vector<std::string>& in_shapes,
                 const std::vector<std::string>& out_shapes, int input_count) {
  Twin twin;
  twin.engine = std::make_unique<fl::Engine>("random");
  std::string fcl = "FUNCTION_BLOCK random\nVAR_INPUT\n";
  for (int i = 0; i < input_count; ++i) {
    fcl += "x" + std::to_string(i) + " : REAL;\n";
  }
  fcl += "END_VAR\nVAR_OUTPUT\ny : REAL;\nEND_VAR\n";

  std::vector<std::vector<TermText>> inputs;
  for (int i = 0; i < input_count; ++i) {
    inputs.push_back(random_terms(random, in_shapes, 0.0, 1.0, true));
    const std::string name = "x" + std::to_string(i);
    fcl += "FUZZIFY " + name + "\nRANGE := (0 .. 1);\n";
    auto* variable = new fl::InputVariable(name, 0.0, 1.0);
    for (const TermText& term : inputs.back()) {
      fcl += "TERM " + term.name + " := " + term.shape + " " + term.parameters + ";\n";
      variable->addTerm(oracle_term(term));
    }
    twin.engine->addInputVariable(variable);
    fcl += "END_FUZZIFY\n";
  }

  const bool singletons = use.method == "COGS";
  // Where the maximum matters, the strongest rule should have it.
  const bool is_area = use.method == "COG" || use.method == "COA";
  std::vector<TermText> outputs = random_terms(random, out_shapes, kLow, kHigh, is_area);
  fcl += "DEFUZZIFY y\nRANGE := (-10 .. 30);\n";
  auto* output = new fl::OutputVariable("y", kLow, kHigh);
  for (TermText& term : outputs) {
    if (singletons) {
      term.shape = "Constant";
      term.parameters = text_of(random.uniform(kLow, kHigh));
    }
    fcl += "TERM " + term.name + " := " + (singletons ? "" : term.shape + " ") + term.parameters +
           ";\n";
    output->addTerm(oracle_term(term));
  }
  fcl += "METHOD : " + use.method + ";\nACCU : " + use.accumulation +
         ";\nDEFAULT := 12.5;\nEND_DEFUZZIFY\n";
  output->setDefuzzifier(oracle_method(use.method));
  output->setAggregation(oracle_or(use.accumulation));
  output->setDefaultValue(12.5);
  twin.engine->addOutputVariable(output);

  fcl += "RULEBLOCK all\nAND : " + use.conjunction + ";\nOR : " + use.disjunction +
         ";\nACT : " + use.activation + ";\n";
  auto* rules = new fl::RuleBlock("all");
  rules->setConjunction(oracle_and(use.conjunction));
  rules->setDisjunction(oracle_or(use.disjunction));
  rules->setImplication(oracle_and(use.activation));
  rules->setActivation(new fl::General);
  for (std::size_t i = 0; i < 8; ++i) {
    std::string text =
        "if " + random_condition(random, inputs) + " then y is " + outputs[i % outputs.size()].name;
    if (random.chance(0.3)) {
      text += " with " + text_of(random.uniform(0.3, 1.0));
    }
    fcl += "RULE " + std::to_string(i) + " : " + text + ";\n";
    rules->addRule(fl::Rule::parse(text, twin.engine.get()));
  }
  // Each input is used.
  for (int i = 0; i < input_count; ++i) {
    const std::string text = "if x" + std::to_string(i) + " is t0 then y is t1 with 0.2";
    fcl += "RULE extra" + std::to_string(i) + " : " + text + ";\n";
    rules->addRule(fl::Rule::parse(text, twin.engine.get()));
  }
  twin.engine->addRuleBlock(rules);
  twin.fcl = fcl + "END_RULEBLOCK\nEND_FUNCTION_BLOCK\n";
  return twin;
}

/// Compares both at random inputs; returns the number of comparisons.
int compare(Twin& twin, Random& random, int input_count, bool clear_winner) {
  const Model model = elsie::fuzzy::parse_fcl(twin.fcl);
  Workspace workspace;
  std::vector<double> inputs(static_cast<std::size_t>(input_count));
  std::vector<double> degrees(model.rules().size());
  int compared = 0;
  for (int n = 0; n < 40; ++n) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      inputs[i] = random.uniform();
      twin.engine->setInputValue("x" + std::to_string(i), inputs[i]);
    }
    model.rule_degrees(inputs, degrees, workspace);
    std::vector<double> ranked = degrees;
    std::sort(ranked.rbegin(), ranked.rend());
    if (ranked[0] < kFires || (clear_winner && ranked[0] - ranked[1] < 0.01)) {
      continue;
    }
    double output = 0.0;
    model.evaluate(inputs, {&output, 1}, workspace);
    twin.engine->process();
    const double oracle = twin.engine->getOutputValue("y");
    CAPTURE(twin.fcl, inputs, degrees);
    CHECK(output == Approx(oracle).margin(kAgreement * (kHigh - kLow)).epsilon(0.0));
    ++compared;
  }
  return compared;
}

std::vector<std::string> all_shapes() {
  std::vector<std::string> shapes = polygons();
  shapes.insert(shapes.end(), curves().begin(), curves().end());
  return shapes;
}

}  // namespace

TEST_CASE("Every combination of norms and area methods agrees with fuzzylite") {
  Random random(1131, "norms");
  int compared = 0;
  for (const char* conjunction : {"MIN", "PROD", "BDIF"}) {
    for (const char* disjunction : {"MAX", "ASUM", "BSUM"}) {
      for (const char* activation : {"MIN", "PROD"}) {
        for (const char* accumulation : {"MAX", "ASUM", "BSUM", "NSUM"}) {
          for (const char* method : {"COG", "COA"}) {
            const Algorithms use{conjunction, disjunction, activation, accumulation, method};
            Twin twin = random_twin(random, use, polygons(), polygons(), 2);
            compared += compare(twin, random, 2, false);
          }
        }
      }
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("Every shape agrees with fuzzylite, as input and as output") {
  Random random(61131, "shapes");
  int compared = 0;
  for (const std::string& shape : all_shapes()) {
    for (int i = 0; i < 4; ++i) {
      Algorithms use;
      use.accumulation = i % 2 == 0 ? "MAX" : "ASUM";
      use.activation = i < 2 ? "MIN" : "PROD";
      Twin as_input = random_twin(random, use, {shape}, polygons(), 1 + i % 3);
      compared += compare(as_input, random, 1 + i % 3, false);
      Twin as_output = random_twin(random, use, polygons(), {shape}, 1 + i % 3);
      compared += compare(as_output, random, 1 + i % 3, false);
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("Mixed shapes with three inputs agree with fuzzylite") {
  Random random(7, "mixed");
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    Twin twin = random_twin(random, {}, all_shapes(), all_shapes(), 3);
    compared += compare(twin, random, 3, false);
  }
  CHECK(compared > 500);
}

TEST_CASE("The methods that look for maxima agree with fuzzylite where one rule is the strongest") {
  Random random(5, "maxima");
  int compared = 0;
  for (const char* method : {"LM", "RM", "MM"}) {
    for (int i = 0; i < 20; ++i) {
      Algorithms use;
      use.method = method;
      Twin twin = random_twin(random, use, polygons(), {"Triangle", "Trapezoid"}, 2);
      compared += compare(twin, random, 2, true);
    }
  }
  CHECK(compared > 300);
}

TEST_CASE("Singletons agree with fuzzylite's weighted average") {
  Random random(9, "singletons");
  int compared = 0;
  for (int i = 0; i < 40; ++i) {
    Algorithms use;
    use.method = "COGS";
    use.accumulation = "NSUM";  // fuzzylite's average adds up
    Twin twin = random_twin(random, use, all_shapes(), {"Triangle"}, 2);
    compared += compare(twin, random, 2, false);
  }
  CHECK(compared > 300);
}

TEST_CASE("What fuzzylite exports as FCL loads and computes the same") {
  fl::Engine engine("exported");
  auto* input = new fl::InputVariable("distance", 0.0, 4.0);
  input->addTerm(new fl::Triangle("near", -2.0, 0.0, 2.0));
  input->addTerm(new fl::Gaussian("medium", 2.0, 0.5));
  input->addTerm(new fl::Sigmoid("far", 3.0, 5.0));
  engine.addInputVariable(input);
  auto* output = new fl::OutputVariable("power", 0.0, 1.0);
  output->addTerm(new fl::Ramp("low", 1.0, 0.0));
  output->addTerm(new fl::Discrete("middle", fl::Discrete::toPairs({0.2, 0, 0.5, 1, 0.9, 0})));
  output->addTerm(new fl::Ramp("high", 0.0, 1.0));
  output->setDefuzzifier(new fl::Centroid(kResolution));
  output->setAggregation(new fl::Maximum);
  engine.addOutputVariable(output);
  auto* rules = new fl::RuleBlock("driving");
  rules->setConjunction(new fl::Minimum);
  rules->setDisjunction(new fl::Maximum);
  rules->setImplication(new fl::Minimum);
  rules->setActivation(new fl::General);
  for (const char* rule :
       {"if distance is near then power is low", "if distance is medium then power is middle",
        "if distance is far or distance is not near then power is high with 0.5"}) {
    rules->addRule(fl::Rule::parse(rule, &engine));
  }
  engine.addRuleBlock(rules);

  const Model model = elsie::fuzzy::parse_fcl(fl::FclExporter().toString(&engine));
  Workspace workspace;
  for (double x = 0.0; x <= 4.0; x += 0.1) {
    engine.setInputValue("distance", x);
    engine.process();
    double power = 0.0;
    model.evaluate({&x, 1}, {&power, 1}, workspace);
    CHECK(power == Approx(engine.getOutputValue("power")).margin(kAgreement));
  }
}
