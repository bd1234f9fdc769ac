// The fields of a world over the image of its floor.
#pragma once

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/render/scene.h"

#include "engine/json.h"

namespace elsie::desktop {

/// The image of the floor with its patches, which cover it; later ones cover earlier ones.
render::FloorImage with_patches(const render::FloorImage& below, const Colour& floor,
                                const Vector2& arena,
                                const std::vector<render::FlatPatch>& patches);

/// An image of the whole arena, of this size in m, with the fields of an event `state` over the
/// floor; the floor's own image without fields. `floor`: where it has none.
render::FloorImage with_fields(const render::FloorImage& below, const Colour& floor,
                               const Vector2& arena, const Json& fields);

}  // namespace elsie::desktop
