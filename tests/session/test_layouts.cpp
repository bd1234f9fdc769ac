// Sessions with a world whose layouts follow the run's seed.
#include "session.h"

using namespace elsie;
using namespace elsie::test;

namespace {

constexpr const char* kScattered = R"(<world format="1">
  <layouts>
    <scatter id="c" count="4"><static_box/></scatter>
    <scatter id="start"><robot id="r1"/></scatter>
  </layouts>
  <limits time="2"/>
</world>
)";

}  // namespace

TEST_CASE("A reset with another seed draws the layouts anew, and one with the same does not") {
  Session session;
  const Json first = session.open(kScattered);
  REQUIRE(first.contains("scene"));
  const Json other = session.ask({{"do", "reset"}, {"seed", 2}});
  CHECK(other["scene"]["boxes"] != first["scene"]["boxes"]);
  CHECK(other["text"] == kScattered);
  const Json again = session.ask({{"do", "reset"}, {"seed", 1}});
  CHECK(again["scene"]["boxes"] == first["scene"]["boxes"]);
}

TEST_CASE("An edit of a layout shows at once; one of what it has drawn is refused") {
  Session session;
  session.open(kScattered);
  const Json more = session.edit({"scatter[c]/@count=6"});
  CHECK(more["text"].get<std::string>().find("count=\"6\"") != std::string::npos);
  CHECK(more["scene"].dump().find("c6") != std::string::npos);
  const Json refused = session.edit({"obstacle[c2]/@x=0"});
  REQUIRE(refused.contains("refused"));
  CHECK(refused["refused"].dump().find("the layout 'c' draws this") != std::string::npos);
}

TEST_CASE("A run that is under way becomes what an edited layout draws") {
  Session session;
  session.open(kScattered);
  session.ask({{"do", "step"}});
  const Json more = session.edit({"scatter[c]/@count=6"});
  CHECK_FALSE(more.contains("refused"));
  CHECK(more["scene"].dump().find("c6") != std::string::npos);
}
