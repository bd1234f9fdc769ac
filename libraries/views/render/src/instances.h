// Turns a scene and its cameras into data for the graphics card.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "elsie/render/scene.h"

#include "atlas.h"
#include "meshes.h"

namespace elsie::render {

/// One mesh in one picture. The rows map a point of the mesh, with a fourth coordinate of 1, to the
/// camera: x to the right and y down, both relative to half the picture's width and height times
/// the distance w along the camera's axis.
struct Instance {
  float x[4], y[4], w[4];
  float
      place[4];  // of the picture in the atlas: half size and middle, in OpenGL's range of -1 to 1
  float light[3];  // direction to the light, in the mesh's axes
  std::uint8_t colour[4];
};

/// What to draw into an atlas: the instances of each mesh.
using DrawList = std::array<std::vector<Instance>, kMeshes>;

/// Appends the parts of the scene that the view may see.
void add_view(const Scene& scene, const View& view, const Atlas& atlas, const Tile& tile,
              DrawList& list);

}  // namespace elsie::render
