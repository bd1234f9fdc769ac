// Worlds with random damage are read or refused, never anything else.
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "elsie/world/markup.h"
#include "elsie/world/writer.h"

#include "damage.h"
#include "equal.h"
#include "fixture.h"

using namespace elsie;
using namespace elsie::test;

namespace {

const std::vector<std::string> kPieces = xml_pieces(
    R"(</robot> id="r1" remove="true" template="wrong/parts/good.xml" <beam/> <behaviors>)"
    " </behaviors> <coordinator><sum/></coordinator> <blend/>",
    {"<robot id='r1'>", "<!DOCTYPE a>", "<rule of=\"roam\"/>"});
const std::vector<std::string> kPlugins = {"<beam", "<bumper",    "<avoid",  "<roam",     "<sum",
                                           "<eye",  "<threshold", "<layers", "<suppress", "<blend"};

std::string damaged(unsigned seed, const std::string& text) {
  return Damage(seed, kPieces, kPlugins).to(text);
}

int line_of(const std::string& text, std::size_t offset) {
  const auto begin = text.begin();
  return 1 + static_cast<int>(std::count(begin, begin + static_cast<long>(offset), '\n'));
}

// Requires that the span of an element encloses what it says.
void require_place(const world::Element& element, const world::ElementSpan& span,
                   const std::string& text) {
  REQUIRE(element.where.line == line_of(text, span.begin));
  REQUIRE(text.substr(span.begin, span.name_end - span.begin) == "<" + element.name);
  REQUIRE(text[span.open_end - 1] == '>');
  REQUIRE(text[span.end - 1] == '>');
  REQUIRE(span.empty == (text[span.end - 2] == '/'));
  if (!span.empty) {
    REQUIRE(text.substr(span.close).starts_with("</" + element.name));
  }
  REQUIRE(span.attributes.size() == element.attributes.size());
  for (std::size_t i = 0; i < span.attributes.size(); ++i) {
    const world::ElementSpan::Attribute& place = span.attributes[i];
    const world::Attribute& attribute = element.attributes[i];
    REQUIRE(attribute.where.line == line_of(text, place.begin));
    REQUIRE(text.substr(place.begin, place.name_end - place.begin) == attribute.name);
    REQUIRE(text[place.value - 1] == text[place.end - 1]);
    const std::string value = text.substr(place.value, place.end - 1 - place.value);
    if (value.find_first_of("&\n\r\t") == value.npos) {
      REQUIRE(value == attribute.value);
    }
  }
}

}  // namespace

TEST_CASE("A damaged world is read or refused") {
  const std::string original = text_of(kFolder + "data/everything.xml");
  int accepted = 0;
  for (unsigned seed = 0; seed < 5000; ++seed) {
    const std::string text = damaged(seed, original);
    CAPTURE(seed);
    try {
      const world::World w =
          world::parse_world(text, kFolder + "data/damaged.xml", host(), options());
      ++accepted;
      // What is accepted can be saved.
      REQUIRE(same(w, world::parse_world(world::write_world(w), kFolder + "data/again.xml", host(),
                                         options())));
    } catch (const world::WorldError& error) {
      REQUIRE_FALSE(error.problems().empty());
    }
  }
  CHECK(accepted > 50);
  CHECK(accepted < 3000);
}

TEST_CASE("Elements and attributes of damaged markup have their places") {
  const std::string original =
      "<?xml version=\"1.0\"?>\n<!-- It's \"plain\". -->\n<world format=\"1\">\n"
      "  <robots>a\r\n b&#228;&lt;<robot id=\"r1\" x='&apos;1'\n y=\"2\"></robot><robot/>"
      "</robots>\n</world>\n";
  std::set<std::string> meanings;
  for (unsigned seed = 0; seed < 20'000; ++seed) {
    const std::string text = Damage(seed, kPieces, {"<robot", "</robot", "<world"}).to(original);
    CAPTURE(text);
    try {
      std::vector<world::ElementSpan> spans;
      const world::Element root = world::parse_markup(text, "damaged.xml", "world", &spans);
      std::size_t number = 0;
      world::for_each_element(root, [&](const world::Element& element) {
        REQUIRE(number < spans.size());
        require_place(element, spans[number++], text);
      });
      REQUIRE(number == spans.size());
      meanings.insert(world::markup_of(root));
    } catch (const world::WorldError&) {
    }
  }
  CHECK(meanings.size() > 100);
}

TEST_CASE("A damaged override is taken or refused") {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    try {
      world::read_world(kFolder + "data/everything.xml", host(),
                        options({damaged(seed, "robot[r1]/sensor[2]/@yaw_deg=15")}));
    } catch (const world::WorldError& error) {
      REQUIRE_FALSE(error.problems().empty());
    }
  }
}
