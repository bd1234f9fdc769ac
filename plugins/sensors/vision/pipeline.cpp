#include "pipeline.h"

#include <array>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>

#include <opencv2/imgproc.hpp>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

#include "colour_range.h"

namespace vision {
namespace {

using Stage = std::function<void(const cv::Mat&, cv::Mat&)>;

/// A colour space with its conversions from and to RGB.
struct Space {
  std::string_view name;
  int from_rgb, to_rgb;  // cv::ColorConversionCodes, or kNone
  bool has_hue;
};
constexpr int kNone = -1;
constexpr std::array<Space, 8> kSpaces{{{"rgb", kNone, kNone, false},
                                        {"hsv", cv::COLOR_RGB2HSV, cv::COLOR_HSV2RGB, true},
                                        {"hls", cv::COLOR_RGB2HLS, cv::COLOR_HLS2RGB, true},
                                        {"lab", cv::COLOR_RGB2Lab, cv::COLOR_Lab2RGB, false},
                                        {"luv", cv::COLOR_RGB2Luv, cv::COLOR_Luv2RGB, false},
                                        {"ycrcb", cv::COLOR_RGB2YCrCb, cv::COLOR_YCrCb2RGB, false},
                                        {"xyz", cv::COLOR_RGB2XYZ, cv::COLOR_XYZ2RGB, false},
                                        {"grey", cv::COLOR_RGB2GRAY, kNone, false}}};
const Space* const kRgb = &kSpaces.front();
const Space* const kGrey = &kSpaces.back();

const Space& space(std::string_view name) {
  for (const Space& known : kSpaces) {
    if (known.name == name) {
      return known;
    }
  }
  throw std::invalid_argument("there is no colour space '" + std::string(name) + "'");
}

/// The state of a picture between two steps: in a colour space, or a mask.
struct Kind {
  const Space* space = kRgb;  // none: a mask

  bool is_mask() const { return !space; }
  std::size_t channels() const { return is_mask() || space == kGrey ? 1 : 3; }
  std::string text() const {
    return is_mask() ? "a mask"
                     : "a picture in the colour space '" + std::string(space->name) + "'";
  }
};

std::string numbers(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    text += (text.empty() ? "" : " ") + elsie::base::number_text(value, 6);
  }
  return text;
}

/// Assembles the stages, step by step, and tracks the kind of picture that they make.
class Assembler {
 public:
  explicit Assembler(std::span<const elsie::Colour> colours) : resource_colours_(colours) {}

  void add(const Step& step) {
    ++number_;
    if (done_) {
      fail(name_of(step), "nothing may follow <blob>, which picks a blob of the finished mask");
    }
    std::visit([this](const auto& each) { add_step(each); }, step);
  }

  void finish() const {
    if (!kind_.is_mask()) {
      throw std::invalid_argument(
          "its pipeline ends with " + kind_.text() +
          ", in which no blob can be found; add a <threshold> or a <match_colour>");
    }
  }

  std::vector<Stage> stages;
  Blob blob;

 private:
  static const char* name_of(const Step& step) {
    constexpr const char* kNames[] = {"convert", "threshold", "match_colour", "blur", "erode",
                                      "dilate",  "open",      "close",        "blob"};
    return kNames[step.index()];
  }

  [[noreturn]] void fail(const char* step, const std::string& problem) const {
    throw std::invalid_argument("step " + std::to_string(number_) + " of its pipeline, <" + step +
                                ">: " + problem);
  }

  void need_picture(const char* step) const {
    if (kind_.is_mask()) {
      fail(step, "it needs a picture, but the step before it left a mask; put it before");
    }
  }

  void need_colours(const char* step) const {
    need_picture(step);
    if (kind_.space == kGrey) {
      fail(step, "it needs colours, but the picture is grey by now");
    }
  }

  /// Converts from the picture's current space.
  void convert(const Space& to) {
    if (kind_.space == &to) {
      return;
    }
    for (const int code : {kind_.space->to_rgb, to.from_rgb}) {
      if (code != kNone) {
        stages.emplace_back(
            [code](const cv::Mat& from, cv::Mat& made) { cv::cvtColor(from, made, code); });
      }
    }
    kind_.space = &to;
  }

  /// Keeps pixels in any of the ranges.
  void keep(std::vector<HsvRange> ranges) {
    stages.emplace_back(
        [ranges = std::move(ranges), more = cv::Mat()](const cv::Mat& from, cv::Mat& made) mutable {
          made.create(from.size(), CV_8U);
          if (ranges.empty()) {
            made.setTo(0);
            return;
          }
          cv::inRange(from, ranges[0].low, ranges[0].high, made);
          for (std::size_t i = 1; i < ranges.size(); ++i) {
            cv::inRange(from, ranges[i].low, ranges[i].high, more);
            cv::bitwise_or(made, more, made);
          }
        });
    kind_.space = nullptr;
  }

  void add_step(const Convert& step) {
    need_colours("convert");
    convert(space(step.to));
  }

  void add_step(const Threshold& step) {
    need_picture("threshold");
    const std::size_t channels = kind_.channels();
    if (step.low.size() != channels || step.high.size() != channels) {
      fail("threshold", "low is '" + numbers(step.low) + "' and high is '" + numbers(step.high) +
                            "', but " + kind_.text() + " has " +
                            elsie::base::counted(channels, "channel") +
                            "; give as many numbers for each");
    }
    cv::Scalar low, high;
    for (std::size_t i = 0; i < channels; ++i) {
      check_limits(step, i);
      low[static_cast<int>(i)] = step.low[i];
      high[static_cast<int>(i)] = step.high[i];
    }
    keep(kind_.space->has_hue ? hsv_ranges(low[0], high[0], low, high)
                              : std::vector<HsvRange>{{low, high}});
  }

