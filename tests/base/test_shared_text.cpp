#include <catch2/catch.hpp>

#include "elsie/base/shared_text.h"

using elsie::base::SharedText;

TEST_CASE("A shared text stands for a text, and its copies for the same one") {
  const SharedText text = std::string("worlds/clutter.xml"), copy = text, other = "worlds/maze.xml";
  const std::string& content = copy;
  CHECK(content == "worlds/clutter.xml");
  CHECK(&copy.text() == &text.text());
  CHECK(text == copy);
  CHECK(text == SharedText("worlds/clutter.xml"));
  CHECK(text == std::string("worlds/clutter.xml"));
  CHECK_FALSE(text == other);
}

TEST_CASE("A shared text is empty at first") {
  CHECK(SharedText().empty());
  CHECK(SharedText().text().empty());
  CHECK(SharedText("") == SharedText());
  CHECK_FALSE(SharedText("a").empty());
}
