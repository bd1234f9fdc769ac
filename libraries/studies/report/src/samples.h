// What statistics and their intervals share.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "elsie/report/statistics.h"

namespace elsie::report {

std::vector<double> ascending(std::span<const double> values);

/// As relation_of(), but infinite for a ratio of anything else to 0.
std::optional<double> boundless_relation(Relation relation, Statistic statistic,
                                         std::span<const Pair> pairs);

}  // namespace elsie::report
