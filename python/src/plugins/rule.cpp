// Rules in Python.
#include "elsie/api/rule.h"

#include <string>

#include <pybind11/stl.h>

#include "kinds.h"
#include "world_view.h"

namespace elsie::python {
namespace {

using Changing = Lent<WorldChanges>;

class ScriptedRule : public ScriptedPlugin<Rule> {
 public:
  explicit ScriptedRule(const ScriptClassRef& of) : ScriptedPlugin(of) {
    run({}, [&] {
      apply_ = method("apply");
      equipped_ = method("equipped");
      now_ = py::cast(made<WorldNow>());
      lends_ = now_.cast<WorldNow*>();
      world_ = py::cast(changing_);
    });
  }
  ~ScriptedRule() override { drop({&apply_, &equipped_, &now_, &world_}); }

  void equipped(const Observation& start) override {
    if (!equipped_) return;
    run(equipped_, [&] {
      const Lending lending(*lends_->observation, start);
      equipped_(now_);
    });
  }
  void apply(const Observation& now, WorldChanges& world) override {
    run(apply_, [&] {
      const Lending lending(*lends_->observation, now);
      const Lending changing(*changing_, world);
      apply_(now_, world_);
    });
  }

 private:
  LentTo<WorldChanges> changing_ = std::make_shared<Changing>();
  py::object apply_, equipped_, now_, world_;
  WorldNow* lends_ = nullptr;
};

}  // namespace

void bind_rules(py::module_& module) {
  py::class_<Changing, LentTo<WorldChanges>>(module, "WorldChanges",
                                             "What a rule answers, during apply().")
      .def(
          "edit",
          [](Changing& world, std::string path, std::string value) {
            world->edit(std::move(path), std::move(value));
          },
          py::arg("path"), py::arg("value"),
          "An edit before the next step, as of `elsie run --at`: edit(\"robot[r1]/@energy\", "
          "\"50\").")
      .def(
          "set",
          [](Changing& world, std::string path, double value) {
            world->set(std::move(path), value);
          },
          py::arg("path"), py::arg("value"), "edit() with a number.")
      .def(
          "add",
          [](Changing& world, const std::string& list, std::string element) {
            world->add(list, std::move(element));
          },
          py::arg("list"), py::arg("element"), "add(\"obstacle\", \"<static_box/>\")")
      .def(
          "remove", [](Changing& world, const std::string& path) { world->remove(path); },
          py::arg("path"), "remove(\"obstacle[b1]\")")
      .def(
          "place",
          [](Changing& world, const std::string& what, double x, double y, double heading_rad) {
            world->place(what, {x, y, heading_rad});
          },
          py::arg("what"), py::arg("x"), py::arg("y"), py::arg("heading_rad") = 0.0,
          "Puts \"robot[r1]\", \"resource[food]\" or \"obstacle[b1]\" there at rest.")
      .def(
          "has_room",
          [](Changing& world, const std::string& what, double x, double y, double heading_rad) {
            return world->has_room(what, {x, y, heading_rad});
          },
          py::arg("what"), py::arg("x"), py::arg("y"), py::arg("heading_rad") = 0.0,
          "Whether place() would find room.")
      .def(
          "raise_event",
          [](Changing& world, const std::string& name, const std::string& robot) {
            world->raise({name}, robot);
          },
          py::arg("name"), py::arg("robot") = "", "Raises an event that `raises` declares.")
      .def(
          "succeed", [](Changing& world, std::string reason) { world->succeed(std::move(reason)); },
          py::arg("reason"), "Ends the run: \"all sheep are in the fold\".")
      .def(
          "fail", [](Changing& world, std::string reason) { world->fail(std::move(reason)); },
          py::arg("reason"), "Ends the run as a failure: \"a sheep is lost\".");
}

std::unique_ptr<Component> make_rule(const ScriptClassRef& of) {
  return make_scripted<ScriptedRule>(of);
}

}  // namespace elsie::python
