// An assembled pipeline: checked once, run for every picture.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

#include <elsie/api/image.h>

#include "blobs.h"
#include "steps.h"

namespace vision {

class Pipeline {
 public:
  Pipeline() = default;
  /// `resource_colours`: the default of <match_colour>. Throws std::invalid_argument with a
  /// sentence for steps that do not fit together.
  Pipeline(const std::vector<Step>& steps, std::span<const elsie::Colour> resource_colours);

  /// Makes the mask of a picture with three channels, and finds the blob in it.
  std::optional<FoundBlob> run(const elsie::Image& picture, elsie::Image& mask);

 private:
  using Stage = std::function<void(const cv::Mat& from, cv::Mat& to)>;

  std::vector<Stage> stages_;
  Blob blob_;
  cv::Mat buffers_[2];
  BlobFinder finder_;
};

}  // namespace vision
