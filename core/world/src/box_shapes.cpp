#include "box_shapes.h"

#include "elsie/shapes/outline.h"
#include "elsie/world/facts.h"
#include "elsie/world/parts.h"

namespace elsie::world {
namespace {

ElementSpec point() {
  return Describe<Vector2>("point", "A corner of a convex outline, seen from above")
      .costs(Cost::engine)
      .required()
      .attribute("x", &Vector2::x, metres("along its own x, from any origin"), kRequired)
      .attribute("y", &Vector2::y, metres("along its own y"), kRequired);
}

constexpr std::array<BoxForm, kBoxShapes.size()> kForms{{
    {"",
     [](Describe<Box> box) -> Describe<Box> {
       return std::move(box)
           .attribute("length", &Box::length, size("along its own x"))
           .attribute("width", &Box::width, size("along its own y"));
     },
     [](const Box& box) {
       return Shape::box({box.length, box.width, box.height});
     }},
    {": an upright cylinder",
     [](Describe<Box> box) -> Describe<Box> {
       return std::move(box).attribute("radius", &Box::radius, size("of its outline"));
     },
     [](const Box& box) { return Shape::pillar(box.radius, box.height); }},
    {": an upright prism, whose outline has 3 to 16 points",
     [](Describe<Box> box) -> Describe<Box> { return std::move(box).each(point(), &Box::points); },
     [](const Box& box) { return Shape::prism(centered_outline(box.points), box.height); },
     [](const Box& box) { return problem_of_outline(box.points); }},
}};

}  // namespace

const BoxForm& form_of(BoxShape shape) { return kForms.at(static_cast<std::size_t>(shape)); }

const char* Box::shape_name() const { return kBoxShapes.at(static_cast<std::size_t>(shape)); }

std::optional<std::string> problem_of(const Box& box) {
  const BoxForm& form = form_of(box.shape);
  return form.problem ? form.problem(box) : std::nullopt;
}

}  // namespace elsie::world
