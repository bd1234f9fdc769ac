// Mazes, rooms and floor plans: their boxes, what they connect, and what is refused.
#include <fstream>
#include <initializer_list>
#include <queue>
#include <set>

#include <catch2/catch.hpp>

#include "folder.h"
#include "support.h"

using namespace elsie;
using namespace elsie::test;
using Catch::Contains;

namespace {

/// The floor as squares of this edge, m: whether a point of that size can be there.
class Floor {
 public:
  Floor(const world::World& world, double edge) : edge_(edge) {
    columns_ = static_cast<int>(std::lround(world.arena.length / edge));
    rows_ = static_cast<int>(std::lround(world.arena.width / edge));
    const auto obstacles = footprints(world);
    for (int y = 0; y < rows_; ++y) {
      for (int x = 0; x < columns_; ++x) {
        world::Footprint here;
        here.x = (x + 0.5) * edge - 0.5 * world.arena.length;
        here.y = (y + 0.5) * edge - 0.5 * world.arena.width;
        here.half_length = here.half_width = 0.01;
        here.top = 0.1;
        free_.push_back(std::none_of(obstacles.begin(), obstacles.end(),
                                     [&](const auto& box) { return world::overlap(here, box); }));
      }
    }
  }

  int free() const { return static_cast<int>(std::count(free_.begin(), free_.end(), true)); }
  /// How many free squares can be reached from the first of them.
  int connected() const {
    std::vector<bool> reached(free_.size(), false);
    std::queue<int> next;
    next.push(static_cast<int>(std::find(free_.begin(), free_.end(), true) - free_.begin()));
    reached[static_cast<std::size_t>(next.front())] = true;
    int count = 0;
    for (; !next.empty(); next.pop(), ++count) {
      const int x = next.front() % columns_, y = next.front() / columns_;
      for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        if (x + dx < 0 || x + dx >= columns_ || y + dy < 0 || y + dy >= rows_) continue;
        const auto there = static_cast<std::size_t>((y + dy) * columns_ + x + dx);
        if (free_[there] && !reached[there]) {
          reached[there] = true;
          next.push(static_cast<int>(there));
        }
      }
    }
    return count;
  }

 private:
  double edge_;
  int columns_ = 0, rows_ = 0;
  std::vector<bool> free_;
};

std::string plan(const std::string& file, const std::string& attributes = "") {
  return "<layouts><floor_plan id='p' file='" + file + "' " + attributes + "/></layouts>";
}

void write(const std::string& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
}

/// A grey PNG image whose data is not compressed (RFC 1950 and 1951, PNG specification).
std::string png_of(unsigned width, unsigned height, const std::string& pixels) {
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
    return bytes;
  };
  const auto chunk = [&](const std::string& name, const std::string& data) {
    std::uint32_t crc = 0xffffffffU;
    for (const char byte : name + data) {
      crc ^= static_cast<unsigned char>(byte);
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320U : 0U);
    }
    return number(static_cast<std::uint32_t>(data.size())) + name + data + number(~crc);
  };
  std::uint32_t a = 1, b = 0;
  for (const char byte : pixels) {
    a = (a + static_cast<unsigned char>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<unsigned char>(pixels.size());
  std::string data = {
      '\x78', '\x01', '\x01', static_cast<char>(size), '\0', static_cast<char>(~size), '\xff'};
  data += pixels + number((b << 16) | a);
  std::string head = number(width) + number(height);
  head += {'\x08', '\0', '\0', '\0', '\0'};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + chunk("IDAT", data) + chunk("IEND", "");
}

}  // namespace

TEST_CASE("A maze is perfect: all its cells are connected, and no wall could be left out") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const world::World maze = drawn("<layouts><maze columns='10' rows='8'/></layouts>", seed);
    // A tree of 80 cells has 79 openings; the walls between cells are 9 x 8 + 10 x 7.
    double walls = 0.0;
    for (const world::Obstacle& box : maze.obstacles) {
      walls += std::round((box.length - 0.1) / (box.heading_deg == 0.0 ? 1.0 : 1.25));
    }
    CHECK(walls == 142 - 79);
    const Floor floor(maze, 0.25);
    CHECK(floor.connected() == floor.free());
  }
  CHECK(text_of("<layouts><maze/></layouts>", 1) != text_of("<layouts><maze/></layouts>", 2));
}

TEST_CASE("Walls of a maze that are in line are one box") {
  CHECK(drawn("<layouts><maze columns='20' rows='20'/></layouts>").obstacles.size() < 261);
  CHECK(drawn("<layouts><maze columns='2' rows='1'/></layouts>").obstacles.empty());
  CHECK(drawn("<layouts><maze columns='2' rows='1' border='true'/></layouts>").obstacles.size() ==
        4);
}

TEST_CASE("Every room has a door, and all rooms are connected") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const world::World rooms = drawn("<layouts><rooms smallest='1.2' door='0.6'/></layouts>", seed);
    CHECK(rooms.obstacles.size() > 10);
    const Floor floor(rooms, 0.1);
    CHECK(floor.connected() == floor.free());
  }
}

