// Behaviours in Python.
#include "elsie/api/behavior.h"

#include <cmath>

#include <pybind11/numpy.h>

#include "elsie/base/error.h"

#include "kinds.h"
#include "motion.h"
#include "perception.h"
#include "scripted.h"

namespace elsie::python {
namespace {

class ScriptedBehavior : public ScriptedPlugin<Behavior> {
 public:
  explicit ScriptedBehavior(ScriptClassRef of) : ScriptedPlugin(std::move(of)) {
    run({}, [&] {
      respond_ = method("respond");
      equipped_ = method("equipped");
      rate_ = method("rate");
      only_acts_ = this->of().declared["only_acts"].cast<bool>();
      now_ = py::cast(made<Now>());
      lends_ = now_.cast<Now*>();
    });
  }
  ~ScriptedBehavior() override { drop({&respond_, &equipped_, &rate_, &now_}); }

  void equipped(const Perception& example) override {
    if (!equipped_) return;
    run(equipped_, [&] {
      const Now::Call call(*lends_, example);
      equipped_(now_);
    });
  }

  Response respond(const Perception& now) override {
    return run(respond_, [&] {
      const Now::Call call(*lends_, now);
      PyObject* const argument = now_.ptr();
      const auto answer = py::reinterpret_steal<py::object>(
          PyObject_Vectorcall(respond_.ptr(), &argument, 1, nullptr));
      if (!answer) throw py::error_already_set();
      return as_response(answer, only_acts_);
    });
  }

  void rate(const Perception& now, const Response& given, std::span<const Motion> candidates,
            std::span<double> desirability) const override {
    if (!rate_) return Behavior::rate(now, given, candidates, desirability);
    run(rate_, [&] {
      const Now::Call call(*lends_, now);
      py::array_t<double> motions({candidates.size(), std::size_t{3}});
      double* to = motions.mutable_data();
      for (const Motion& each : candidates) {
        *to++ = each.forward, *to++ = each.lateral, *to++ = each.turn;
      }
      const auto rated = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(
          rate_(now_, given, motions));
      if (!rated || rated.size() != static_cast<py::ssize_t>(candidates.size())) {
        PyErr_Clear();
        throw base::Error("rate() should return a number for each of the " +
                          std::to_string(candidates.size()) + " candidates");
      }
      std::copy_n(rated.data(), candidates.size(), desirability.begin());
    });
  }

 private:
  py::object respond_, equipped_, rate_;
  py::object now_;
  Now* lends_ = nullptr;
  bool only_acts_ = false;
};

}  // namespace

std::unique_ptr<Component> make_behavior(const ScriptClassRef& of) {
  return make_scripted<ScriptedBehavior>(of);
}

}  // namespace elsie::python
