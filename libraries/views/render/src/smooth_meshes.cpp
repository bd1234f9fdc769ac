#include <cmath>
#include <numbers>
#include <utility>

#include "elsie/api/geometry.h"

#include "meshes.h"

// Its functions have the names of those of the other meshes.
namespace elsie::render::smooth {
namespace {

constexpr int kCylinderSides = 24;
constexpr int kBallSides = 24;
constexpr int kBallRings = 12;
constexpr int kDiscSides = 48;

double turn(int part, int parts) { return 2.0 * std::numbers::pi * part / parts; }

class Builder {
 public:
  int corner(const Vector3& at, const Vector3& normal, const Vector3& inset = {}) {
    mesh_.vertices.push_back({{single(at.x), single(at.y), single(at.z)},
                              {single(normal.x), single(normal.y), single(normal.z)},
                              {single(inset.x), single(inset.y), single(inset.z)}});
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }
  /// A flat face with its corners in counter-clockwise order.
  void face(const std::vector<int>& corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      for (const int corner : {corners[0], corners[i], corners[i + 1]}) {
        mesh_.indices.push_back(static_cast<std::uint16_t>(corner));
      }
    }
  }
  void face(const std::vector<Vector3>& corners, const Vector3& normal) {
    std::vector<int> made;
    for (const Vector3& each : corners) made.push_back(corner(each, normal));
    face(made);
  }
  /// As face(), with the side out on which `outwards` is, whatever the order of the corners.
  void face_towards(std::vector<int> corners, const Vector3& outwards) {
    const auto place = [&](std::size_t i) {
      const SmoothVertex& vertex = mesh_.vertices[static_cast<std::size_t>(corners[i])];
      // A bevel of any size has the same order.
      const auto moved = [&](int axis) {
        return static_cast<double>(vertex.position[axis]) -
               0.1 * static_cast<double>(vertex.inset[axis]);
      };
      return Vector3{moved(0), moved(1), moved(2)};
    };
    const Vector3 a = place(1) - place(0), b = place(2) - place(0);
    const Vector3 normal{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    if (dot(normal, outwards) < 0.0) corners = {corners.rbegin(), corners.rend()};
    face(corners);
  }
  SmoothMesh take() { return std::move(mesh_); }

 private:
  SmoothMesh mesh_;
};

constexpr Vector3 kUp{0.0, 0.0, 1.0};

/// Three corners for each of a cube's, one in each of the faces that meet there; a face for each
/// side, each edge and each corner.
SmoothMesh box_mesh() {
  Builder build;
  const auto sign = [](int bits, int axis) { return bits >> axis & 1 ? 1.0 : -1.0; };
  const auto along = [](int axis, double value) {
    return Vector3{axis == 0 ? value : 0.0, axis == 1 ? value : 0.0, axis == 2 ? value : 0.0};
  };
  int corners[8][3];
  for (int bits = 0; bits < 8; ++bits) {
    const Vector3 at{0.5 * sign(bits, 0), 0.5 * sign(bits, 1), 0.5 + 0.5 * sign(bits, 2)};
    for (int axis = 0; axis < 3; ++axis) {
      Vector3 inset{sign(bits, 0), sign(bits, 1), sign(bits, 2)};
      inset = inset - along(axis, sign(bits, axis));
      corners[bits][axis] = build.corner(at, along(axis, sign(bits, axis)), inset);
    }
  }
  // First the sides, which are a whole box if the bevel has no width.
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
    for (const int side : {0, 1 << axis}) {
      build.face_towards({corners[side][axis], corners[side | u][axis], corners[side | u | v][axis],
                          corners[side | v][axis]},
                         along(axis, side ? 1.0 : -1.0));
    }
  }
  for (int axis = 0; axis < 3; ++axis) {  // the edges along it
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const int u = 1 << next, v = 1 << last;
    for (const int edge : {0, u, v, u | v}) {
      const int far = edge | 1 << axis;
      build.face_towards(
          {corners[edge][next], corners[far][next], corners[far][last], corners[edge][last]},
          along(next, edge & u ? 1.0 : -1.0) + along(last, edge & v ? 1.0 : -1.0));
    }
  }
  for (int bits = 0; bits < 8; ++bits) {
    build.face_towards({corners[bits][0], corners[bits][1], corners[bits][2]},
                       {sign(bits, 0), sign(bits, 1), sign(bits, 2)});
  }
  return build.take();
}

SmoothMesh wedge_mesh() {
  Builder build;
  build.face({{1, -0.5, 0}, {1, 0.5, 0}, {1, 0.5, 1}, {1, -0.5, 1}}, {1, 0, 0});
  build.face({{0, 0, 0}, {1, 0.5, 0}, {1, -0.5, 0}}, {0, 0, -1});
  build.face({{0, 0, 1}, {1, -0.5, 1}, {1, 0.5, 1}}, kUp);
  return build.take();
}

SmoothMesh cylinder_mesh() {
  Builder build;
  std::vector<int> left, right;
  const auto rim = [](int i, double y) {
    const double angle = turn(i, kCylinderSides);
    return Vector3{std::cos(angle), y, std::sin(angle)};
  };
  for (int i = 0; i < kCylinderSides; ++i) {
    std::vector<int> side;
    for (const auto& [k, y] : {std::pair{i, -0.5}, {i, 0.5}, {i + 1, 0.5}, {i + 1, -0.5}}) {
      side.push_back(build.corner(rim(k, y), rim(k, 0.0)));
    }
    build.face(side);
    right.push_back(build.corner(rim(i, -0.5), {0, -1, 0}));
    left.insert(left.begin(), build.corner(rim(i, 0.5), {0, 1, 0}));
  }
  build.face(right);
  build.face(left);
  return build.take();
}

SmoothMesh ball_mesh() {
  Builder build;
  const auto place = [](int ring, int side) {
    const double up = std::numbers::pi * (static_cast<double>(ring) / kBallRings - 0.5);
    const double round = turn(side, kBallSides);
    return Vector3{std::cos(up) * std::cos(round), std::cos(up) * std::sin(round), std::sin(up)};
  };
  for (int ring = 0; ring <= kBallRings; ++ring) {
    for (int side = 0; side < kBallSides; ++side) {
      build.corner(place(ring, side), place(ring, side));
    }
  }
  for (int ring = 0; ring < kBallRings; ++ring) {
    for (int side = 0; side < kBallSides; ++side) {
      const auto at = [&](int r, int s) { return r * kBallSides + s % kBallSides; };
      build.face({at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)});
    }
  }
  return build.take();
}

SmoothMesh square_mesh() {
  Builder build;
  build.face({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, kUp);
  return build.take();
}

SmoothMesh triangle_mesh() {
  Builder build;
  build.face({{0, 0, 0}, {1, -0.5, 0}, {1, 0.5, 0}}, kUp);
  return build.take();
}

SmoothMesh disc_mesh() {
  Builder build;
  std::vector<Vector3> corners;
  for (int i = 0; i < kDiscSides; ++i) {
    corners.push_back({std::cos(turn(i, kDiscSides)), std::sin(turn(i, kDiscSides)), 0.0});
  }
  build.face(corners, kUp);
  return build.take();
}

}  // namespace

std::array<SmoothMesh, kMeshes> all() {
  return {square_mesh(), square_mesh(), triangle_mesh(), disc_mesh(),
          box_mesh(),    wedge_mesh(),  cylinder_mesh(), ball_mesh()};
}

}  // namespace elsie::render::smooth

namespace elsie::render {

std::array<SmoothMesh, kMeshes> smooth_meshes() { return smooth::all(); }

}  // namespace elsie::render
