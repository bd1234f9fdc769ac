// Turns a scene into data for pictures for people: all bodies, in the frame of the camera's place.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "elsie/render/exposure.h"
#include "elsie/render/scene.h"

#include "meshes.h"

namespace elsie::render {

inline constexpr std::size_t kMaterials = 4;
inline std::size_t index_of(Material material) { return static_cast<std::size_t>(material); }

/// One mesh. The rows map a point of the mesh, with a fourth coordinate of 1, to the world, from
/// the camera's place.
struct ShownBody {
  float x[4], y[4], z[4];
  std::uint8_t colour[4];  // the last is unused
  float bevel[3];          // of the lengths of the axes
};

/// The dark ground around something that stands on the floor, where little of the sky is seen.
struct ShownContact {
  float middle[2];   // from the camera's place
  float forward[2];  // unit vector
  float half[2];     // of what stands there, m
  float rounding;    // of its corners, m
  float reach;       // m
  float strength;
};

struct ShownStroke {
  float from[3], to[3];  // from the camera's place
  std::uint8_t colour[4];
  float width, dash;  // px
};

struct ShownGlow {
  float middle[3];  // from the camera's place
  float radius;
  std::uint8_t colour[4];
};

struct ShownList {
  std::array<std::vector<ShownBody>, kBox> flat;  // on the floor
  std::vector<ShownBody> around;                  // the floor outside the arena, with shadows
  std::vector<ShownBody> beyond;                  // and where none falls
  std::array<std::array<std::vector<ShownBody>, kMeshes>, kMaterials> solids;
  std::vector<ShownBody> near_walls;  // between the camera and the arena
  std::vector<ShownContact> contacts;
  std::vector<ShownStroke> drawing, strokes;
  std::vector<ShownGlow> halos, pools;
  double tallest = 0.0;     // m, the top of the highest body
  bool is_bevelled = true;  // false where there are very many boxes
};

/// What a view shows.
ShownList list_shown(const Scene& scene, const View& view, const Style& style);

}  // namespace elsie::render
