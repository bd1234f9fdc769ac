#include <catch2/catch.hpp>

#include "elsie/messages/heading.h"
#include "elsie/messages/say.h"

#include "shipped.h"
#include "situation.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// What a response says; null: silence.
const PlaceMessage* said(const Response& response) {
  REQUIRE(response.acts.size() == 1);
  const auto& command = *static_cast<const SayCommand*>(response.acts[0].command());
  return command.message ? static_cast<const PlaceMessage*>(command.message->content()) : nullptr;
}

}  // namespace

TEST_CASE("Without an event it always says where it is") {
  Situation now;
  const Response response =
      test::make<Behavior>(PluginKind::behavior, "say")->respond(now.at(1, 2, 0).perception());
  REQUIRE(said(response));
  CHECK(said(response)->x == 1.0);
  CHECK(said(response)->y == 2.0);
}

TEST_CASE("With an event it says for a while where it was then") {
  const auto behavior = test::make<Behavior>(PluginKind::behavior, "say",
                                             {{"event", std::string("taken")}, {"lasts", 3.0}});
  Situation before;
  CHECK(behavior->respond(before.at(0, 0, 0).perception()).acts.empty());
  Situation then;
  then.at(1, 2, 0).time(10.0).event("taken");
  CHECK(said(behavior->respond(then.perception())));
  Situation later;
  later.at(5, 5, 0).time(13.0);
  const Response response = behavior->respond(later.perception());
  REQUIRE(said(response));
  CHECK(said(response)->x == 1.0);
  CHECK_FALSE(said(behavior->respond(later.time(13.01).perception())));
  // It has commanded silence once, and leaves the actuator to others.
  CHECK(behavior->respond(later.time(13.02).perception()).acts.empty());
}

TEST_CASE("It may say which way it looks now instead") {
  const auto behavior = test::make<Behavior>(
      PluginKind::behavior, "say",
      {{"what", std::string("heading")}, {"event", std::string("taken")}, {"lasts", 3.0}});
  const auto heading_deg = [&](const Situation& now) {
    const Response response = behavior->respond(now.perception());
    REQUIRE(response.acts.size() == 1);
    const auto& command = *static_cast<const SayCommand*>(response.acts[0].command());
    REQUIRE(command.message->kind() == ReadingKind::of<HeadingMessage>());
    return degrees(static_cast<const HeadingMessage*>(command.message->content())->heading_rad);
  };
  CHECK(heading_deg(Situation().at(1, 2, 60).time(10.0).event("taken")) == Approx(60.0));
  CHECK(heading_deg(Situation().at(1, 2, -90).time(13.0)) == Approx(-90.0));
}
