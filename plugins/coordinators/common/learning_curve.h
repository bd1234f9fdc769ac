// The learning curve of a network, for pictures.
#pragma once

#include <elsie/api/curve.h>
#include <elsie/neural/training.h>

/// The mean error of an epoch over the presentations so far, "error". At most 200 points: the first
/// ones unchanged, where errors fall fastest, then means over steps of equal ratio.
elsie::Curve learning_curve(const elsie::neural::Training& training);
