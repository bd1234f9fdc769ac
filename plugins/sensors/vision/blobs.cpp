#include "blobs.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vision {
namespace {

/// The first column from `from` with this value, or `width`.
int next(const std::uint8_t* row, int from, int width, int value) {
  const void* found = std::memchr(row + from, value, static_cast<std::size_t>(width - from));
  return found ? static_cast<int>(static_cast<const std::uint8_t*>(found) - row) : width;
}

}  // namespace

std::size_t BlobFinder::root(std::size_t run) {
  while (runs_[run].parent != run) {
    run = runs_[run].parent = runs_[runs_[run].parent].parent;
  }
  return run;
}

// `above` is the first run of the row above that may touch this one or later ones.
void BlobFinder::link_to_row_above(std::size_t run, std::size_t& above, std::size_t first_of_row) {
  const int begin = runs_[run].begin, end = runs_[run].end;
  while (above < first_of_row && runs_[above].end < begin) {
    ++above;
  }
  for (std::size_t other = above; other < first_of_row && runs_[other].begin <= end; ++other) {
    const std::size_t a = root(run), b = root(other);
    runs_[std::max(a, b)].parent = std::min(a, b);
  }
}

std::span<const FoundBlob> BlobFinder::find(std::span<const std::uint8_t> mask, int width,
                                            int height) {
  runs_.clear();
  std::size_t first_above = 0;  // a run of the row above
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* row = mask.data() + static_cast<std::ptrdiff_t>(y) * width;
    const std::size_t first = runs_.size();
    std::size_t above = first_above;
    for (int x = next(row, 0, width, 255); x < width; x = next(row, x, width, 255)) {
      const int end = next(row, x, width, 0);
      runs_.push_back({x, end, y, runs_.size()});
      link_to_row_above(runs_.size() - 1, above, first);
      x = end;
    }
    first_above = first;
  }

  blobs_.clear();
  blob_of_.resize(runs_.size());
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    const std::size_t first = root(i);
    if (first == i) {
      blob_of_[i] = blobs_.size();
      blobs_.emplace_back();
    }
    FoundBlob& blob = blobs_[blob_of_[first]];
    const double length = run.end - run.begin;
    blob.area += length;
    blob.column += length * 0.5 * (run.begin + run.end);
    blob.row += length * (run.row + 0.5);
  }
  for (FoundBlob& blob : blobs_) {
    blob.column /= blob.area;
    blob.row /= blob.area;
  }
  return blobs_;
}

std::optional<FoundBlob> choose(std::span<const FoundBlob> blobs, const Blob& wanted, int width,
                                int height) {
  const auto merit = [&](const FoundBlob& blob) {
    if (wanted.choose == "leftmost") {
      return -blob.column;
    }
    if (wanted.choose == "rightmost") {
      return blob.column;
    }
    if (wanted.choose == "highest") {
      return -blob.row;
    }
    if (wanted.choose == "lowest") {
      return blob.row;
    }
    if (wanted.choose == "nearest_centre") {
      return -std::hypot(blob.column - 0.5 * width, blob.row - 0.5 * height);
    }
    return blob.area;
  };
  const FoundBlob* best = nullptr;
  for (const FoundBlob& blob : blobs) {
    const bool fits =
        blob.area >= wanted.min_area && (wanted.max_area <= 0.0 || blob.area <= wanted.max_area);
    if (fits && (!best || merit(blob) > merit(*best))) {
      best = &blob;
    }
  }
  return best ? std::optional(*best) : std::nullopt;
}

}  // namespace vision
