// Coordinators in Python.
#include "coordinator.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "elsie/api/coordinator.h"
#include "elsie/base/error.h"

#include "kinds.h"
#include "motion.h"
#include "perception.h"
#include "scripted.h"

namespace elsie::python {
namespace {

using LentMember = Lent<Member>;

class ScriptedCoordinator : public ScriptedPlugin<Coordinator> {
 public:
  explicit ScriptedCoordinator(ScriptClassRef of) : ScriptedPlugin(std::move(of)) {
    run({}, [&] {
      coordinate_ = method("coordinate");
      equipped_ = method("equipped");
      status_ = method("status");
      members_ = py::list();
      now_ = py::cast(made<Now>());
      lends_ = now_.cast<Now*>();
    });
  }
  ~ScriptedCoordinator() override { drop({&coordinate_, &equipped_, &status_, &members_, &now_}); }

  void equipped(std::span<const Member> members, const Perception& example) override {
    if (!equipped_) return;
    run(equipped_, [&] {
      const Now::Call call(*lends_, example);
      std::vector<std::string> names;
      for (const Member& each : members) names.emplace_back(each.name());
      equipped_(names, now_);
    });
  }

  Motion coordinate(std::span<Member> members, const Perception& now) override {
    return run(coordinate_, [&] {
      const Now::Call call(*lends_, now);
      const MembersCall lent(*this, members);
      const py::object answer = coordinate_(members_, now_);
      if (const Motion* const motion = as_motion(answer)) return *motion;
      throw base::Error("coordinate() returned " + py::repr(answer).cast<std::string>() +
                        "; expected elsie.Motion");
    });
  }

  Status status() const override {
    if (!status_) return Status::running;
    return run(status_, [&] { return status_().cast<Status>(); });
  }

 private:
  /// Lends the members.
  class MembersCall {
   public:
    MembersCall(ScriptedCoordinator& of, std::span<Member> members) : of_(of) {
      if (of.lent_.size() != members.size()) {
        of.lent_.clear();
        of.members_ = py::list();
        for (std::size_t i = 0; i < members.size(); ++i) {
          of.lent_.push_back(std::make_shared<LentMember>());
          of.members_.attr("append")(of.lent_.back());
        }
      }
      for (std::size_t i = 0; i < members.size(); ++i) of.lent_[i]->at = &members[i];
    }
    ~MembersCall() {
      for (const auto& each : of_.lent_) each->at = nullptr;
    }
    MembersCall(const MembersCall&) = delete;
    MembersCall& operator=(const MembersCall&) = delete;

   private:
    ScriptedCoordinator& of_;
  };

  py::object coordinate_, equipped_, status_;
  py::object members_, now_;
  std::vector<std::shared_ptr<LentMember>> lent_;
  Now* lends_ = nullptr;
};

template <class Value>
void bind_trace(py::class_<LentMember, LentTo<Member>>& member, const char* name,
                Value TraceRow::*value, const char* meaning) {
  member.def_property(
      name, [value](LentMember& self) { return self->trace.*value; },
      [value](LentMember& self, const Value& to) { self->trace.*value = to; }, meaning);
}

}  // namespace

void bind_members(py::module_& module) {
  py::class_<LentMember, LentTo<Member>> member(
      module, "Member", "A behaviour as its coordinator sees it, during coordinate().");
  member
      .def_property_readonly(
          "name", [](LentMember& self) { return self->name(); }, "Its id in the world file.")
      .def_property_readonly(
          "priority", [](LentMember& self) { return self->priority(); }, "as the user set it")
      .def(
          "respond",
          [](LentMember& self) -> Response {
            try {
              return self->respond();
            } catch (...) {
              keep_passing();
              throw;
            }
          },
          "Asks the behaviour; it runs at most once in a control period.")
      .def(
          "published",
          [](LentMember& self, const std::string& name) {
            const auto all = self->published();
            const auto found =
                std::find_if(all.begin(), all.end(),
                             [&](const PublishedNumber& each) { return each.name == name; });
            if (found == all.end()) {
              throw py::key_error("the behaviour '" + std::string(self->name()) +
                                  "' publishes no number '" + name + "'");
            }
            return self->published(static_cast<std::size_t>(found - all.begin()));
          },
          py::arg("name"), "A number that the behaviour publishes; NaN: there is none now.")
      .def_property_readonly(
          "asked", [](LentMember& self) { return self->trace.asked; },
          "whether respond() was called");
  bind_trace(member, "weight", &TraceRow::weight, "The factor of its command in the sum.");
  bind_trace(member, "share", &TraceRow::share, "Its part in the result, in [0, 1].");
  bind_trace(member, "reason", &TraceRow::reason, "Why, in one or two words.");
  bind_trace(member, "inhibited_by", &TraceRow::inhibited_by,
             "The index of the member that silenced it; -1: none.");
}

std::unique_ptr<Component> make_coordinator(const ScriptClassRef& of) {
  return make_scripted<ScriptedCoordinator>(of);
}

}  // namespace elsie::python
