#include <memory>
#include <utility>

#include "simulation_impl.h"

namespace elsie::simulation {

Replacement Simulation::Impl::replace_plugins(const plugin::Host& host) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    own_robot(i);  // its description is adapted
  }
  Swap swap(host, seed_, options_.data_directories);
  for (const auto& robot : robots_) robot->replace(swap, *cameras_);
  if (start_) start_ = std::make_shared<const world::World>(swap.adapted(*start_));
  Replacement replacement = swap.settle();
  in_place_.emplace(world_, host, options_);
  host_ = &host;
  measuring_->list_replaced(host, replacement.notes);
  for (const Replacement::Object& object : replacement.objects) {
    events_.push_back({time_s(), object.robot, events::Replaced{object.path, object.plugin}});
  }
  ++renewals_;
  take_stock();
  return replacement;
}

}  // namespace elsie::simulation
