// The image of a floor on the graphics card.
#pragma once

#include <epoxy/gl.h>

#include "elsie/api/image.h"

namespace elsie::render {

/// Loads an image into the texture that is bound, with this filter of its pixels. Throws
/// RenderError for one that is too large.
void load_floor(const Image& image, GLint filter);

}  // namespace elsie::render
