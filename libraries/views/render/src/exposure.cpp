#include "elsie/render/exposure.h"

namespace elsie::render {

void Exposure::begin(int width, int height) {
  width_ = width;
  height_ = height;
  passes_ = 0;
  pass_.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

void Exposure::add() {
  // A single pass, of a picture that moves, needs no sums: it is put into them by the second one.
  if (passes_ == 0) {
    pass_.swap(first_);
    pass_.resize(first_.size());
  } else {
    if (passes_ == 1) sums_.assign(first_.begin(), first_.end());
    for (std::size_t i = 0; i < pass_.size(); ++i) {
      sums_[i] = static_cast<std::uint16_t>(sums_[i] + pass_[i]);
    }
  }
  ++passes_;
}

void Exposure::develop(std::vector<std::uint32_t>& pixels) const {
  const std::size_t count = pass_.size() / 4;
  pixels.resize(count);
  const auto put = [&](std::size_t at, std::uint32_t red, std::uint32_t green, std::uint32_t blue,
                       std::uint32_t open) {
    pixels[at] = open << 24U | red << 16U | green << 8U | blue;
  };
  if (passes_ == 1) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint8_t* const pixel = &first_[4 * i];
      put(i, pixel[0], pixel[1], pixel[2], pixel[3]);
    }
    return;
  }
  // Multiplying by the rounded reciprocal is exact enough for sums below 2^16.
  const std::uint32_t part = (1U << 16U) / static_cast<std::uint32_t>(passes_);
  const auto mean = [part](std::uint32_t sum) { return (sum * part + (1U << 15U)) >> 16U; };
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint16_t* const sum = &sums_[4 * i];
    put(i, mean(sum[0]), mean(sum[1]), mean(sum[2]), mean(sum[3]));
  }
}

}  // namespace elsie::render
