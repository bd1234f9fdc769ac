// Shared by statistics and their intervals.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "elsie/report/statistics.h"

namespace elsie::report {

std::vector<double> ascending(std::span<const double> values);

/// As relation_of(), but infinite for the ratio of a nonzero value to 0.
std::optional<double> boundless_relation(Relation relation, Statistic statistic,
                                         std::span<const Pair> pairs);

}  // namespace elsie::report
