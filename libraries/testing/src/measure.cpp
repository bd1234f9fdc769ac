#include "elsie/testing/measure.h"

#include <algorithm>
#include <stdexcept>

#include "made.h"

namespace elsie::testing {

Measure::Measure(const std::string& name, const Settings& settings, const Elements& elements)
    : Measure(Plugins::found(), name, settings, elements) {}

Measure::Measure(const Plugins& plugins, const std::string& name, const Settings& settings,
                 const Elements& elements)
    : plugins_(plugins),
      declaration_(&plugins_.declaration(PluginKind::measure, name)),
      object_(make<elsie::Measure>(plugins_, *declaration_, settings, elements,
                                   [](elsie::Measure&) {})) {}

void Measure::observe(const Scene& now) {
  if (!equipped_) {
    equip(now);
  }
  if (!reset_) {
    reset();
  }
  object_->observe(now.observation());
  time_s_ = now.time_s();
}

std::vector<Quantity> Measure::quantities() const {
  if (!equipped_) {
    throw std::logic_error("the measure has not been equipped: observe() or equip() comes first");
  }
  return object_->quantities();
}

std::optional<double> Measure::value(const std::string& name, RunEnd::Outcome outcome) const {
  const std::vector<Quantity> all = quantities();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Quantity& quantity) { return quantity.name == name; });
  if (found == all.end()) {
    std::string there;
    for (const Quantity& quantity : all) {
      there += (there.empty() ? "'" : ", '") + quantity.name + "'";
    }
    throw std::invalid_argument("the measure has no value '" + name + "'; there are " + there);
  }
  std::vector<std::optional<double>> values(all.size());
  object_->report({outcome, time_s_}, values);
  return values[static_cast<std::size_t>(found - all.begin())];
}

void Measure::reset() {
  Random random(1);
  object_->reset(random);
  time_s_ = 0.0;
  reset_ = true;
}

void Measure::equip(const Scene& start) {
  object_->equipped(start.observation());
  equipped_ = true;
}

}  // namespace elsie::testing
