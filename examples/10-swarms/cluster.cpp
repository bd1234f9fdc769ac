// Clustering (Deneubourg et al. 1991; Beckers, Holland and Deneubourg 1994): a robot picks up a
// puck the more likely, the fewer others are around it, and puts it down the more likely, the more
// others are there. Nobody knows of the clusters that grow.
#include <algorithm>
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/commands/gripper.h>
#include <elsie/readings/omnidirectional_camera.h>

constexpr elsie::Colour kPuck{46, 158, 79};

class Cluster final : public elsie::Behavior {
 public:
  double pick_up = 1.0;   // pucks
  double put_down = 1.0;  // pucks
  double rest = 4.0;      // s

  void reset(elsie::Random& random) override {
    random_ = &random;
    rests_until_s_ = 0.0;
    is_refused_ = false;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const auto& blobs = now.readings<elsie::OmnidirectionalReading>()[0]->blobs;
    const bool is_carrying = !now.self().held.empty();
    elsie::Response response;
    response.activation = 0.0;
    response.act(elsie::GripCommand{is_carrying});
    // The nearest puck that it does not carry; the nearest come first.
    const auto puck = std::find_if(blobs.begin(), blobs.end(), [&](const auto& blob) {
      return blob.colour() == kPuck && !(is_carrying && blob.distance_m < kArm);
    });
    if (puck == blobs.end()) return response;
    const bool rests = now.time_s() < rests_until_s_;
    if (rests || is_refused_) {
      // Around pucks that it leaves alone.
      if (puck->distance_m > kFar) is_refused_ = false;
      const bool is_ahead = std::abs(puck->bearing_rad) < 1.0;
      if (puck->distance_m < kNear && is_ahead) {
        response.activation = 1.0;
        response.command = {is_carrying ? 0.0 : -0.05, 0.0, puck->bearing_rad > 0 ? -1.5 : 1.5};
      }
      return response;
    }
    response.activation = 1.0;
    response.command = {0.15 * std::max(0.0, std::cos(puck->bearing_rad)), 0.0,
                        3.0 * puck->bearing_rad};
    if (puck->distance_m > (is_carrying ? kNear : kGrasp)) return response;
    const auto others = std::count_if(blobs.begin(), blobs.end(), [&](const auto& blob) {
      const double along = blob.distance_m * std::cos(blob.bearing_rad - puck->bearing_rad);
      const double across = blob.distance_m * std::sin(blob.bearing_rad - puck->bearing_rad);
      return blob.colour() == kPuck && &blob != &*puck &&
             std::hypot(along - puck->distance_m, across) < kAround &&
             !(is_carrying && blob.distance_m < kArm);
    });
    const double share = is_carrying
                             ? (1.0 + others) / (put_down + 1.0 + others)  // with the puck itself
                             : pick_up / (pick_up + others);
    if (random_->chance(share * share)) {
      response.acts.clear();
      response.act(elsie::GripCommand{!is_carrying});
      if (is_carrying) rests_until_s_ = now.time_s() + rest;
    } else {
      is_refused_ = true;  // until it has left them
    }
    return response;
  }

 private:
  static constexpr double kArm = 0.1;      // m, to what it carries
  static constexpr double kGrasp = 0.085;  // m
  static constexpr double kNear = 0.16;    // m
  static constexpr double kFar = 0.3;      // m
  static constexpr double kAround = 0.15;  // m

  elsie::Random* random_ = nullptr;
  double rests_until_s_ = 0.0;
  bool is_refused_ = false;
};

ELSIE_BEHAVIOR(Cluster, "cluster", "Carries pucks from where few are to where many are",
               elsie::needs<elsie::OmnidirectionalReading>(), elsie::commands<elsie::GripCommand>(),
               elsie::parameter("pick_up", &Cluster::pick_up,
                                {.unit = "pucks",
                                 .above = 0,
                                 .meaning = "around one that it picks up in every fourth case"}),
               elsie::parameter("put_down", &Cluster::put_down,
                                {.unit = "pucks",
                                 .above = 0,
                                 .meaning = "where it puts one down in every fourth case"}),
               elsie::parameter("rest", &Cluster::rest,
                                {.unit = "s",
                                 .min = 0,
                                 .meaning = "without a look at pucks, after one was put down"}));
