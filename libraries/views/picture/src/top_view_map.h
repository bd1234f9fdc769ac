// The position of a point of the world in a picture of it from above.
#pragma once

#include "elsie/picture/axis.h"
#include "elsie/picture/size.h"
#include "elsie/picture/top_view.h"

namespace elsie::picture {

/// Maps points of the world (m) to the picture of save_top_view(), in pixels from its upper left
/// corner.
PlaneMap top_view_map(const TopView& view, const Size& size = {});

}  // namespace elsie::picture
