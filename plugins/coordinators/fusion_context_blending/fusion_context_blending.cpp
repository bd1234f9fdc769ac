// Context-dependent blending (Saffiotti, 1997): fuzzy rules give the degree to which each behaviour
// applies now, and these degrees weight the behaviours' fuzzy sets before they are combined and
// defuzzified.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/inference.h>
#include <elsie/api/remember.h>
#include <elsie/base/near_name.h>
#include <elsie/fuzzy/fcl.h>

#include "perception_inputs.h"
#include "set_fusion.h"

namespace {

namespace fuzzy = elsie::fuzzy;

class FusionContextBlending final : public SetFusion,
                                    public elsie::Remembers,
                                    public elsie::Infers {
 public:
  FusionContextBlending() : SetFusion("clip", "gate") {}

  elsie::FilePath model;
  std::string block;

  void configured() override {
    SetFusion::configured();
    rules_.emplace(fuzzy::read_fcl(model.path, block));
    undecided_.clear();
    for (std::size_t i = 0; i < rules_->outputs().size(); ++i) {
      const fuzzy::OutputVariable& output = rules_->outputs()[i];
      undecided_.push_back(output.keeps_last && !output.default_value ? rules_->undecided_at(i)
                                                                      : std::nullopt);
    }
    if (!members_.empty()) {
      connect();
    }
  }

  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    members_.clear();
    for (const elsie::Member& member : members) {
      members_.emplace_back(member.name());
    }
    lacking_.clear();
    for (const PerceptionInput& input : perception_inputs()) {
      if (!input.available(example)) {
        lacking_.push_back(&input);
      }
    }
    connect();
  }

  void reset(elsie::Random&) override {
    has_decided_ = false;
    // NaN: outputs that keep their last value have none yet.
    std::fill(outputs_.begin(), outputs_.end(), std::numeric_limits<double>::quiet_NaN());
  }
  void remember(elsie::Memory& memory) override {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      memory(rules_->outputs()[i].name, outputs_[i]);
    }
  }

  std::vector<std::string> notes() const override;
  void list_inferences(std::vector<elsie::Inference>& list) const override {
    if (!has_decided_) {
      return;
    }
    elsie::Inference& made = list.emplace_back(elsie::Inference{model.path, block, {}, {}});
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      made.inputs.push_back({rules_->inputs()[i].name, inputs_[i]});
    }
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      made.outputs.push_back({rules_->outputs()[i].name, outputs_[i]});
    }
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    if (members.size() != members_.size()) {
      equipped(members, now);
    }
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      inputs_[i] = sources_[i]->value(now);
    }
    rules_->evaluate(inputs_, outputs_, workspace_);
    has_decided_ = true;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const double degree = contexts_[i] ? outputs_[*contexts_[i]] : 1.0;
      degrees_[i] = degree > 0.0 ? std::min(degree, 1.0) : 0.0;
    }
    weigh(members, activation_rule(), "", degrees_);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const bool unknown = contexts_[i] && std::isnan(outputs_[*contexts_[i]]);
      if (unknown && members[i].priority() > 0.0) {
        members[i].trace.reason = "no context known yet";
      }
    }
    return fuse(members, now);
  }

 private:
  void connect();

  std::optional<fuzzy::Model> rules_;
  /// For each output: inputs at which it may need a last value that it does not have.
  std::vector<std::optional<std::string>> undecided_;
  fuzzy::Workspace workspace_;
  std::vector<std::string> members_;
  std::vector<const PerceptionInput*> lacking_;       // inputs that this robot cannot perceive
  std::vector<const PerceptionInput*> sources_;       // for each input
  std::vector<std::optional<std::size_t>> contexts_;  // for each member: its output
  bool has_decided_ = false;                          // since the model or the robot changed
  std::vector<double> inputs_;
  std::vector<double> outputs_;
  std::vector<double> degrees_;  // for each member, in [0, 1]
};

