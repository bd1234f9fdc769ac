#include <catch2/catch.hpp>

#include "elsie/picture/image_file.h"

#include "support.h"

using namespace elsie;
using namespace elsie::picture;
using namespace elsie::picture::test;

namespace {

/// Every byte differs from its neighbours.
Image image_of(int width, int height, int channels) {
  Image image{width, height, channels, {}};
  for (int i = 0; i < width * height * channels; ++i) {
    image.bytes.push_back(static_cast<std::uint8_t>(37 * i));
  }
  return image;
}

}  // namespace

TEST_CASE("A camera's picture is written pixel by pixel, in colour or in grey") {
  const Folder folder;
  for (const int channels : {1, 3}) {
    for (const auto& [width, height] : {std::pair{100, 100}, {7, 3}, {1, 1}, {33, 250}}) {
      const Image image = image_of(width, height, channels);
      write_png(image, folder / "image.png");
      const Bitmap read(folder / "image.png");
      REQUIRE(read.width() == width);
      REQUIRE(read.height() == height);
      int wrong = 0;
      for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
          const std::uint8_t* pixel = image.pixel(column, row);
          const auto seen = read.at({static_cast<double>(column), static_cast<double>(row)});
          wrong += seen.red != pixel[0] || seen.green != pixel[channels == 3 ? 1 : 0] ||
                   seen.blue != pixel[channels == 3 ? 2 : 0];
        }
      }
      CHECK(wrong == 0);
    }
  }
}

TEST_CASE("The same image is the same file") {
  const Folder folder;
  write_png(image_of(40, 30, 3), folder / "a.png");
  write_png(image_of(40, 30, 3), folder / "b.png");
  CHECK(bytes_of(folder / "a.png") == bytes_of(folder / "b.png"));
  CHECK(folder.files() == 2);
}

TEST_CASE("What is no image is refused, and so is a place that cannot be written to") {
  const Folder folder;
  CHECK_THROWS_WITH(write_png({}, folder / "a.png"), Catch::Contains("An image of 0 x 0 pixels"));
  CHECK_THROWS_WITH(write_png(image_of(4, 4, 2), folder / "a.png"),
                    Catch::Contains("with 2 channels"));
  Image short_one = image_of(4, 4, 3);
  short_one.bytes.pop_back();
  CHECK_THROWS_WITH(write_png(short_one, folder / "a.png"), Catch::Contains("and 47 bytes"));
  CHECK_THROWS_WITH(write_png(image_of(4, 4, 3), folder / "nowhere" / "a.png"),
                    Catch::Contains("Cannot write the picture"));
  CHECK(folder.files() == 0);
}
