// Measures in Python.
#include "elsie/api/measure.h"

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"
#include "elsie/base/words.h"

#include "kinds.h"
#include "world_view.h"

namespace elsie::python {
namespace {

class ScriptedMeasure : public ScriptedPlugin<Measure> {
 public:
  explicit ScriptedMeasure(const ScriptClassRef& of) : ScriptedPlugin(of) {
    run({}, [&] {
      observe_ = method("observe");
      report_ = method("report");
      equipped_ = method("equipped");
      now_ = py::cast(made<WorldNow>());
      lends_ = now_.cast<WorldNow*>();
    });
  }
  ~ScriptedMeasure() override { drop({&observe_, &report_, &equipped_, &now_}); }

  void equipped(const Observation& start) override {
    if (!equipped_) return;
    run(equipped_, [&] {
      const Lending lending(*lends_->observation, start);
      equipped_(now_);
    });
  }
  std::vector<Quantity> quantities() const override {
    return run({}, [&] {
      py::object given = self().attr("quantities");
      if (PyCallable_Check(given.ptr())) given = given();
      std::vector<Quantity> all;
      for (const auto& [name, facts] : given.cast<py::dict>()) {
        const auto [unit, meaning] = facts.cast<std::pair<std::string, std::string>>();
        all.push_back({name.cast<std::string>(), unit, meaning});
      }
      return all;
    });
  }
  void observe(const Observation& now) override {
    run(observe_, [&] {
      const Lending lending(*lends_->observation, now);
      observe_(now_);
    });
  }
  void report(const RunEnd& end, std::span<std::optional<double>> values) const override {
    const std::vector<Quantity> known = quantities();
    run(report_, [&] {
      if (known.size() != values.size()) {
        throw base::Error("quantities names " + base::counted(known.size(), "value") +
                          " now, and named " + std::to_string(values.size()) +
                          " before the run; expected the same ones at all times");
      }
      const py::object told =
          py::module_::import("elsie.plugins").attr("End")(to_string(end.outcome), end.time_s);
      for (const auto& [key, value] : report_(told).cast<py::dict>()) {
        const auto name = key.cast<std::string>();
        std::vector<std::string> names;
        std::size_t place = known.size();
        for (std::size_t i = 0; i < known.size(); ++i) {
          if (known[i].name == name) place = i;
          names.push_back(known[i].name);
        }
        if (place == known.size()) {
          throw base::Error("report() gives '" + name + "', which is none of its quantities" +
                            base::near_or_all(name, names, "there are"));
        }
        if (!value.is_none()) values[place] = value.cast<double>();
      }
    });
  }

 private:
  py::object observe_, report_, equipped_, now_;
  WorldNow* lends_ = nullptr;
};

}  // namespace

std::unique_ptr<Component> make_measure(const ScriptClassRef& of) {
  return make_scripted<ScriptedMeasure>(of);
}

}  // namespace elsie::python
