#include "floor_vocabulary.h"

#include <string>

#include "elsie/world/facts.h"

namespace elsie::world {
namespace {

ElementSpec point(const char* meaning, const char* x, const char* y) {
  return Describe<Vector2>("point", meaning)
      .required()
      .attribute("x", &Vector2::x, metres(x), kRequired)
      .attribute("y", &Vector2::y, metres(y), kRequired);
}

Describe<Patch> placed(PatchShape shape, const char* meaning, const char* x, const char* y) {
  Patch example;
  example.shape = shape;
  return Describe<Patch>(example.element(), meaning)
      .attribute("id", &Patch::id, fact("its name; by default its element's, with a number"), kId)
      .attribute("x", &Patch::x, metres(x))
      .attribute("y", &Patch::y, metres(y));
}

Describe<Patch> turned(Describe<Patch> patch) {
  return std::move(patch).attribute("heading_deg", &Patch::heading_deg,
                                    angle("counter-clockwise from east"));
}

ElementSpec patch(PatchShape shape) {
  const char *const east = "its middle, east", *const north = "its middle, north";
  const auto coloured = [](Describe<Patch> patch) {
    return std::move(patch).attribute("colour", &Patch::colour,
                                      fact("what sensors, cameras and pictures see"));
  };
  switch (shape) {
    case PatchShape::rectangle:
      return coloured(turned(placed(shape, "A rectangle on the floor", east, north))
                          .attribute("length", &Patch::length, size("along its own x", 1e4))
                          .attribute("width", &Patch::width, size("along its own y", 1e4)));
    case PatchShape::disc:
      return coloured(placed(shape, "A disc on the floor", east, north)
                          .attribute("radius", &Patch::radius, size("of its outline", 1e4)));
    case PatchShape::polygon:
      return coloured(
          turned(placed(shape, "A polygon on the floor, whose outline has 3 to 16 points", east,
                        north))
              .each(point("A corner of a convex outline", "along its own x, from any origin",
                          "along its own y"),
                    &Patch::points));
    case PatchShape::line:
      break;
  }
  return coloured(
      turned(placed(PatchShape::line,
                    "A line on the floor, through its points, with round ends and bends",
                    "the origin of its points, east", "the origin of its points, north"))
          .attribute("width", &Patch::line_width, size("across", 1e4))
          .each(point("A point of a line", "from its origin, along its own x",
                      "from its origin, along its own y"),
                &Patch::points));
}

// Adds the patches of one shape to a list.
Describe<World> with_patches(Describe<World> list, PatchShape shape) {
  return std::move(list).each(
      patch(shape), &World::patches, [=](const Patch& each) { return each.shape == shape; },
      [=](Patch& made) { made.shape = shape; });
}

}  // namespace

ElementSpec lamp() {
  return Describe<Lamp>("lamp", "A point light, without a body")
      .attribute("id", &Lamp::id, fact("its name; by default its element's, with a number"), kId)
      .attribute("x", &Lamp::x, metres("its place, east"))
      .attribute("y", &Lamp::y, metres("its place, north"))
      .attribute("z", &Lamp::z, positive("m", 100, "its height"))
      .attribute(
          "intensity", &Lamp::intensity,
          positive("", 1e6, "relative to the lamp for which the law of a light sensor is given"))
      .attribute("colour", &Lamp::colour, fact("of its light"));
}

ElementSpec field() {
  return Describe<ScalarField>("field", "Numbers over the floor that robots deposit and sense")
      .attribute("id", &ScalarField::id, fact("its name, which actuators and sensors give"),
                 kRequiredId)
      .attribute("cell", &ScalarField::cell, size("largest edge of a cell of its grid", 1e4))
      .attribute("half_life", &ScalarField::half_life,
                 positive("s", 1e9, "in which it evaporates to half; by default it stays"))
      .attribute("spread", &ScalarField::spread,
                 range("m2/s", 0, 1e4,
                       "the variance of a spot along an axis grows by twice as much in a second"))
      .attribute("start", &ScalarField::start,
                 range("units/m2", 0, 1e12, "everywhere when the field begins"))
      .attribute("full", &ScalarField::full,
                 positive("units/m2", 1e15,
                          "shown in its full colour; by default the largest value at that time"))
      .attribute("colour", &ScalarField::colour, fact("in pictures"));
}

ElementSpec floor() {
  const auto set = [](void* object, const ParameterValue& value) {
    static_cast<Floor*>(object)->image = std::get<std::string>(value);
  };
  const auto get = [](const void* object) -> std::optional<ParameterValue> {
    return static_cast<const Floor*>(object)->image;
  };
  return Describe<Floor>("floor", "The floor below everything else, without its patches")
      .attribute("colour", &Floor::colour,
                 fact("by default white to sensors; pictures and cameras then have their own"))
      .attribute("image", ParameterType::file,
                 fact("a PNG or PGM image that lies on it, with north at its top"), {}, set, get)
      .attribute("image_length", &Floor::image_length,
                 size("of the image, along x; by default the arena's", 1e4))
      .attribute("image_width", &Floor::image_width,
                 size("of the image, along y; by default the arena's", 1e4));
}

Describe<World> patches() {
  auto list = Describe<World>("patches",
                              "Areas of the floor with colours of their own; later ones "
                              "cover earlier ones")
                  .members("patch");
  for (const PatchShape shape :
       {PatchShape::rectangle, PatchShape::disc, PatchShape::polygon, PatchShape::line}) {
    list = with_patches(std::move(list), shape);
  }
  return list;
}

}  // namespace elsie::world
