// Fuzzy inference compared with fuzzylite: the same model, the same inputs, one process. Checks
// that the results agree before it measures, and prints the ratios at the end.
//
// fuzzylite samples the output set, at 100 points by default; ours is exact.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fl/Headers.h>

#include "elsie/base/random.h"
#include "elsie/fuzzy/fcl.h"

namespace {

using elsie::fuzzy::Model;
using elsie::fuzzy::Workspace;

const Model& model() {
  static const Model kModel =
      elsie::fuzzy::read_fcl(ELSIE_SOURCE_DIR "/fuzzy_models/avoid_obstacle_left.fcl");
  return kModel;
}

struct Input {
  double range;
  double azimuth;
};

const std::vector<Input>& inputs() {
  static const std::vector<Input> kInputs = [] {
    elsie::Random random(1, "inputs");
    std::vector<Input> all(1024);
    for (Input& input : all) {
      input = {random.uniform(0.0, 1.0), random.uniform(-90.0, 90.0)};
    }
    return all;
  }();
  return kInputs;
}

/// Our model as a fuzzylite engine.
std::unique_ptr<fl::Engine> oracle(int resolution) {
  auto engine = std::make_unique<fl::Engine>(model().name());
  const auto add_terms = [](fl::Variable& into, const elsie::fuzzy::Variable& from) {
    for (const elsie::fuzzy::Term& term : from.terms) {
      const auto& p = term.set.points;
      // Shapes that a user of fuzzylite would use: its discrete shape is slower.
      if (p.size() == 3 && p[0].degree == 0 && p[1].degree == 1 && p[2].degree == 0) {
        into.addTerm(new fl::Triangle(term.name, p[0].x, p[1].x, p[2].x));
      } else if (p.size() == 2 && p[0].degree == 0) {
        into.addTerm(new fl::Ramp(term.name, p[0].x, p[1].x));
      } else if (p.size() == 2) {
        into.addTerm(new fl::Ramp(term.name, p[1].x, p[0].x));
      } else {
        std::vector<fl::Discrete::Pair> pairs;
        for (const auto& point : p) {
          pairs.emplace_back(point.x, point.degree);
        }
        into.addTerm(new fl::Discrete(term.name, pairs));
      }
    }
  };
  for (const elsie::fuzzy::Variable& input : model().inputs()) {
    auto* variable = new fl::InputVariable(input.name, input.range.low, input.range.high);
    add_terms(*variable, input);
    engine->addInputVariable(variable);
  }
  for (const elsie::fuzzy::OutputVariable& output : model().outputs()) {
    auto* variable = new fl::OutputVariable(output.name, output.range.low, output.range.high);
    add_terms(*variable, output);
    variable->setDefuzzifier(new fl::Centroid(resolution));
    variable->setAggregation(new fl::Maximum);
    engine->addOutputVariable(variable);
  }
  auto* rules = new fl::RuleBlock("rules");
  rules->setConjunction(new fl::Minimum);
  rules->setDisjunction(new fl::Maximum);
  rules->setImplication(new fl::Minimum);
  rules->setActivation(new fl::General);
  for (const elsie::fuzzy::Rule& rule : model().rules()) {
    std::string text;
    for (const char c : rule.text) {  // blanks around parentheses, keywords in lower case
      text += c == '(' ? std::string("( ") : c == ')' ? std::string(" )") : std::string(1, c);
    }
    for (const auto& [upper, lower] :
         {std::pair{"IF ", "if "}, std::pair{" IS ", " is "}, std::pair{" AND ", " and "},
          std::pair{" OR ", " or "}, std::pair{" THEN ", " then "}}) {
      for (std::size_t at = 0; (at = text.find(upper, at)) != std::string::npos;) {
        text.replace(at, std::string(upper).size(), lower);
      }
    }
    rules->addRule(fl::Rule::parse(text, engine.get()));
  }
  engine->addRuleBlock(rules);
  return engine;
}

void BM_elsie(benchmark::State& state) {
  Workspace workspace;
  std::size_t i = 0;
  for (auto _ : state) {
    const Input& input = inputs()[i++ % inputs().size()];
    const double values[] = {input.range, input.azimuth};
    double speed = 0.0;
    model().evaluate(values, {&speed, 1}, workspace);
    benchmark::DoNotOptimize(speed);
  }
}
BENCHMARK(BM_elsie);

void BM_fuzzylite(benchmark::State& state) {
  const auto engine = oracle(static_cast<int>(state.range(0)));
  fl::InputVariable* range = engine->getInputVariable(0);
  fl::InputVariable* azimuth = engine->getInputVariable(1);
  fl::OutputVariable* speed = engine->getOutputVariable(0);
  std::size_t i = 0;
  for (auto _ : state) {
    const Input& input = inputs()[i++ % inputs().size()];
    range->setValue(input.range);
    azimuth->setValue(input.azimuth);
    engine->process();
    benchmark::DoNotOptimize(speed->getValue());
  }
}
BENCHMARK(BM_fuzzylite)->Arg(100)->Arg(1000);

/// The largest difference between the two over all inputs.
double disagreement(int resolution) {
  const auto engine = oracle(resolution);
  Workspace workspace;
  double largest = 0.0;
  for (const Input& input : inputs()) {
    const double values[] = {input.range, input.azimuth};
    double speed = 0.0;
    model().evaluate(values, {&speed, 1}, workspace);
    engine->getInputVariable(0)->setValue(input.range);
    engine->getInputVariable(1)->setValue(input.azimuth);
    engine->process();
    largest = std::max(largest, std::abs(speed - engine->getOutputVariable(0)->getValue()));
  }
  return largest;
}

/// Stores the times for the ratios, and prints them as usual.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration) {
        times_.emplace_back(run.benchmark_name(), run.GetAdjustedCPUTime());
      }
    }
    ConsoleReporter::ReportRuns(runs);
  }

  /// The best processor time of all repetitions.
  double time(const std::string& name) const {
    double best = 0.0;
    for (const auto& [run, time] : times_) {
      if (run.rfind(name, 0) == 0 && (run.size() == name.size() || run[name.size()] == '/') &&
          (best == 0.0 || time < best)) {
        best = time;
      }
    }
    return best;
  }

 private:
  std::vector<std::pair<std::string, double>> times_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  for (const int resolution : {100, 1000}) {
    std::printf("largest difference to fuzzylite at resolution %d: %.4f rad/s\n", resolution,
                disagreement(resolution));
  }
  const elsie::fuzzy::Range range = model().outputs()[0].range;
  if (disagreement(1000) > 0.005 * (range.high - range.low)) {
    std::printf("The two do not compute the same: no comparison.\n");
    return 1;
  }
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  const double ours = reporter.time("BM_elsie");
  for (const char* resolution : {"100", "1000"}) {
    const double theirs = reporter.time(std::string("BM_fuzzylite/") + resolution);
    if (ours > 0.0 && theirs > 0.0) {
      std::printf("faster than fuzzylite at resolution %s: %.1f times\n", resolution,
                  theirs / ours);
    }
  }
}
