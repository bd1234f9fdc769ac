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

TEST_CASE("elsie page refuses what it cannot do, in a sentence and with code 2") {
  Workplace here;
  here.elsie("run worlds/open_arena.xml --duration 1 --record run.mcap --quiet");
  here.write("notes.html", "my notes");
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
      {"run.mcap --megabytes 0.1", "--megabytes"},
  }));
  CAPTURE(arguments);
  const auto refused = here.elsie("page " + arguments);
  CHECK(refused.exit_code == 2);
  CHECK(refused.out.empty());
  CHECK_THAT(refused.err, Catch::Contains(sentence));
  CHECK(here.read("notes.html") == "my notes");
}
