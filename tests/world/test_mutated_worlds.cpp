// Worlds with random damage are read or refused, never anything else.
#include <random>

#include <catch2/catch.hpp>

#include "elsie/world/document.h"
#include "elsie/world/writer.h"

#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

class Damage {
 public:
  explicit Damage(unsigned seed) : random_(seed) {}

  std::string to(std::string text) {
    const int count = static_cast<int>(below(3)) + 1;
    for (int i = 0; i < count; ++i) {
      once(text);
    }
    return text;
  }

 private:
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  // Puts `piece` behind one of the places where `mark` stands.
  void insert_behind(std::string& text, const std::string& mark, const std::string& piece) {
    std::size_t at = text.find(mark, below(text.size()));
    at = at == std::string::npos ? text.find(mark) : at;
    if (at != std::string::npos) {
      text.insert(at + mark.size(), piece);
    }
  }

  void once(std::string& text) {
    static const std::vector<std::string> kPieces = {"<",
                                                     ">",
                                                     "/",
                                                     "\"",
                                                     "'",
                                                     "=",
                                                     "&",
                                                     "&amp;",
                                                     "<!--",
                                                     "-->",
                                                     "<![CDATA[",
                                                     "]]>",
                                                     "<?",
                                                     "nan",
                                                     "-1",
                                                     "1e999",
                                                     "\xC3",
                                                     "\n",
                                                     "</robot>",
                                                     "<robot id='r1'>",
                                                     "id=\"r1\"",
                                                     "remove=\"true\"",
                                                     "template=\"wrong/parts/good.xml\"",
                                                     "0",
                                                     " ",
                                                     "-",
                                                     "\x01",
                                                     "<!DOCTYPE a>",
                                                     "<beam/>",
                                                     "<behaviors>",
                                                     "</behaviors>",
                                                     "<coordinator><sum/></coordinator>",
                                                     "<rule of=\"roam\"/>",
                                                     "<blend/>",
                                                     "9"};
    static const std::vector<std::string> kPlugins = {
        "<beam", "<bumper",    "<avoid",  "<roam",     "<sum",
        "<eye",  "<threshold", "<layers", "<suppress", "<blend"};
    if (text.empty()) {
      return;
    }
    const std::size_t at = below(text.size());
    switch (below(7)) {
      case 0:  // a byte
        text[at] = static_cast<char>(below(256));
        break;
      case 1:  // a gap
        text.erase(at, below(40));
        break;
      case 2:  // something that XML or the reader cares about
        text.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 3:  // a part twice
        text.insert(below(text.size()), text.substr(at, below(200)));
        break;
      case 4:  // a bad id
        insert_behind(text, " id=\"", "1 ");
        break;
      case 5:  // an unknown plugin
        insert_behind(text, kPlugins[below(kPlugins.size())], "x");
        break;
      default:  // an end
        text.resize(std::max(at, text.size() - std::min(text.size(), below(100))));
    }
  }

  std::mt19937 random_;
};

}  // namespace

TEST_CASE("A damaged world is read or refused") {
  const std::string original = text_of(kFolder + "data/everything.xml");
  int accepted = 0;
  for (unsigned seed = 0; seed < 4000; ++seed) {
    const std::string text = Damage(seed).to(original);
    CAPTURE(seed);
    try {
      const world::World w =
          world::parse_world(text, kFolder + "data/damaged.xml", host(), options());
      ++accepted;
      // What is accepted can be saved and edited.
      REQUIRE(same(w, world::parse_world(world::write_world(w), kFolder + "data/again.xml", host(),
                                         options())));
      world::Document document(text, "damaged.xml");
      document.set("@name", "damaged");
      REQUIRE(document.attribute("@name") == "damaged");
    } catch (const world::WorldError& error) {
      REQUIRE_FALSE(error.problems().empty());
    }
  }
  CHECK(accepted > 50);
  CHECK(accepted < 3000);
}

TEST_CASE("A damaged override is taken or refused") {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    try {
      world::read_world(kFolder + "data/everything.xml", host(),
                        options({Damage(seed).to("robot[r1]/sensor[2]/@yaw_deg=15")}));
    } catch (const world::WorldError& error) {
      REQUIRE_FALSE(error.problems().empty());
    }
  }
}