TEST_CASE("Robots are scattered between walls") {
  const world::World world = drawn(
      "<layouts><maze/><scatter id='s' count='20' gap='0.1'><robot id='r'/><heading/>"
      "</scatter></layouts>",
      3);
  const auto all = footprints(world);
  for (std::size_t i = world.obstacles.size(); i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(are_nearer(all[i], all[j], 0.099));
  }
}

TEST_CASE("A floor plan has the walls that are listed in it, or in a file") {
  const world::World listed = drawn(
      "<layouts><floor_plan wall_thickness='0.2'><wall x1='-1' y1='0' x2='2' y2='0'/>"
      "<wall x1='2' y1='0' x2='2' y2='3'/></floor_plan></layouts>");
  REQUIRE(listed.obstacles.size() == 2);
  CHECK(listed.obstacles[0].x == 0.5);
  CHECK(listed.obstacles[0].length == Approx(3.2));
  CHECK(listed.obstacles[1].heading_deg == 90.0);
  const Folder folder;
  const std::string file = folder.file("walls.txt");
  write(file, "# a corner\n-1 0 2 0\n\n2 0 2 3  # up\n");
  CHECK(text_of(plan(file, "wall_thickness='0.2'"), 1).find("x=\"0.5\"") != std::string::npos);
  CHECK(drawn(plan(file)).obstacles.size() == 2);
  write(file, "-1 0 2 0\n1 2 3\n");
  CHECK_THAT(refusal(plan(file)), Contains("walls.txt:2: found '1 2 3'; expected X1 Y1 X2 Y2 (m)"));
  write(file, "# none\n");
  CHECK_THAT(refusal(plan(file)), Contains("which has no walls"));
  write(file, "0 0 9 0\n");
  CHECK_THAT(refusal(plan(file)), Contains("outside of the arena"));
}

TEST_CASE("An image becomes few boxes that cover its dark pixels, and no others") {
  const Folder folder;
  const std::string file = folder.file("plan.pgm");
  // A frame of 10 x 6 pixels with a gap, and a block of two by two.
  const std::vector<std::string> rows = {"##########", "#........#", "#..##....#",
                                         "#..##.....", "#........#", "##########"};
  std::string pgm = "P2\n# made by hand\n10 6\n255\n";
  for (const std::string& row : rows) {
    for (const char c : row) pgm += c == '#' ? "10 " : "250 ";
  }
  write(file, pgm);
  const world::World world = drawn(plan(file, "metres_per_pixel='0.5'"));
  CHECK(world.obstacles.size() <= 6);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 10; ++x) {
      const double at_x = (x + 0.5) * 0.5 - 2.5, at_y = 1.5 - (y + 0.5) * 0.5;
      const auto covering = std::count_if(world.obstacles.begin(), world.obstacles.end(),
                                          [&](const world::Obstacle& box) {
                                            return std::abs(at_x - box.x) < 0.5 * box.length &&
                                                   std::abs(at_y - box.y) < 0.5 * box.width;
                                          });
      CHECK(covering ==
            (rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#' ? 1 : 0));
    }
  }
  CHECK_THAT(refusal(plan(file, "metres_per_pixel='5'")), Contains("outside of the arena"));
  CHECK_THAT(refusal(plan(file, "metres_per_pixel='0.1' threshold='0'")),
             Contains("finds no wall"));
  write(file, pgm.substr(0, 60));
  CHECK_THAT(refusal(plan(file)), Contains("which is no whole PGM image"));
  write(file, "P5 100000 100000 255\n");
  CHECK_THAT(refusal(plan(file)), Contains("has 100000 x 100000 pixels; expected at least one, and "
                                           "at most 16000000"));
  write(file, "P5 4 4 65535\n");
  CHECK_THAT(refusal(plan(file)), Contains("with 65535 as its white"));
  write(file, "\x89PNG\r\n\x1a\nnothing");
  CHECK_THAT(refusal(plan(file)), Contains("which is no whole PNG image"));
}

TEST_CASE("A PNG image is read as a PGM image is") {
  const Folder folder;
  std::string pixels;  // three rows of four, each after the number of its filter
  for (const char* row : {"#..#", "#..#", "####"}) {
    pixels += '\0';
    for (int x = 0; x < 4; ++x) pixels += row[x] == '#' ? '\x20' : '\xff';
  }
  write(folder.file("plan.png"), png_of(4, 3, pixels));
  std::string pgm = "P5 4 3 255\n";
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % 5 != 0) pgm += pixels[i];
  }
  write(folder.file("plan.pgm"), pgm);
  const std::string size = "metres_per_pixel='1'";
  CHECK(text_of(plan(folder.file("plan.png"), size)) ==
        text_of(plan(folder.file("plan.pgm"), size)));
  CHECK(drawn(plan(folder.file("plan.png"), size)).obstacles.size() == 3);
}

