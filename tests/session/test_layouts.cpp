// Sessions with a world whose layouts follow the run's seed.
#include <utility>

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

TEST_CASE("A reset with another seed draws the layouts again, and one with the same does not") {
  Session session;
  const auto place_of_c1 = [&] {
    const auto snapshot = session.connection().snapshots().take();
    REQUIRE(snapshot);
    REQUIRE(snapshot->bodies.size() == 5);
    return std::pair(snapshot->bodies[1].origin[0], snapshot->bodies[1].origin[1]);
  };
  const Json first = session.open(kScattered);
  REQUIRE(first.contains("scene"));
  const auto drawn_first = place_of_c1();
  const Json other = session.ask({{"do", "reset"}, {"seed", 2}});
  CHECK(place_of_c1() != drawn_first);
  CHECK(other["text"] == kScattered);
  session.ask({{"do", "reset"}, {"seed", 1}});
  CHECK(place_of_c1() == drawn_first);
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
  session.step();
  const Json more = session.edit({"scatter[c]/@count=6"});
  CHECK_FALSE(more.contains("refused"));
  CHECK(more["scene"].dump().find("c6") != std::string::npos);
}

TEST_CASE("What is added beside layouts while a run is under way is edited and undone there") {
  Session session;
  session.open(kScattered);
  session.step();
  const Json added = session.edit({"obstacle[+]=<static_box x=\"4.9\" y=\"4.9\" length=\"0.1\"/>"});
  INFO(added.dump());
  REQUIRE_FALSE(added.contains("refused"));
  const Json moved = session.edit({"obstacle[1]/@y=4.8"});
  INFO(moved.dump());
  REQUIRE_FALSE(moved.contains("refused"));
  for (const Json& text : {added["text"], Json(kScattered)}) {
    CHECK(session.ask({{"do", "become"}, {"text", text}})["text"] == text);
  }
}

TEST_CASE("A layout that is added later follows the seed of the run, not that of the opening") {
  const std::string scatter = "<scatter id=\"c\" count=\"4\"><static_box/></scatter>";
  const auto place_of_c1 = [&](std::uint64_t opened, std::uint64_t reset) {
    Session session;
    session.ask({{"do", "open"},
                 {"text", "<world format=\"1\">\n  <robots><robot id=\"r\"/></robots>\n</world>\n"},
                 {"file", ""},
                 {"seed", opened}});
    session.ask({{"do", "reset"}, {"seed", reset}});
    session.step();  // the run is under way: it is not read again
    session.edit({"scatter[+]=" + scatter});
    const auto snapshot = session.connection().snapshots().take();
    REQUIRE(snapshot);
    REQUIRE(snapshot->bodies.size() == 5);
    return snapshot->bodies.back().origin[0];
  };
  CHECK(place_of_c1(1, 2) == place_of_c1(2, 2));
  CHECK(place_of_c1(1, 2) != place_of_c1(1, 1));
}
