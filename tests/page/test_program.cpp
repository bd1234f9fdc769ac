// elsie page, as a user calls it.
#include <catch2/catch.hpp>

#include "program.h"

using elsie::test::Workplace;

TEST_CASE("elsie page makes one file of a recording, of at most three megabytes") {
  Workplace here;
  here.elsie("run worlds/four_resources.xml --record four.mcap --quiet");
  const auto made = here.elsie("page four.mcap");
  CHECK(made.exit_code == 0);
  CHECK(made.err.empty());
  CHECK_THAT(made.out,
             Catch::Matches("wrote four\\.html: [012]\\.[0-9]+ MB, a pose every 0\\.1 s\n"));
  CHECK(here.read("four.html").size() < 3'000'000);
  CHECK_THAT(here.read("four.html"), Catch::Contains("success after 204.1 s"));
  CHECK(here.elsie("page four.mcap -o again.html").exit_code == 0);
  CHECK(here.read("again.html") == here.read("four.html"));
}

TEST_CASE("An image of the floor is in a page once, however often the world is edited") {
  Workplace here;
  here.elsie("picture worlds/clutter.xml --output floor.png");
  here.write("image.xml", R"(<world format="1">
  <arena length="4" width="4"/>
  <floor image="floor.png"/>
  <robots><robot id="r1"><behaviors><wander/></behaviors><coordinator><arbiter_suppression/></coordinator></robot></robots>
  <limits time="2"/>
</world>
)");
  std::string edits;
  for (const char* const at : {"0.5", "0.8", "1.1", "1.4", "1.7"}) {
    edits += std::string(" --at '") + at + ":obstacle[+]=<static_box x=\"1\" y=\"-" + at + "\"/>'";
  }
  here.sh("elsie run image.xml --record plain.mcap --quiet");
  here.sh("elsie run image.xml --record edited.mcap --quiet" + edits);
  CHECK(here.elsie("page plain.mcap").exit_code == 0);
  CHECK(here.elsie("page edited.mcap").exit_code == 0);
  CHECK(here.read("edited.html").size() <
        here.read("plain.html").size() + here.read("floor.png").size());
}

TEST_CASE("A page that cannot be as small as asked is written, and a sentence says so") {
  Workplace here;
  std::string robots;
  for (int i = 0; i < 300; ++i) {
    robots += "<robot id=\"r" + std::to_string(i) + "\" x=\"" + std::to_string(i % 20 - 9.5) +
              "\" y=\"" + std::to_string(i / 20 - 7.0) + "\"><behaviors><wander/></behaviors>" +
              "<coordinator><arbiter_suppression/></coordinator></robot>\n";
  }
  here.write("swarm.xml", R"(<world format="1">
  <arena length="22" width="22"/>
  <physics engine="planar"/>
  <robots>)" + robots + R"(</robots>
  <limits time="4"/>
</world>
)");
  here.elsie("run swarm.xml --record swarm.mcap --quiet");
  const auto made = here.elsie("page swarm.mcap --megabytes 0.2");
  CHECK(made.exit_code == 0);
  CHECK_THAT(made.out, Catch::StartsWith("wrote swarm.html: "));
  CHECK(here.read("swarm.html").size() > 200'000);
  CHECK_THAT(made.err,
             Catch::StartsWith("elsie: swarm.html has more than the 0.2 MB of --megabytes, "));
  CHECK(here.elsie("page swarm.mcap").err.empty());
}

TEST_CASE("elsie page refuses what it cannot do, in a sentence and with code 2") {
  Workplace here;
  here.elsie("run worlds/open_arena.xml --duration 1 --record run.mcap --quiet");
  here.write("notes.html", "<!doctype html>\n<html><body>my notes</body></html>\n");
  const std::string notes = here.read("notes.html");
  here.write("empty.xml", "<world format=\"1\"><limits time=\"1\"/></world>");
  here.elsie("run empty.xml --record empty.mcap --quiet");
  here.write("results.sqlite", "SQLite format 3");
  here.write("damaged.mcap", here.read("run.mcap").replace(2000, 40, std::string(40, 'x')));
  const auto [arguments, sentence] = GENERATE(table<std::string, std::string>({
      {"worlds/open_arena.xml", "'worlds/open_arena.xml' is not a recording; expected a file that"},
      {"results.sqlite", "`elsie replay DATABASE RUN --record FILE.mcap` has written"},
      {"missing.mcap", "missing.mcap"},
      {"damaged.mcap", "damaged.mcap"},
      {"run.mcap -o run.txt", "--output: a page's name must end in .html, but 'run.txt' does not"},
      {"run.mcap -o notes.html", "notes.html"},
      {"run.mcap -o no/where.html", "no/where.html"},
      {"run.mcap --megabytes 0.1", "'0.1' is not a number from 0.2 to 100"},
      {"empty.mcap", "'empty.mcap' has a run without robots; expected a recording with robots"},
  }));
  CAPTURE(arguments);
  const auto refused = here.elsie("page " + arguments);
  CHECK(refused.exit_code == 2);
  CHECK(refused.out.empty());
  CHECK_THAT(refused.err, Catch::Contains(sentence));
  CHECK(here.read("notes.html") == notes);
}

TEST_CASE("The page of a run that a plugin has ended says why") {
  Workplace here;
  here.write("fails.cpp", R"(#include <elsie/api/behavior.h>
#include <stdexcept>
class Fails final : public elsie::Behavior {
 public:
  elsie::Response respond(const elsie::Perception& now) override {
    if (now.time_s() > 0.3) throw std::runtime_error("enough is enough");
    return elsie::Motion{.forward = 0.1};
  }
};
ELSIE_BEHAVIOR(Fails, "fails", "Fails");
)");
  here.write("fails.xml",
             R"(<world format="1"><robots><robot id="r1"><behaviors><fails/></behaviors>
  <coordinator><arbiter_suppression/></coordinator></robot></robots></world>)");
  here.elsie("run fails.xml --plugin fails.cpp --record fails.mcap --quiet");
  CHECK(here.elsie("page fails.mcap").exit_code == 0);
  CHECK_THAT(here.read("fails.html"), Catch::Contains("<h1>fails</h1>"));
  CHECK_THAT(here.read("fails.html"),
             Catch::Contains("stopped after 0.3 s: plugin 'fails' of robot") &&
                 Catch::Contains("enough is enough"));
}
