// Lets a program of any language decide between behaviours, by lines of JSON in lock-step:
// docs/any-language.md.
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

#include <elsie/api/coordinator.h>

#include "client.h"

namespace {

const char* name_of(elsie::Status status) {
  return status == elsie::Status::running   ? "running"
         : status == elsie::Status::success ? "success"
                                            : "failure";
}

class ArbiterRemote final : public elsie::Coordinator, public remote::Client {
 public:
  void configured() override { require_program(); }
  void equipped(std::span<const elsie::Member>, const elsie::Perception&) override { tell_facts(); }
  void reset(elsie::Random& random) override {
    begin_run(random);
    status_ = elsie::Status::running;
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    remote::Json line = remote::perceived(now);
    remote::Json& answers = line["members"] = remote::Json::array();
    for (elsie::Member& member : members) {
      const elsie::Response& response = member.respond();
      answers.push_back({{"name", std::string(member.name())},
                         {"priority", member.priority()},
                         {"motion", remote::motion(response.command)},
                         {"activation", response.activation},
                         {"strength", response.strength},
                         {"status", name_of(response.status)}});
      member.trace.reason = "remote";
    }
    elsie::Motion decided;
    ask([&] { return remote::facts(now, "coordinator"); }, line,
        [&](remote::Answer& answer) {
          const auto motion = answer.motion(now.self().wheels);
          const std::vector<double> weights = answer.weights("weights", members.size());
          const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
          for (std::size_t i = 0; i < weights.size() && sum > 0.0; ++i) {
            members[i].trace.weight = weights[i];
            members[i].trace.share = weights[i] / sum;
            decided += members[i].trace.share * members[i].trace.command;
          }
          if (motion) decided = *motion;
          status_ = answer.status();
        });
    return decided;
  }
  elsie::Status status() const override { return status_; }

 private:
  elsie::Status status_ = elsie::Status::running;
};

}  // namespace

ELSIE_COORDINATOR(ArbiterRemote, "arbiter_remote",
                  "A program of any language decides, by lines of JSON in lock-step",
                  REMOTE_PARAMETERS);
