// Colours that other views share with pictures from above.
#pragma once

#include "elsie/api/image.h"

namespace elsie::picture {

inline constexpr Colour kGoalColour{0x00, 0x80, 0x5c};

}  // namespace elsie::picture