/// Finds the meaning of each input and output of the model.
void FusionContextBlending::connect() {
  std::vector<std::string> problems;
  sources_.clear();
  for (const fuzzy::Variable& input : rules_->inputs()) {
    const PerceptionInput* source = find_perception_input(input.name);
    if (!source) {
      problems.push_back("its input '" + input.name + "' is nothing that a robot perceives" +
                         perception_input_hint(input.name));
    } else if (std::find(lacking_.begin(), lacking_.end(), source) != lacking_.end()) {
      problems.push_back("its input '" + input.name + "' needs " + source->needs +
                         ", and there is none");
    }
    sources_.push_back(source);
  }
  contexts_.clear();
  std::vector<bool> used(rules_->outputs().size(), false);
  for (const std::string& member : members_) {
    contexts_.push_back(rules_->output_index(member));
    if (contexts_.back()) {
      used[*contexts_.back()] = true;
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) {
      const std::string& name = rules_->outputs()[i].name;
      problems.push_back("its output '" + name + "' is the id of no behaviour of this coordinator" +
                         elsie::base::did_you_mean(name, members_));
    }
  }
  if (!problems.empty()) {
    std::string all = "the fuzzy model '" + model.path + "' does not fit: ";
    for (std::size_t i = 0; i < problems.size(); ++i) {
      all += (i > 0 ? "; " : "") + problems[i];
    }
    members_.clear();
    throw std::invalid_argument(all);
  }
  has_decided_ = false;
  inputs_.assign(sources_.size(), 0.0);
  outputs_.assign(used.size(), std::numeric_limits<double>::quiet_NaN());
  degrees_.assign(members_.size(), 0.0);
}

std::vector<std::string> FusionContextBlending::notes() const {
  std::vector<std::string> notes;
  for (const elsie::base::Problem& note : rules_->notes()) {
    notes.push_back(note.text());
  }
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (!contexts_[i]) {
      notes.push_back("the fuzzy model '" + model.path + "' has no output '" + members_[i] +
                      "': this behaviour always applies");
    } else if (const auto& output = rules_->outputs()[*contexts_[i]]; output.terms.size() == 1) {
      notes.push_back("the output '" + output.name + "' of the fuzzy model '" + model.path +
                      "' has one term only, so that its value is the same however weakly a rule "
                      "fires; add a term for 'does not apply' and rules for it");
    }
    if (contexts_[i] && undecided_[*contexts_[i]]) {
      notes.push_back("the output '" + members_[i] + "' of the fuzzy model '" + model.path +
                      "' has DEFAULT := NC and no first value, and no rule decides it at " +
                      *undecided_[*contexts_[i]] +
                      ": until a rule has, the behaviour does not apply; write, for example, "
                      "DEFAULT := 0 | NC if that is meant, or DEFAULT := 1 | NC");
    }
  }
  return notes;
}

}  // namespace

ELSIE_COORDINATOR(
    FusionContextBlending, "fusion_context_blending",
    "Fuzzy rules say how far each behaviour applies now; their fuzzy sets are blended accordingly",
    elsie::parameter(
        "model", &FusionContextBlending::model,
        {.meaning = "fuzzy model (FCL) of the context rules: inputs are what the robot "
                    "perceives, outputs, in 0 to 1, are ids of behaviours",
         .required = true}),
    elsie::parameter("block", &FusionContextBlending::block,
                     {.meaning = "function block of the model, if the file has several"}),
    elsie::parameter("combination", &FusionContextBlending::combination, combination_facts()),
    elsie::parameter("weighting", &FusionContextBlending::weighting, weighting_facts()),
    elsie::parameter("defuzzification", &FusionContextBlending::defuzzification,
                     defuzzification_facts()),
    elsie::parameter("conflict", &FusionContextBlending::conflict, conflict_facts()),
    elsie::parameter("activation", &FusionContextBlending::activation, activation_facts()));
