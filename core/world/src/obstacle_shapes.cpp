#include "obstacle_shapes.h"

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
     [](Describe<Obstacle> obstacle) -> Describe<Obstacle> {
       return std::move(obstacle)
           .attribute("length", &Obstacle::length, size("along its own x"))
           .attribute("width", &Obstacle::width, size("along its own y"));
     },
     [](const Obstacle& obstacle) {
       return Shape::box({obstacle.length, obstacle.width, obstacle.height});
     }},
    {": an upright cylinder",
     [](Describe<Obstacle> obstacle) -> Describe<Obstacle> {
       return std::move(obstacle).attribute("radius", &Obstacle::radius, size("of its outline"));
     },
     [](const Obstacle& obstacle) { return Shape::pillar(obstacle.radius, obstacle.height); }},
    {": an upright prism, whose outline has 3 to 16 points",
     [](Describe<Obstacle> obstacle) -> Describe<Obstacle> {
       return std::move(obstacle).each(point(), &Obstacle::points);
     },
     [](const Obstacle& obstacle) {
       return Shape::prism(centered_outline(obstacle.points), obstacle.height);
     },
     [](const Obstacle& obstacle) { return problem_of_outline(obstacle.points); }},
}};

}  // namespace

const BoxForm& form_of(ObstacleShape shape) { return kForms.at(static_cast<std::size_t>(shape)); }

const char* Obstacle::shape_name() const { return kBoxShapes.at(static_cast<std::size_t>(shape)); }

std::optional<std::string> problem_of(const Obstacle& obstacle) {
  const BoxForm& form = form_of(obstacle.shape);
  return form.problem ? form.problem(obstacle) : std::nullopt;
}

}  // namespace elsie::world
