#include "elsie/neural/assessment.h"

#include <algorithm>
#include <cmath>

#include "text.h"

namespace elsie::neural {
namespace {

struct Range {
  double low = 0.0;
  double high = 0.0;

  void include(double value, bool first) {
    low = first ? value : std::min(low, value);
    high = first ? value : std::max(high, value);
  }
  double width() const { return high - low; }
};

}  // namespace

Assessment assess(const Network& network, const TrainingSet& samples) {
  Assessment assessment;
  const std::size_t outputs = samples.outputs();
  assessment.answers.resize(samples.size() * outputs);
  assessment.flat.resize(outputs);
  Workspace workspace(network);
  std::vector<Range> answered(outputs), wanted(outputs);
  double sum = 0.0;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const std::span<double> answer = std::span(assessment.answers).subspan(s * outputs, outputs);
    const std::span<const double> targets = samples.targets(s);
    network.evaluate(samples.inputs(s), answer, workspace);
    double squares = 0.0;
    bool missed = false;
    for (std::size_t k = 0; k < outputs; ++k) {
      squares += (targets[k] - answer[k]) * (targets[k] - answer[k]);
      missed |= std::abs(targets[k] - answer[k]) > kMissed;
      answered[k].include(answer[k], s == 0);
      wanted[k].include(targets[k], s == 0);
    }
    sum += 0.5 * squares;
    assessment.missed += missed ? 1 : 0;
  }
  assessment.error = samples.size() > 0 ? sum / static_cast<double>(samples.size()) : 0.0;
  std::size_t varied = 0, flat = 0;
  for (std::size_t k = 0; k < outputs; ++k) {
    if (wanted[k].width() > 0.0) {
      ++varied;
      assessment.flat[k] = answered[k].width() < kFlat * wanted[k].width();
      flat += assessment.flat[k] ? 1 : 0;
    }
  }
  assessment.untrained = varied > 0 && flat == varied;
  return assessment;
}

std::string summary(const Training& training, const Assessment& assessment) {
  return "mean error " + rough_text(assessment.error) + " after " +
         counted(training.presentations, "presentation") +
         (training.ending == Ending::threshold ? ", below the threshold"
          : training.ending == Ending::stopped ? ", where it was stopped"
                                               : "");
}

std::string warning(const Assessment& assessment, std::span<const std::string> outputs) {
  if (assessment.answers.empty()) {
    return "";
  }
  if (assessment.untrained) {
    std::string answer;
    for (const double value : assessment.answer(0)) {
      answer += (answer.empty() ? "" : ", ") + rough_text(value);
    }
    return "The network is untrained: it sits on a plateau and gives the same output whatever the "
           "input, (" +
           answer + "). Try another seed, or fewer hidden layers.";
  }
  std::string text;
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    if (assessment.flat[k]) {
      text += (text.empty() ? "" : " ") + std::string("The output for '") + outputs[k] +
              "' is untrained: it is " + rough_text(assessment.answer(0)[k]) +
              " whatever the input.";
    }
  }
  if (assessment.missed > 0) {
    text += (text.empty() ? "" : " ") + std::string("The network has not learned ") +
            std::to_string(assessment.missed) + " of " +
            counted(assessment.answers.size() / outputs.size(), "sample") +
            ": an answer to it differs from its target by more than " + rough_text(kMissed) + ".";
  }
  return text;
}

}  // namespace elsie::neural
