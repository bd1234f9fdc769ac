#include "svg_text.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string_view>

#include "elsie/output/clean_text.h"
#include "elsie/world/escaped.h"

namespace elsie::picture {
namespace {

// cairo's font first, then fonts of about the same width.
constexpr const char* kFamily = "DejaVu Sans, Verdana, Bitstream Vera Sans, Arial, sans-serif";

// At most six decimals, the same in every locale, as cairo writes numbers.
std::string number(double value) {
  const long long millionths = std::llround(value * 1e6);
  const long long size = std::llabs(millionths);
  std::string decimals = std::to_string(1'000'000 + size % 1'000'000).substr(1);
  decimals.erase(decimals.find_last_not_of('0') + 1);
  return std::string(millionths < 0 ? "-" : "") + std::to_string(size / 1'000'000) +
         (decimals.empty() ? "" : "." + decimals);
}

std::string hexadecimal(const Ink& ink) {
  const auto part = [](double value) { return static_cast<unsigned>(std::lround(255.0 * value)); };
  char text[8];
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", part(ink.red), part(ink.green),
                part(ink.blue));
  return text;
}

// Whether an element is a marker: a shape filled with the markers' opacity. Up to cairo 1.16 that
// is in the attribute `style`, later it is an attribute.
bool is_marker(const std::string& element) {
  static const std::string in_style = ";fill-opacity:" + number(SvgTexts::kMarkerAlpha) + ";";
  static const std::string attribute = " fill-opacity=\"" + number(SvgTexts::kMarkerAlpha) + "\"";
  const bool is_shape = element.starts_with("<path ") || element.starts_with("<rect ");
  return is_shape && (element.find(in_style) != std::string::npos ||
                      element.find(attribute) != std::string::npos);
}

// The number of a marker, encoded in its colour: "fill:rgb(0%,0.392157%,100%)".
std::optional<std::size_t> number_of(const std::string& element) {
  std::size_t at = element.find("fill:rgb(");
  if (at == std::string::npos) at = element.find("fill=\"rgb(");
  if (at == std::string::npos) return std::nullopt;
  at = element.find('(', at) + 1;
  std::size_t result = 0;
  for (int i = 0; i < 3; ++i) {
    double percent = 0.0;
    std::from_chars(element.data() + at, element.data() + element.size(), percent);
    result = 256 * result + static_cast<std::size_t>(std::lround(2.55 * percent));
    at = element.find_first_of("0123456789", element.find(',', at));
    if (at == std::string::npos) break;
  }
  return result;
}

}  // namespace

Ink SvgTexts::add(const std::string& text, const Vector2& at, double drop, const TextStyle& style) {
  std::string element = "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y + drop) +
                        "\" font-family=\"" + kFamily + "\" font-size=\"" + number(style.size) +
                        "\" fill=\"" + hexadecimal(style.ink) + "\"";
  if (style.bold) element += " font-weight=\"bold\"";
  if (style.ink.alpha < 1.0) element += " fill-opacity=\"" + number(style.ink.alpha) + "\"";
  if (style.across == Across::centre) element += " text-anchor=\"middle\"";
  if (style.across == Across::right) element += " text-anchor=\"end\"";
  if (style.angle != 0.0) {
    element += " transform=\"rotate(" + number(style.angle * 180.0 / std::numbers::pi) + " " +
               number(at.x) + " " + number(at.y) + ")\"";
  }
  if (style.halo > 0.0) {
    element += " stroke=\"" + hexadecimal(kPaper) + "\" stroke-opacity=\"0.9\" stroke-width=\"" +
               number(2.0 * style.halo) + "\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  }
  const std::size_t index = elements_.size();
  elements_.push_back(element + ">" + world::escaped(output::clean(text)) + "</text>");
  const auto part = [&](unsigned shift) {
    return static_cast<double>((index >> shift) & 0xffU) / 255.0;
  };
  return {part(16), part(8), part(0), kMarkerAlpha};
}

void SvgTexts::put_into(std::string& svg) const {
  std::string result;
  std::size_t done = 0;
  constexpr std::string_view kOpacity = "fill-opacity";
  for (std::size_t at = 0; (at = svg.find(kOpacity, at)) != std::string::npos;
       at += kOpacity.size()) {
    const std::size_t from = svg.rfind('<', at), to = svg.find("/>", at);
    if (from == std::string::npos || to == std::string::npos || from < done) continue;
    const std::string element = svg.substr(from, to - from);
    const auto index = is_marker(element) ? number_of(element) : std::nullopt;
    if (!index || *index >= elements_.size()) continue;
    result.append(svg, done, from - done).append(elements_[*index]);
    done = to + 2;
  }
  svg = result.append(svg, done);
}

}  // namespace elsie::picture
