// The numbers that plugins publish, as messages.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "elsie/simulation/simulation.h"

#include "format.h"

namespace elsie::recording {

/// Visits the numbers of a robot, or those of measures.
using VisitAllPublished = std::function<void(const simulation::VisitPublished&)>;

/// The schema of their messages, with units and meanings; "" if there are none.
std::string published_schema(const std::string& title, const VisitAllPublished& visit_all);
/// For the metadata of their channel: path, name and unit of each number, as JSON.
std::string numbers_text(const VisitAllPublished& visit_all);
/// By the paths of plugins and the names of numbers. Numbers that do not exist now are left out.
Json published_message(std::uint64_t time_ns, const VisitAllPublished& visit_all);

}  // namespace elsie::recording
