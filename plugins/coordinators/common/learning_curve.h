// The learning curve of a network, for those who draw it.
#pragma once

#include <elsie/api/curve.h>
#include <elsie/neural/training.h>

/// The mean error of an epoch over the presentations so far, "error". At most 200 points: as dense
/// as they are at the beginning, where an error falls fastest, and then in steps of equal ratio, of
/// which each is the mean of what is in it.
elsie::Curve learning_curve(const elsie::neural::Training& training);