TEST_CASE("Walls that cannot be are refused in a sentence") {
  CHECK_THAT(refusal("<layouts><maze columns='200'/></layouts>"),
             Contains("walls of 0.1 m leave no room in them; give it fewer columns and rows"));
  CHECK_THAT(refusal("<layouts><maze length='12'/></layouts>"), Contains("outside of the arena"));
  CHECK_THAT(refusal("<layouts><rooms door='3'/></layouts>"),
             Contains("make the smallest room larger"));
  CHECK_THAT(refusal("<arena length='9000' width='9000'/><layouts><rooms/></layouts>"),
             Contains("could have more than 10000 rooms"));
  CHECK_THAT(refusal("<layouts><floor_plan/></layouts>"),
             Contains("has no walls; expected a file"));
  CHECK_THAT(refusal("<layouts><floor_plan file='a.pgm'><wall x1='0' y1='0' x2='1' y2='0'/>"
                     "</floor_plan></layouts>"),
             Contains("has a file and <wall>s; expected one of them"));
  CHECK_THAT(refusal(plan("nothing.png")), Contains("there is no such file"));
}

namespace {

/// The least distance, m, from a point to a wall or the arena's edge in the directions of the axes:
/// those to the left and to the right together, and likewise up and down.
double least_side(const world::World& world, double x, double y) {
  double left = -0.5 * world.arena.length, right = -left;
  double low = -0.5 * world.arena.width, high = -low;
  for (const world::Obstacle& box : world.obstacles) {
    const bool is_turned = box.heading_deg != 0.0 && std::abs(box.heading_deg) != 180.0;
    const double half_x = 0.5 * (is_turned ? box.width : box.length);
    const double half_y = 0.5 * (is_turned ? box.length : box.width);
    if (std::abs(y - box.y) < half_y) {
      (box.x < x ? left : right) =
          box.x < x ? std::max(left, box.x + half_x) : std::min(right, box.x - half_x);
    }
    if (std::abs(x - box.x) < half_x) {
      (box.y < y ? low : high) =
          box.y < y ? std::max(low, box.y + half_y) : std::min(high, box.y - half_y);
    }
  }
  return std::min(right - left, high - low);
}

}  // namespace

TEST_CASE("No room is narrower between its walls than the smallest may be") {
  for (const char* const border : {"false", "true"}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const world::World rooms =
          drawn("<layouts><rooms smallest='1.33333' door='0.6' wall_thickness='0.15' border='" +
                    std::string(border) + "'/></layouts>",
                seed);
      double least = 10.0;
      for (double x = -4.8; x < 4.81; x += 0.1973) {
        for (double y = -4.8; y < 4.81; y += 0.1973) {
          const bool is_in_wall = std::any_of(
              rooms.obstacles.begin(), rooms.obstacles.end(), [&](const world::Obstacle& box) {
                world::Footprint here = world::footprint_of(box);
                here.x = x, here.y = y, here.heading_rad = 0.0;
                here.half_length = here.half_width = 0.35;  // doors are no rooms
                return world::overlap(here, world::footprint_of(box));
              });
          if (!is_in_wall) least = std::min(least, least_side(rooms, x, y));
        }
      }
      CHECK(least >= 1.33333 - 1e-6);
    }
  }
  CHECK_THAT(refusal("<layouts><rooms length='2' smallest='2' border='true'/></layouts>"),
             Contains("has no room of 2 m between the walls around it"));
}

TEST_CASE("The walls around a maze or rooms are as thick as the others, within their area") {
  for (const std::string layout : {"maze columns='4' rows='4'", "rooms smallest='2'"}) {
    const world::World world = drawn("<layouts><" + layout +
                                     " length='8' width='6' wall_thickness='0.2' border='true'/>"
                                     "</layouts>");
    double right = 0.0, top = 0.0;
    for (const world::Footprint& wall : footprints(world)) {
      right = std::max(right, wall.x + wall.reach(1, 0));
      top = std::max(top, wall.y + wall.reach(0, 1));
      CHECK(wall.half_width == 0.1);
    }
    CHECK(right == Approx(4.0));
    CHECK(top == Approx(3.0));
  }
}

TEST_CASE("The boxes of an image leave no gaps, whatever the size of a pixel") {
  const Folder folder;
  const std::string file = folder.file("steps.pgm");
  write(file, "P2 3 3 255\n0 0 0\n255 0 0\n255 255 0\n");
  const world::World world = drawn(plan(file, "metres_per_pixel='0.33333'"));
  const auto edges = [&](bool is_low) {
    std::set<std::int64_t> all;
    for (const world::Obstacle& box : world.obstacles) {
      all.insert(std::llround(1e5 * (box.y + (is_low ? -0.5 : 0.5) * box.width)));
    }
    return all;
  };
  REQUIRE(world.obstacles.size() > 1);
  // Every lower edge but the lowest is an upper edge too.
  const auto low = edges(true), high = edges(false);
  CHECK(std::count_if(low.begin(), low.end(), [&](auto each) { return !high.contains(each); }) ==
        1);
}
