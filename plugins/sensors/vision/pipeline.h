// An assembled pipeline: checked once, run for every picture.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <elsie/api/image.h>

#include "blobs.h"
#include "steps.h"

namespace vision {

class Pipeline {
 public:
  virtual ~Pipeline() = default;
  /// Makes the mask of a picture with three channels, and finds the blob in it.
  virtual std::optional<FoundBlob> run(const elsie::Image& picture, elsie::Image& mask) = 0;
};

/// Loads libelsie-vision, and OpenCV with it, at the first call: worlds without cameras do not need
/// it. `resource_colours`: the default of <match_colour>. Throws std::invalid_argument with a
/// sentence for steps that do not fit together, std::runtime_error if it cannot be loaded.
std::unique_ptr<Pipeline> make_pipeline(const std::vector<Step>& steps,
                                        std::span<const elsie::Colour> resource_colours);

/// The function that libelsie-vision exports; the caller owns the pipeline.
using MakePipeline = Pipeline* (*)(const std::vector<Step>&, std::span<const elsie::Colour>);
inline constexpr const char* kMakePipeline = "elsie_vision_make_pipeline";

}  // namespace vision
