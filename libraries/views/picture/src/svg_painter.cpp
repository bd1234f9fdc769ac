#include "svg_painter.h"

#include <cmath>
#include <cstdint>
#include <numbers>

#include "elsie/files/clean_text.h"
#include "elsie/picture/svg.h"
#include "elsie/world/escaped.h"

namespace elsie::picture {
namespace {

// cairo's font first, which measures the texts, then fonts of about the same width.
constexpr const char* kFamily = "DejaVu Sans, Verdana, Bitstream Vera Sans, Arial, sans-serif";

std::string number(double value) { return short_number(value, 3); }

std::string escaped(const std::string& text) {
  return world::escaped_attribute(files::clean(text));
}

}  // namespace

// ' fill="#22262b"', or the name of a colour in the page's style.
std::string SvgPainter::paint(const std::string& attribute, const Ink& ink) const {
  const auto byte = [](double part) { return static_cast<std::uint8_t>(std::lround(255 * part)); };
  const std::string colour = in_page_ && ink.role != nullptr
                                 ? std::string("var(--") + ink.role + ")"
                                 : hex_text({byte(ink.red), byte(ink.green), byte(ink.blue)});
  return " " + attribute + "=\"" + colour + "\"" +
         (ink.alpha < 1.0 ? " " + attribute + "-opacity=\"" + number(ink.alpha) + "\"" : "");
}

void SvgPainter::fill(const std::string& path, const Ink& ink) {
  if (path.empty()) return;
  body_ += "<path d=\"" + path + "\"" + paint("fill", ink) + "/>\n";
}

void SvgPainter::stroke(const std::string& path, const Ink& ink, const Pen& pen) {
  if (path.empty()) return;
  body_ += "<path d=\"" + path + "\"" + paint("stroke", ink);
  if (pen.width != 1.0) body_ += " stroke-width=\"" + number(pen.width) + "\"";
  if (pen.round) body_ += " stroke-linecap=\"round\" stroke-linejoin=\"round\"";
  if (!pen.dash.empty()) {
    body_ += " stroke-dasharray=\"";
    for (const double length : pen.dash) body_ += number(length) + " ";
    body_.back() = '"';
  }
  body_ += "/>\n";
}

void SvgPainter::dot(const Vector2& centre, double radius, const Ink& ink) {
  const int decimals = in_page_ ? 1 : 2;
  body_ += "<circle cx=\"" + short_number(centre.x, decimals) + "\" cy=\"" +
           short_number(centre.y, decimals) + "\" r=\"" + number(radius) + "\"" +
           paint("fill", ink) + "/>\n";
}

void SvgPainter::clip(const std::string& path, const Rect& box) {
  if (in_page_) {
    const std::string x = number(box.x), y = number(box.y);
    const std::string width = number(box.width), height = number(box.height);
    body_ += "<svg x=\"" + x + "\" y=\"" + y + "\" width=\"" + width + "\" height=\"" + height +
             "\" viewBox=\"" + x + " " + y + " " + width + " " + height + "\" overflow=\"hidden\">";
    return;
  }
  const std::string name = "clip" + std::to_string(++clips_);
  body_ += "<clipPath id=\"" + name + "\"><path d=\"" + path +
           "\"/></clipPath><g clip-path=\"url(#" + name + ")\">\n";
}

void SvgPainter::text(const std::string& text, const Vector2& at, double drop,
                      const TextStyle& style) {
  body_ += "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y + drop) + "\" font-size=\"" +
           number(style.size) + "\"" + paint("fill", style.ink);
  if (style.bold) body_ += " font-weight=\"bold\"";
  if (style.across == Across::centre) body_ += " text-anchor=\"middle\"";
  if (style.across == Across::right) body_ += " text-anchor=\"end\"";
  if (style.angle != 0.0) {
    body_ += " transform=\"rotate(" + number(style.angle * 180.0 / std::numbers::pi) + " " +
             number(at.x) + " " + number(at.y) + ")\"";
  }
  if (style.halo > 0.0) {
    body_ += paint("stroke", kPaper.with_alpha(0.9)) + " stroke-width=\"" +
             number(2.0 * style.halo) + "\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
  }
  body_ += ">" + escaped(text) + "</text>\n";
}

void SvgPainter::open(const std::string& title) {
  body_ += "<g><title>" + escaped(title) + "</title>\n";
}

std::string SvgPainter::finish(int width, int height, double zoom, const std::string& label) const {
  const std::string box =
      " viewBox=\"0 0 " + number(width / zoom) + " " + number(height / zoom) + "\" fill=\"none\"";
  if (in_page_) {
    return "<svg role=\"img\" aria-label=\"" + escaped(label) + "\"" + box + ">" + body_ + "</svg>";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "width=\"" +
         std::to_string(width) + "px\" height=\"" + std::to_string(height) + "px\"" + box +
         " font-family=\"" + kFamily + "\" stroke-miterlimit=\"10\">\n" +
         "<rect width=\"100%\" height=\"100%\"" + paint("fill", kPaper) + "/>\n" + body_ +
         "</svg>\n";
}

}  // namespace elsie::picture
