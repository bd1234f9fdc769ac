#include "elsie/render/scene.h"

namespace elsie::render {
namespace {

Frame bottom_of(const Frame& middle, double height) {
  return {middle.point({0.0, 0.0, -0.5 * height}), middle.forward, middle.left, middle.up};
}

/// The frame of an upright cylinder as one of the scene, which lies along its left axis.
Frame lying(const Frame& upright) {
  return {upright.origin, upright.forward, upright.up, -1.0 * upright.left};
}

}  // namespace

std::vector<Placed> add(Scene& scene, const Shape& shape, const Frame& middle, const Colour& colour,
                        std::size_t carrier, Material material) {
  std::vector<Placed> placed;
  const auto append = [&](auto& list, const Piece& piece, auto solid) {
    placed.push_back({piece.shape.kind, list.size(), piece.frame});
    list.push_back(std::move(solid));
    list.back().material = material;
  };
  for (const Piece& piece : pieces_of(shape, middle)) {
    const Shape& own = piece.shape;
    switch (own.kind) {
      case Shape::Kind::box:
        append(scene.boxes, piece, Box{{}, own.size, colour, carrier});
        break;
      case Shape::Kind::prism:
        append(scene.prisms, piece, Prism{{}, own.outline, own.size.z, colour, carrier});
        break;
      case Shape::Kind::cylinder:
        append(scene.cylinders, piece, Cylinder{{}, own.radius(), own.length(), colour, carrier});
        break;
      default:
        append(scene.balls, piece, Ball{{}, own.radius(), colour, carrier});
    }
  }
  put(scene, placed, Frame{});
  return placed;
}

void put(Scene& scene, const std::vector<Placed>& body, const std::optional<Frame>& frame) {
  const auto show = [&](auto& solid) -> auto& {
    solid.visible = frame.has_value();
    return solid;
  };
  for (const Placed& piece : body) {
    const Frame middle = frame.value_or(Frame{}).frame(piece.frame);
    switch (piece.kind) {
      case Shape::Kind::box: {
        Box& box = show(scene.boxes[piece.index]);
        box.frame = bottom_of(middle, box.size.z);
        break;
      }
      case Shape::Kind::prism: {
        Prism& prism = show(scene.prisms[piece.index]);
        prism.frame = bottom_of(middle, prism.height);
        break;
      }
      case Shape::Kind::cylinder:
        show(scene.cylinders[piece.index]).frame = lying(middle);
        break;
      default:
        show(scene.balls[piece.index]).middle = middle.origin;
    }
  }
}

}  // namespace elsie::render
