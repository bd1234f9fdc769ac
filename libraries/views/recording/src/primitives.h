// The schemas of the parts of a scene (foxglove.SceneEntity).
#pragma once

#include "schema_parts.h"

namespace elsie::recording::schemas::primitives {

inline Json point() {
  return object("foxglove.Point3", {{"x", number()}, {"y", number()}, {"z", number()}});
}

inline Json arrow() {
  return object("foxglove.ArrowPrimitive", {{"pose", pose()},
                                            {"shaft_length", number()},
                                            {"shaft_diameter", number()},
                                            {"head_length", number()},
                                            {"head_diameter", number()},
                                            {"color", colour()}});
}
inline Json cube() {
  return object("foxglove.CubePrimitive",
                {{"pose", pose()}, {"size", vector()}, {"color", colour()}});
}
inline Json sphere() {
  return object("foxglove.SpherePrimitive",
                {{"pose", pose()}, {"size", vector()}, {"color", colour()}});
}
inline Json cylinder() {
  return object("foxglove.CylinderPrimitive", {{"pose", pose()},
                                               {"size", vector()},
                                               {"bottom_scale", number()},
                                               {"top_scale", number()},
                                               {"color", colour()}});
}
inline Json line() {
  return object("foxglove.LinePrimitive",
                {{"type", choice("foxglove.LineType",
                                 {{"LINE_STRIP", 0}, {"LINE_LOOP", 1}, {"LINE_LIST", 2}})},
                 {"pose", pose()},
                 {"thickness", number()},
                 {"scale_invariant", boolean()},
                 {"points", list(point())},
                 {"color", colour()},
                 {"colors", list(colour())},
                 {"indices", list(integer())}});
}
inline Json triangles() {
  return object("foxglove.TriangleListPrimitive", {{"pose", pose()},
                                                   {"points", list(point())},
                                                   {"color", colour()},
                                                   {"colors", list(colour())},
                                                   {"indices", list(integer())}});
}
inline Json text() {
  return object("foxglove.TextPrimitive", {{"pose", pose()},
                                           {"billboard", boolean()},
                                           {"font_size", number()},
                                           {"scale_invariant", boolean()},
                                           {"color", colour()},
                                           {"text", schemas::text()}});
}
inline Json model() {
  return object("foxglove.ModelPrimitive", {{"pose", pose()},
                                            {"scale", vector()},
                                            {"color", colour()},
                                            {"override_color", boolean()},
                                            {"url", schemas::text()},
                                            {"media_type", schemas::text()},
                                            {"data", base64_text()}});
}

}  // namespace elsie::recording::schemas::primitives
