// Moves arrows and labels apart that Graphviz puts too close together.
#pragma once

#include "elsie/picture/graph_picture.h"

namespace elsie::picture {

/// Where an arrow begins at the tip of another, the two look like one with two heads: its beginning
/// moves along the rim of its box.
void part_arrows(GraphLayout& layout);

/// A label on a rim, a node or another label moves to the nearest place where it can be read, near
/// its own arrow rather than another, and on none if one is near enough. That of an arrow inside a
/// frame stays inside, others stay outside.
void free_labels(GraphLayout& layout);

}  // namespace elsie::picture
