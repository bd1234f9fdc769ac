// Texts of an SVG replace their markers, and nothing else.
#include <string>

#include <catch2/catch.hpp>

#include "svg_text.h"

using elsie::picture::SvgTexts;
using elsie::picture::TextStyle;

namespace {

const std::string kMarker =
    "<path style=\" stroke:none;fill-rule:nonzero;fill:rgb(0%,0%,0%);fill-opacity:0.012345;\" "
    "d=\"M 1 1 L 2 1 Z M 1 1 \"/>\n";

std::string with_text(std::string svg) {
  SvgTexts texts;
  texts.add("hello", {1.0, 1.0}, 0.0, TextStyle{});
  texts.put_into(svg);
  return svg;
}

}  // namespace

TEST_CASE("A marker becomes its text, in both forms that cairo writes") {
  const std::string form =
      GENERATE(as<std::string>(), kMarker,
               "<path fill-rule=\"nonzero\" fill=\"rgb(0%, 0%, 0%)\" fill-opacity=\"0.012345\" "
               "d=\"M 1 1 L 2 1 Z M 1 1 \"/>\n",
               "<rect x=\"1\" y=\"1\" width=\"1\" height=\"1\" fill=\"rgb(0%, 0%, 0%)\" "
               "fill-opacity=\"0.012345\"/>\n");
  const std::string svg = with_text("<svg>\n" + form + "</svg>\n");
  CHECK_THAT(svg, Catch::StartsWith("<svg>\n<text x=\"1\" y=\"1\"") &&
                      Catch::EndsWith(">hello</text>\n</svg>\n"));
}

TEST_CASE("What has a marker's digits elsewhere stays as it is") {
  const std::string other =
      GENERATE(as<std::string>(),
               // Coordinates, which end in the digits or are these.
               "<path style=\" stroke:none;fill:rgb(0%,0%,0%);fill-opacity:1;\" "
               "d=\"M 120.012345 3 L 5 0.012345 \"/>\n",
               // Other opacities, and other elements.
               "<path style=\"fill:none;stroke-width:0.012345;"
               "stroke:rgb(0%,0%,0%);stroke-opacity:0.012345;\" d=\"M 0 0 \"/>\n",
               "<path style=\" stroke:none;fill:rgb(0%,0%,0%);"
               "fill-opacity:0.0123456;\" d=\"M 0 0 \"/>\n",
               "<stop offset=\"0\" style=\"stop-color:rgb(0%,0%,0%);"
               "fill-opacity:0.012345;\"/>\n");
  CAPTURE(other);
  CHECK(with_text(other) == other);
  const std::string svg = with_text(other + kMarker + other);
  CHECK_THAT(svg, Catch::StartsWith(other + "<text ") && Catch::EndsWith("</text>\n" + other));
}
