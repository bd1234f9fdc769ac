// Asks a program of any language, by lines of JSON in lock-step: docs/any-language.md.
#include <elsie/api/behavior.h>

#include "client.h"

namespace {

class Remote final : public elsie::Behavior, public remote::Client {
 public:
  void configured() override { require_program(); }
  void equipped(const elsie::Perception&) override { tell_facts(); }
  void reset(elsie::Random& random) override { begin_run(random); }

  elsie::Response respond(const elsie::Perception& now) override {
    elsie::Response response;
    ask([&] { return remote::facts(now, "behavior"); }, remote::perceived(now),
        [&](remote::Answer& answer) { response = remote::response(answer, now.self().wheels); });
    return response;
  }
};

}  // namespace

ELSIE_BEHAVIOR(Remote, "remote",
               "Asks a program of any language what to do, by lines of JSON in lock-step",
               elsie::raises("remote_signal", "the program raises it"), REMOTE_PARAMETERS);
