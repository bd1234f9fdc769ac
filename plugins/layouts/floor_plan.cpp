// Floor plans: walls from an image, or from segments.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/world/error.h"
#include "elsie/world/files.h"
#include "elsie/world/images.h"

#include "described.h"

namespace elsie::layouts {

namespace {

constexpr std::size_t kMostBoxes = 20'000;

struct PixelBox {
  std::size_t x = 0, y = 0, width = 0, height = 0;  // from the top left
  std::size_t area() const { return width * height; }
};

/// Covers the dark pixels with few rectangles: from each that is not covered yet, in reading order,
/// the larger of the widest and of the highest rectangle. None: more than kMostBoxes.
std::optional<std::vector<PixelBox>> boxes_of(const Image& image, double threshold) {
  const auto columns = static_cast<std::size_t>(image.width);
  const auto rows = static_cast<std::size_t>(image.height);
  std::vector<bool> dark;
  for (const std::uint8_t pixel : image.bytes) {
    dark.push_back(pixel < threshold * 255.0);
  }
  const auto at = [&](std::size_t x, std::size_t y) { return dark[y * columns + x]; };
  const auto row_is_dark = [&](std::size_t x, std::size_t y, std::size_t width) {
    for (std::size_t i = x; i < x + width; ++i) {
      if (!at(i, y)) return false;
    }
    return true;
  };
  const auto column_is_dark = [&](std::size_t x, std::size_t y, std::size_t height) {
    for (std::size_t i = y; i < y + height; ++i) {
      if (!at(x, i)) return false;
    }
    return true;
  };
  std::vector<PixelBox> boxes;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      if (!at(x, y)) continue;
      PixelBox wide{x, y, 1, 1}, high{x, y, 1, 1};
      while (x + wide.width < columns && at(x + wide.width, y)) ++wide.width;
      while (y + wide.height < rows && row_is_dark(x, y + wide.height, wide.width)) {
        ++wide.height;
      }
      while (y + high.height < rows && at(x, y + high.height)) ++high.height;
      while (x + high.width < columns && column_is_dark(x + high.width, y, high.height)) {
        ++high.width;
      }
      const PixelBox& box = wide.area() >= high.area() ? wide : high;
      for (std::size_t j = y; j < y + box.height; ++j) {
        for (std::size_t i = x; i < x + box.width; ++i) dark[j * columns + i] = false;
      }
      boxes.push_back(box);
      if (boxes.size() > kMostBoxes) {
        return std::nullopt;
      }
    }
  }
  return boxes;
}

class Planning {
 public:
  Planning(Drawing& drawing, const FloorPlan& plan) : drawing_(drawing), plan_(plan) {}

  void add_image(const std::string& name, const std::string& content) {
    Image image;
    try {
      image = world::read_image(content, 1);
    } catch (const std::runtime_error& error) {
      refuse("names the file '" + name + "', which " + error.what());
      return;
    }
    const double metres = plan_.metres_per_pixel;
    const Area area{plan_.x, plan_.y, metres * image.width, metres * image.height};
    if (!drawing_.require_inside(area, plan_.location, plan_.id)) {
      return;
    }
    const auto boxes = boxes_of(image, plan_.threshold);
    if (!boxes) {
      refuse("makes more than " + std::to_string(kMostBoxes) + " boxes of the image '" + name +
             "'; expected plain walls: a drawing of fewer pixels, without grey or noise");
      return;
    }
    if (boxes->empty()) {
      refuse("finds no wall in the image '" + name + "': no pixel is darker than the threshold " +
             base::number_text(plan_.threshold) + "; raise the threshold");
      return;
    }
    const double top = plan_.y + 0.5 * area.width;
    for (const PixelBox& box : *boxes) {
      const double left = edge(area.left() + metres * static_cast<double>(box.x));
      const double right = edge(area.left() + metres * static_cast<double>(box.x + box.width));
      const double high = edge(top - metres * static_cast<double>(box.y));
      const double low = edge(top - metres * static_cast<double>(box.y + box.height));
      drawing_.add_obstacle(next_id(),
                            {0.5 * (left + right), 0.5 * (low + high), right - left, high - low},
                            0.0, plan_.wall_height, plan_.location);
    }
  }

