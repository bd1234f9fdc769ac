#include "colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace elsie::picture {
namespace {

double to_linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

double from_linear(double v) {
  v = std::clamp(v, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

struct Lab {
  double l, a, b;
};

// Björn Ottosson, "A perceptual color space for image processing" (2020).
Lab to_oklab(const Ink& c) {
  const double r = to_linear(c.red), g = to_linear(c.green), b = to_linear(c.blue);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Ink from_oklab(const Lab& c, double alpha) {
  const double l = std::pow(c.l + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
  const double m = std::pow(c.l - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
  const double s = std::pow(c.l - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
  return {from_linear(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          from_linear(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          from_linear(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), alpha};
}

}  // namespace

Ink ink(const world::Colour& colour) {
  return {colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0};
}

Ink mix(const Ink& a, const Ink& b, double part) {
  return {a.red + part * (b.red - a.red), a.green + part * (b.green - a.green),
          a.blue + part * (b.blue - a.blue), a.alpha + part * (b.alpha - a.alpha)};
}

Ink shifted(const Ink& base, double lightness, double hue_rad) {
  const Lab lab = to_oklab(base);
  const double cosine = std::cos(hue_rad), sine = std::sin(hue_rad);
  return from_oklab({std::clamp(lab.l + lightness, 0.0, 1.0), cosine * lab.a - sine * lab.b,
                     sine * lab.a + cosine * lab.b},
                    base.alpha);
}

Ink readable(const Ink& base) {
  constexpr double kDarkEnough = 0.50;  // OKLab lightness: a contrast of about 5:1 on white
  const double lightness = to_oklab(base).l;
  Ink dark = lightness <= kDarkEnough ? base : shifted(base, kDarkEnough - lightness, 0.0);
  dark.role = base.role;
  return dark;
}

Ink series_ink(std::size_t index) {
  static constexpr std::array<Ink, kSeriesInks> kInks = {
      hex(0x0072b2, "c0"), hex(0xd55e00, "c1"), hex(0x009e73, "c2"),   hex(0xcc79a7, "c3"),
      hex(0xe69f00, "c4"), hex(0x56b4e9, "c5"), hex(0x3a3f45, "quiet")};
  return kInks[index % kInks.size()];
}

Ink viridis(double part) {
  static constexpr std::array<Ink, 10> kAnchors = {
      hex(0x440154), hex(0x482878), hex(0x3e4a89), hex(0x31688e), hex(0x26828e),
      hex(0x1f9e89), hex(0x35b779), hex(0x6dcd59), hex(0xb4de2c), hex(0xfde725)};
  const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(kAnchors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kAnchors.size() - 2);
  return mix(kAnchors[below], kAnchors[below + 1], at - static_cast<double>(below));
}

}  // namespace elsie::picture
