// A drawing as the text of an SVG, for a file or for a page.
#pragma once

#include <string>

#include "canvas.h"

namespace elsie::picture {

/// In a page, inks with a role have the colour of that name in the page's style, texts have the
/// page's font, and there is no paper.
class SvgPainter {
 public:
  explicit SvgPainter(bool in_page) : in_page_(in_page) {}

  bool in_page() const { return in_page_; }
  void fill(const std::string& path, const Ink& ink);
  void stroke(const std::string& path, const Ink& ink, const Pen& pen);
  void dot(const Vector2& centre, double radius, const Ink& ink);
  /// In a page, which has no names for outlines, clips to the rectangle `box` around the path.
  void clip(const std::string& path, const Rect& box);
  /// `drop`: the distance of the base line below the point around which the text is turned.
  void text(const std::string& text, const Vector2& at, double drop, const TextStyle& style);
  void unclip() { body_ += in_page_ ? "</svg>" : "</g>\n"; }
  void open(const std::string& title);
  void close() { body_ += "</g>\n"; }
  /// The whole text of a drawing of this size in pixels. `label`: for readers who do not see it.
  std::string finish(int width, int height, double zoom, const std::string& label) const;

 private:
  std::string paint(const std::string& attribute, const Ink& ink) const;

  bool in_page_;
  std::string body_;
  int clips_ = 0;
};

}  // namespace elsie::picture