  /// Lines of four numbers; "#" begins a comment.
  void add_list(const std::string& name, const std::string& content) {
    std::size_t line_number = 0;
    for (std::size_t begin = 0; begin < content.size();) {
      const std::size_t end = std::min(content.find('\n', begin), content.size());
      std::string_view line = std::string_view(content).substr(begin, end - begin);
      line = line.substr(0, line.find('#'));
      begin = end + 1;
      ++line_number;
      std::vector<double> numbers;
      while (true) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t\r,;"), line.size()));
        if (line.empty()) break;
        double number = 0.0;
        const auto [rest, error] = std::from_chars(line.data(), line.data() + line.size(), number);
        if (error != std::errc() || !std::isfinite(number)) break;
        numbers.push_back(number);
        line.remove_prefix(static_cast<std::size_t>(rest - line.data()));
      }
      if (line.empty() && numbers.empty()) {
        continue;
      }
      if (!line.empty() || numbers.size() != 4) {
        drawing_.problems.add({name, static_cast<int>(line_number)},
                              "found " +
                                  base::in_quotes(std::string_view(content).substr(
                                      content.rfind('\n', end == 0 ? 0 : end - 1) + 1,
                                      end - content.rfind('\n', end == 0 ? 0 : end - 1) - 1)) +
                                  "; expected X1 Y1 X2 Y2 (m), a wall of the floor plan '" +
                                  plan_.id + "', or a file that is a PNG or PGM image");
        return;
      }
      if (!add_wall({numbers[0], numbers[1], numbers[2], numbers[3]})) {
        return;
      }
    }
    if (count_ == 0) {
      refuse("names the file '" + name +
             "', which has no walls; expected a line X1 Y1 X2 Y2 (m) for each");
    }
  }

  bool add_wall(const Wall& wall) {
    const Wall placed{wall.x1 + plan_.x, wall.y1 + plan_.y, wall.x2 + plan_.x, wall.y2 + plan_.y};
    const Area area{0.5 * (placed.x1 + placed.x2), 0.5 * (placed.y1 + placed.y2),
                    std::abs(placed.x2 - placed.x1), std::abs(placed.y2 - placed.y1)};
    if (!drawing_.require_inside(area, plan_.location, plan_.id)) {
      return false;
    }
    if (count_ == kMostBoxes) {
      return refuse("has more than " + std::to_string(kMostBoxes) + " walls; leave some out");
    }
    drawing_.add_wall(next_id(), placed, plan_.wall_thickness, plan_.wall_height, plan_.location);
    return true;
  }

  bool refuse(const std::string& problem) {
    return drawing_.refuse(plan_.location, plan_.id, problem);
  }

 private:
  /// The edge of a box, m: boxes have no gap between them, as their middles and sizes are rounded
  /// to half of this.
  static double edge(double metres) { return 2.0 * rounded_m(0.5 * metres); }
  std::string next_id() { return plan_.id + "_" + std::to_string(++count_); }

  Drawing& drawing_;
  const FloorPlan& plan_;
  std::size_t count_ = 0;
};

}  // namespace

void draw_floor_plan(Drawing& drawing, const FloorPlan& plan) {
  Planning planning(drawing, plan);
  if (plan.file.empty() == plan.walls.empty()) {
    planning.refuse(plan.file.empty() ? "has no walls; expected a file, or <wall>s in it"
                                      : "has a file and <wall>s; expected one of them");
    return;
  }
  for (const Wall& wall : plan.walls) {
    if (!planning.add_wall(wall)) return;
  }
  if (plan.file.empty()) {
    return;
  }
  const world::Attribute& file = *plan.element->find("file");
  const auto found = drawing.files.find(plan.file, file.where);
  if (!found) {
    drawing.problems.add(file.where, world::in_words(file, *plan.element) + ": " +
                                         drawing.files.why_not(file.where, "file", plan.file));
    return;
  }
  try {
    const std::string content = world::read_text(*found);
    world::is_image(content) ? planning.add_image(plan.file, content)
                             : planning.add_list(plan.file, content);
  } catch (const world::WorldError& error) {
    drawing.problems.add(error);
  }
}

}  // namespace elsie::layouts
