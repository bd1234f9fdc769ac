#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "elsie/plugin/parameters.h"
#include "elsie/testing/measure.h"

#include "text.h"
#include "trial.h"

namespace elsie::testing {
namespace {

class MeasureTrial final : public Trial {
 public:
  explicit MeasureTrial(const TrialSetting& setting)
      : input_(setting.input),
        settings_(setting.plugins.completed(setting.declaration, setting.settings)),
        measure_(setting.plugins, setting.declaration.name, setting.settings, setting.elements) {
    equipping([&] { measure_.equip(input_.watched.front()); });
  }

  Component& object() override { return *measure_; }
  void reset(std::uint64_t /*seed*/) override {
    measure_.reset();
    measure_->notes();
    measure_->curves();
    check_quantities();
    std::vector<std::optional<double>> values(quantities_.size());
    measure_->report({}, values);  // allowed before the first instant
    measure_.observe(input_.watched.front());
  }
  bool take_over(Trial& /*before*/) override { return false; }  // measures are not replaced
  void configure_again() override {
    plugin::apply_parameters(measure_.declaration(), *measure_, settings_);
    equipping([&] { measure_.equip(input_.watched.front()); });
  }

  void step(std::size_t step, Answer& answer) override {
    now_ = instant(input_, step);
    measure_.observe(now_);
    const RunEnd end{RunEnd::Outcome::running, now_.time_s()};
    std::vector<std::optional<double>> values(quantities_.size()), again(quantities_.size());
    measure_->report(end, values);
    measure_->report(end, again);
    if (values != again) {
      throw Wrong("report() answers differently when it is called once more");
    }
    answer.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i]) {
        require_finite(titles_[i].c_str(), *values[i]);
      }
      answer.add(titles_[i].c_str(), values[i].value_or(0.0));
      answer.add("whether there is a value", values[i].has_value());
    }
  }

 private:
  void check_quantities() {
    std::vector<Quantity> quantities = measure_.quantities();
    if (!titles_.empty() && quantities != quantities_) {
      throw Wrong("quantities() differs from run to run");
    }
    if (quantities.empty()) {
      throw Wrong("quantities() is empty: it has nothing to report");
    }
    std::set<std::string> names;
    titles_.clear();
    for (const Quantity& quantity : quantities) {
      const std::string title =
          quantity.name.empty() ? "its own value" : "its value '" + quantity.name + "'";
      if (!names.insert(quantity.name).second) {
        throw Wrong("two of its values have the name '" + quantity.name + "'");
      }
      if (quantity.meaning.find_first_not_of(' ') == std::string::npos) {
        throw Wrong(title + " has no meaning; say in a line what it is");
      }
      titles_.push_back(title);
    }
    quantities_ = std::move(quantities);
  }

  const Input& input_;
  Settings settings_;
  Measure measure_;
  Scene now_;
  std::vector<Quantity> quantities_;
  std::vector<std::string> titles_;  // names of the values in findings
};

}  // namespace

std::unique_ptr<Trial> make_measure_trial(const TrialSetting& setting) {
  return std::make_unique<MeasureTrial>(setting);
}

}  // namespace elsie::testing
