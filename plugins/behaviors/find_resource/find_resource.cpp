// Drives to the resource that the camera sees, and turns in place to find one when it sees none.
//
// Columns are counted from the middle of the picture to the right, in hundredths of its width: -50
// is the left edge. For the original camera of 100 x 100 pixels these are pixels.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>
#include <elsie/api/vision.h>

namespace {

class FindResource final : public elsie::Behavior, public elsie::Remembers {
 public:
  double turn_above = 5.0;
  double gain = 1.0;
  double speed = 20.0;
  std::string search = "column";
  double search_column = -50.0;
  double search_activation = 0.2;
  double lost_after = 0.5;

  void reset(elsie::Random&) override {
    in_view_ = false;
    last_column_.reset();
  }
  void remember(elsie::Memory& memory) override {
    memory("in_view", in_view_);
    memory("last_seen_s", last_seen_s_);
    memory("last_column", last_column_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const auto views = now.readings<elsie::VisionReading>();
    const auto nearest = elsie::most_nearly_ahead(now);
    elsie::Response response;
    if (nearest) {
      const Target target = look(*nearest);
      last_column_ = target.column;
      response.command = now.self().wheels.motion(steer(target.column, target.fov_deg));
      response.activation = 0.5 + 0.5 * target.size;
    } else if (!views.empty()) {
      response.command = now.self().wheels.motion(steer(column_to_search(), fov_of(views[0])));
      response.activation = search_activation;
    }
    watch(nearest.has_value(), now.time_s(), response);
    return response;
  }

 private:
  /// Raises events. A blob at the edge of the picture may disappear and reappear: only one that was
  /// not seen for a while is lost.
  void watch(bool seen, double time_s, elsie::Response& response) {
    if (seen) {
      last_seen_s_ = time_s;
      if (!in_view_) {
        in_view_ = true;
        response.events.push_back({"resource_in_view"});
      }
    } else if (in_view_ && time_s - last_seen_s_ >= lost_after) {
      in_view_ = false;
      response.events.push_back({"resource_out_of_view"});
    }
  }

  /// The column to which it steers while it sees no resource.
  double column_to_search() const {
    if (search == "column" || !last_column_) {
      return search_column;
    }
    return search == "last_column" ? *last_column_ : std::copysign(search_column, *last_column_);
  }

  struct Target {
    double column = 0.0;
    double fov_deg = 0.0;
    double size = 0.0;  // edge of the blob relative to the picture's, in [0, 1]
  };

  static double fov_of(const elsie::Sensed<elsie::VisionReading>& view) {
    return elsie::degrees(view->horizontal_fov_rad);
  }

  /// The blob of one camera. A camera that looks to the side is a part of one wide picture: its
  /// columns follow those of the neighbouring cameras, 100 for each field of view.
  static Target look(const elsie::Sensed<elsie::VisionReading>& view) {
    const double fov_deg = fov_of(view);
    const double width = view->width;
    double column = 100.0 * (view->column - 0.5 * width) / width;
    if (view.azimuth_rad() != 0.0) {
      const double around = 100.0 * 360.0 / fov_deg;
      column =
          std::remainder(column - 100.0 * elsie::degrees(view.azimuth_rad()) / fov_deg, around);
    }
    const double pixels = width * view->height;
    return {column, fov_deg, std::clamp(std::sqrt(view->area_px / pixels), 0.0, 1.0)};
  }

  elsie::WheelRates steer(double column, double fov_deg) const {
    if (std::abs(column) > turn_above) {
      const double rate = gain * column / fov_deg;
      return {rate, -rate};
    }
    return {speed, speed};
  }

  bool in_view_ = false;  // as reported by events
  double last_seen_s_ = 0.0;
  std::optional<double> last_column_;  // where a resource was seen last
};

}  // namespace

ELSIE_BEHAVIOR(
    FindResource, "find_resource",
    "Drives to the resource that a camera sees; turns in place while none is seen",
    elsie::needs<elsie::VisionReading>(),
    elsie::parameter(
        "turn_above", &FindResource::turn_above,
        {.unit = "1/100 width",
         .min = 0,
         .max = 50,
         .meaning =
             "beyond this distance from the picture's middle, in hundredths of its width, it turns "
             "to the resource in place"}),
    elsie::parameter("gain", &FindResource::gain,
                     {.unit = "rad/s",
                      .min = 0,
                      .max = 500,
                      .meaning = "wheel rate in a turn: times the column, divided by the field of "
                                 "view in degrees"}),
    elsie::parameter("speed", &FindResource::speed,
                     {.unit = "rad/s", .min = 0, .max = 500, .meaning = "wheel rate straight on"}),
    elsie::parameter(
        "search", &FindResource::search,
        {.choices = {"column", "last_column", "last_side"},
         .meaning = "while nothing is seen: 'column' searches as search_column says, 'last_column' "
                    "goes on as if the resource were still where it was seen last, 'last_side' "
                    "takes search_column towards the side on which it was seen last"}),
    elsie::parameter("search_column", &FindResource::search_column,
                     {.unit = "1/100 width",
                      .min = -50,
                      .max = 50,
                      .meaning = "while nothing is seen it acts as if a resource were here, in "
                                 "hundredths of the width; -50 is the left edge"}),
    elsie::parameter(
        "search_activation", &FindResource::search_activation,
        {.min = 0,
         .max = 1,
         .meaning = "activation while nothing is seen; it is 0.5 to 1 while something is"}),
    elsie::parameter("lost_after", &FindResource::lost_after,
                     {.unit = "s",
                      .min = 0,
                      .meaning = "time without a resource after which resource_out_of_view is "
                                 "raised; commands do not wait"}),
    elsie::raises("resource_in_view", "a resource has come into view"),
    elsie::raises("resource_out_of_view",
                  "no resource was in view for a while (lost_after): lost, hidden or collected"));
