// The page's colours can be distinguished, also with a colour vision deficiency, and stand out from
// their background.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "places.h"

namespace {

using Linear = std::array<double, 3>;
using Matrix = std::array<std::array<double, 3>, 3>;

double linear(int byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

Linear colour(const std::string& hex) {
  const auto part = [&](std::size_t at) {
    return linear(std::stoi(hex.substr(at, 2), nullptr, 16));
  };
  return {part(1), part(3), part(5)};
}

// Machado, Oliveira and Fernandes (2009), severity 1.
const std::map<std::string, Matrix> kVision = {{"normal", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                                               {"protanopia",
                                                {{{0.152286, 1.052583, -0.204868},
                                                  {0.114503, 0.786281, 0.099216},
                                                  {-0.003882, -0.048116, 1.051998}}}},
                                               {"deuteranopia",
                                                {{{0.367322, 0.860646, -0.227968},
                                                  {0.280085, 0.672501, 0.047413},
                                                  {-0.011820, 0.042940, 0.968881}}}},
                                               {"tritanopia",
                                                {{{1.255528, -0.076749, -0.178779},
                                                  {-0.078411, 0.930809, 0.147602},
                                                  {0.004733, 0.691367, 0.303900}}}}};

// Ottosson (2020).
Linear oklab(const Linear& c) {
  const double l = std::cbrt(0.4122214708 * c[0] + 0.5363325363 * c[1] + 0.0514459929 * c[2]);
  const double m = std::cbrt(0.2119034982 * c[0] + 0.6806995451 * c[1] + 0.1073969566 * c[2]);
  const double s = std::cbrt(0.0883024619 * c[0] + 0.2817188376 * c[1] + 0.6299787005 * c[2]);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

// 100 times the distance in OKLab as seen with this vision.
double distance(const std::string& a, const std::string& b, const Matrix& vision) {
  const auto seen = [&](const std::string& hex) {
    const Linear c = colour(hex);
    Linear result{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double sum = vision[i][0] * c[0] + vision[i][1] * c[1] + vision[i][2] * c[2];
      result[i] = std::clamp(sum, 0.0, 1.0);
    }
    return oklab(result);
  };
  const Linear p = seen(a), q = seen(b);
  return 100.0 * std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// WCAG 2.
double contrast(const std::string& a, const std::string& b) {
  const auto luminance = [](const std::string& hex) {
    const Linear c = colour(hex);
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
  };
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

// The variables of the n-th ":root" of the style: 0 is light, 1 dark, 2 print.
std::map<std::string, std::string> variables(std::size_t n) {
  std::ostringstream style;
  style << std::ifstream(elsie::test::source_path("libraries/studies/report/src/page.css")).rdbuf();
  const std::string text = style.str();
  std::size_t at = text.find(":root {");
  for (std::size_t i = 0; i < n; ++i) at = text.find(":root {", at + 1);
  REQUIRE(at != std::string::npos);
  const std::size_t end = text.find('}', at);
  std::map<std::string, std::string> found;
  while ((at = text.find("--", at)) < end) {
    const std::size_t colon = text.find(':', at), stop = text.find(';', at);
    std::string value = text.substr(colon + 2, stop - colon - 2);
    if (value.size() == 4) {  // "#abc"
      value = {'#', value[1], value[1], value[2], value[2], value[3], value[3]};
    }
    found[text.substr(at + 2, colon - at - 2)] = value;
    at = stop;
  }
  return found;
}

}  // namespace

TEST_CASE("Colours can be distinguished with every kind of colour vision") {
  for (const std::size_t scheme : {0u, 1u, 2u}) {
    auto names = variables(scheme);
    const std::vector<std::string> used{"c0", "c1", "c2", "c3", "c4", "c5", "bad"};
    for (const auto& [kind, vision] : kVision) {
      for (std::size_t i = 0; i < used.size(); ++i) {
        for (std::size_t j = i + 1; j < used.size(); ++j) {
          CAPTURE(scheme, kind, used[i], used[j]);
          CHECK(distance(names.at(used[i]), names.at(used[j]), vision) >
                (kind == "tritanopia" ? 9.0 : 11.0));
        }
      }
    }
  }
}

TEST_CASE("Marks stand out from their ground, and texts can be read") {
  for (const std::size_t scheme : {0u, 1u, 2u}) {
    auto names = variables(scheme);
    for (const std::string ground : {"surface", "raised", "floor"}) {
      for (const std::string mark : {"c0", "c1", "c2", "c3", "c4", "c5", "bad", "good", "ink"}) {
        CAPTURE(scheme, ground, mark);
        CHECK(contrast(names.at(mark), names.at(ground)) >= 3.0);
      }
    }
    for (const std::string ground : {"surface", "raised", "panel"}) {
      for (const std::string text : {"ink", "muted", "bad", "good"}) {
        CAPTURE(scheme, ground, text);
        CHECK(contrast(names.at(text), names.at(ground)) >= 4.5);
      }
    }
  }
}