  void check_limits(const Threshold& step, std::size_t channel) const {
    const double low = step.low[channel], high = step.high[channel];
    const bool hue = kind_.space->has_hue && channel == 0;
    // The default of 255 means no limit.
    for (const double value : {low, high}) {
      if (!(value >= 0.0 && value <= 255.0) || (hue && value > 180.0 && value < 255.0)) {
        fail("threshold", numbers({value}) + " is not a value of channel " +
                              std::to_string(channel + 1) + ", which counts from 0 to " +
                              (hue ? "180: hue in half degrees" : "255"));
      }
    }
    if (low > high && !hue) {
      fail("threshold", "the lower limit of channel " + std::to_string(channel + 1) + ", " +
                            numbers({low}) + ", is above the higher one, " + numbers({high}) +
                            "; only a hue may go round");
    }
  }

  void add_step(const MatchColour& step) {
    need_colours("match_colour");
    const std::vector<elsie::Colour> own = parse_colours(step.colours);
    std::vector<HsvRange> ranges =
        ranges_of(own.empty() ? resource_colours_ : std::span<const elsie::Colour>(own), step);
    convert(space("hsv"));
    keep(std::move(ranges));
  }

  void add_step(const Blur& step) {
    need_picture("blur");
    check_size("blur", step.size);
    const int size = step.size;
    stages.emplace_back([size, kind = step.kind](const cv::Mat& from, cv::Mat& made) {
      if (kind == "median") {
        cv::medianBlur(from, made, size);
      } else if (kind == "box") {
        cv::blur(from, made, {size, size});
      } else {
        cv::GaussianBlur(from, made, {size, size}, 0.0);
      }
    });
  }

  void add_step(const Erode& step) { add_morphology(cv::MORPH_ERODE, "erode", step); }
  void add_step(const Dilate& step) { add_morphology(cv::MORPH_DILATE, "dilate", step); }
  void add_step(const Open& step) { add_morphology(cv::MORPH_OPEN, "open", step); }
  void add_step(const Close& step) { add_morphology(cv::MORPH_CLOSE, "close", step); }

  void add_morphology(int operation, const char* name, const Morphology& step) {
    check_size(name, step.size);
    const int shape = step.shape == "cross"  ? cv::MORPH_CROSS
                      : step.shape == "disc" ? cv::MORPH_ELLIPSE
                                             : cv::MORPH_RECT;
    const cv::Mat element = cv::getStructuringElement(shape, {step.size, step.size});
    stages.emplace_back(
        [operation, element, times = step.times](const cv::Mat& from, cv::Mat& made) {
          cv::morphologyEx(from, made, operation, element, {-1, -1}, times);
        });
  }

  void check_size(const char* name, int size) const {
    if (size % 2 == 0) {
      fail(name, "its size is " + std::to_string(size) +
                     " pixels, but must be an odd number, so that it has a middle");
    }
  }

  void add_step(const Blob& step) {
    if (!kind_.is_mask()) {
      fail("blob", "it needs a mask, but there is " + kind_.text() +
                       "; put a <threshold> or a <match_colour> before it");
    }
    if (step.max_area > 0.0 && step.max_area < step.min_area) {
      fail("blob", "max_area (" + numbers({step.max_area}) + ") is below min_area (" +
                       numbers({step.min_area}) + "): no blob would do");
    }
    blob = step;
    done_ = true;
  }

  std::span<const elsie::Colour> resource_colours_;
  Kind kind_;
  int number_ = 0;
  bool done_ = false;
};

class OpenCvPipeline final : public Pipeline {
 public:
  OpenCvPipeline(const std::vector<Step>& steps, std::span<const elsie::Colour> resource_colours) {
    Assembler assembler(resource_colours);
    for (const Step& step : steps) {
      assembler.add(step);
    }
    assembler.finish();
    stages_ = std::move(assembler.stages);
    blob_ = assembler.blob;
  }

  std::optional<FoundBlob> run(const elsie::Image& picture, elsie::Image& mask) override {
    mask.width = picture.width;
    mask.height = picture.height;
    mask.channels = 1;
    mask.bytes.resize(static_cast<std::size_t>(picture.width) *
                      static_cast<std::size_t>(picture.height));
    // cv::Mat has no read-only form; the stages do not write to the first one.
    cv::Mat from(picture.height, picture.width, CV_8UC3,
                 const_cast<std::uint8_t*>(picture.bytes.data()));
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      cv::Mat& made = buffers_[i % 2];
      stages_[i](from, made);
      from = made;
    }
    from.copyTo(cv::Mat(picture.height, picture.width, CV_8U, mask.bytes.data()));
    return choose(finder_.find(mask.bytes, mask.width, mask.height), blob_, mask.width,
                  mask.height);
  }

 private:
  std::vector<Stage> stages_;
  Blob blob_;
  cv::Mat buffers_[2];
  BlobFinder finder_;
};

}  // namespace

}  // namespace vision

extern "C" [[gnu::visibility("default")]] vision::Pipeline* elsie_vision_make_pipeline(
    const std::vector<vision::Step>& steps, std::span<const elsie::Colour> resource_colours) {
  return std::make_unique<vision::OpenCvPipeline>(steps, resource_colours).release();
}
