#include <string>

#include <catch2/catch.hpp>

#include "elsie/world/escaped.h"
#include "elsie/world/markup.h"

using namespace elsie;

TEST_CASE("What means something in markup is replaced") {
  CHECK(world::escaped("a<b> & \"c\"\n\td") == "a&lt;b&gt; &amp; &quot;c&quot;\n\td");
  CHECK(world::escaped_attribute("a<b\"\n\t\r") == "a&lt;b&quot;&#10;&#9;&#13;");
}

TEST_CASE("A reader of XML gets the text back") {
  const std::string text = "<b a='1'>\"&amp;\" ]]> \xc3\xa4 \xf0\x9f\x90\xa2 x\r\ny\tz</b>";
  const std::string xml =
      "<e a=\"" + world::escaped_attribute(text) + "\">" + world::escaped(text) + "</e>";
  const world::Element element = world::parse_markup(xml, "escaped.xml");
  CHECK(element.value("a") == text);
  CHECK(element.text == text);
}
