// Blobs in a mask: connected pixels, corners included.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "steps.h"

namespace vision {

struct FoundBlob {
  double area = 0.0;    // px
  double column = 0.0;  // of the centre of area, counted from the left edge of the picture
  double row = 0.0;     // likewise from the top
};

/// Finds the blobs of masks; reuses its memory.
class BlobFinder {
 public:
  /// All blobs of a mask of bytes 0 and 255, row by row without gaps, in the order of their first
  /// pixels. Valid until the next call.
  std::span<const FoundBlob> find(std::span<const std::uint8_t> mask, int width, int height);

 private:
  /// A stretch of 255 in one row: columns from `begin` to before `end`.
  struct Run {
    int begin, end, row;
    std::size_t parent;  // the run itself, or an earlier one of the same blob
  };

  std::size_t root(std::size_t run);
  void link_to_row_above(std::size_t run, std::size_t& above, std::size_t first_of_row);

  std::vector<Run> runs_;
  std::vector<std::size_t> blob_of_;
  std::vector<FoundBlob> blobs_;
};

/// The blob that the step selects; in a tie, the first. None if no blob has an allowed size.
std::optional<FoundBlob> choose(std::span<const FoundBlob> blobs, const Blob& wanted, int width,
                                int height);

}  // namespace vision
