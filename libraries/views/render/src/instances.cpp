#include "instances.h"

#include <algorithm>
#include <cmath>

#include "elsie/render/renderer.h"

#include "bodies.h"

namespace elsie::render {
namespace {

// Half the edge of the drawn floor. Beyond it, the floor is less than a pixel high.
constexpr double kFloorReach = 1000.0;  // m

class Eye {
 public:
  Eye(const View& view, const Atlas& atlas, const Tile& tile)
      : frame_(view.frame),
        across_(1.0 / std::tan(0.5 * view.camera.horizontal_fov_rad)),
        down_(across_ * view.camera.width / view.camera.height),
        across_slack_(std::hypot(1.0, across_)),
        down_slack_(std::hypot(1.0, down_)),
        place_{static_cast<float>(tile.width) / static_cast<float>(atlas.width),
               static_cast<float>(tile.height) / static_cast<float>(atlas.height),
               static_cast<float>(2 * tile.x + tile.width) / static_cast<float>(atlas.width) - 1.0F,
               static_cast<float>(2 * tile.y + tile.height) / static_cast<float>(atlas.height) -
                   1.0F} {}

  /// True if part of a ball may be in the picture.
  bool may_see(const Vector3& middle, double radius) const {
    const Vector3 d = middle - frame_.origin;
    const double w = dot(frame_.forward, d);
    return w + radius >= kNearest &&
           std::abs(across_ * dot(frame_.left, d)) <= w + across_slack_ * radius &&
           std::abs(down_ * dot(frame_.up, d)) <= w + down_slack_ * radius;
  }

  Instance instance(const Body& body, const Vector3& light, const Colour& colour) const {
    Instance made{};
    fill(made.x, (-across_) * frame_.left, body);
    fill(made.y, (-down_) * frame_.up, body);
    fill(made.w, frame_.forward, body);
    std::copy(std::begin(place_), std::end(place_), made.place);
    made.light[0] = static_cast<float>(light.x);
    made.light[1] = static_cast<float>(light.y);
    made.light[2] = static_cast<float>(light.z);
    made.colour[0] = colour.red;
    made.colour[1] = colour.green;
    made.colour[2] = colour.blue;
    made.colour[3] = 255;
    return made;
  }

  const Vector3& origin() const { return frame_.origin; }

 private:
  void fill(float row[4], const Vector3& direction, const Body& body) const {
    row[0] = static_cast<float>(dot(direction, body.x));
    row[1] = static_cast<float>(dot(direction, body.y));
    row[2] = static_cast<float>(dot(direction, body.z));
    row[3] = static_cast<float>(dot(direction, body.origin - frame_.origin));
  }

  Frame frame_;
  double across_, down_;  // 1 / tan of half the field of view, in width and height
  double across_slack_, down_slack_;
  float place_[4];
};

}  // namespace

void add_view(const Scene& scene, const View& view, const Atlas& atlas, const Tile& tile,
              DrawList& list) {
  const Eye eye(view, atlas, tile);
  const auto emit = [&](MeshKind mesh, const Body& body, const Vector3& light,
                        const Surface& surface) {
    list[mesh].push_back(eye.instance(body, light, surface.colour));
  };
  emit(kSquare,
       Body{{eye.origin().x, eye.origin().y, 0.0},
            {kFloorReach, 0.0, 0.0},
            {0.0, kFloorReach, 0.0},
            {0.0, 0.0, 1.0}},
       kFullLight, Surface{scene.floor});
  visit_bodies(
      scene, view.carrier,
      [&](const Vector3& middle, double radius) { return eye.may_see(middle, radius); }, emit);
}

}  // namespace elsie::render
