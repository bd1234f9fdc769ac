// A controller becomes what an edited world describes.
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "elsie/world/same.h"

#include "edits/transaction.h"
#include "robot/controller.h"

namespace elsie::simulation {

std::vector<Member> Controller::copied_members() {
  Member::Runner& runner = *this;
  std::vector<Member> copies;
  for (const Member& member : members_) {
    copies.emplace_back(member.name(), member.priority(), runner).trace = member.trace;
  }
  return copies;
}

/// Members keep their addresses if their number does not change.
void Controller::take_members(std::vector<Member> members) {
  if (members.size() == members_.size()) {
    std::move(members.begin(), members.end(), members_.begin());
  } else {
    members_ = std::move(members);
  }
}

void Controller::describe(const world::Coordination& next) {
  description_ = &next;
  for (const auto& slot : slots_) {
    slot->use = &use_of(*slot);
    if (slot->inside) slot->inside->describe(inside_of(use_of(*slot)));
  }
  if (coordinator_) coordinator_->use = &*next.coordinator;
}

void Controller::become(const world::Coordination& was, const world::Coordination& next,
                        const std::string& path, EditTransaction& transaction) {
  Undo& undo = transaction.undo();
  const std::string& robot = setting_.guard.robot();
  // Added before the slots of the members, so it is undone after them.
  const auto members = std::make_shared<std::vector<Member>>(copied_members());
  undo.add([this, members] { take_members(std::move(*members)); });
  undo.keep(slots_, movers_, description_, coordinator_);
  const auto slots = slots_;
  slots_.clear();
  for (std::size_t place = 0; place < next.behaviors.size(); ++place) {
    const world::BehaviorUse& use = next.behaviors[place];
    const std::size_t former = index_of(was.behaviors, use.id, 0);
    const auto known = std::find_if(slots.begin(), slots.end(),
                                    [&](const auto& slot) { return slot->place == former; });
    const bool stays = known != slots.end() &&
                       world::same(was.behaviors[former], use, world::Cost::object) &&
                       was.behaviors[former].inside.empty() == use.inside.empty() &&
                       transaction.keeps(**known, was.behaviors[former], use);
    if (!stays) {
      slots_.push_back(make_slot(use, transaction.host(), transaction.problems()));
      if (known != slots.end()) {
        transaction.note_lost(robot, path + use.id);
      }
      continue;
    }
    slots_.push_back(*known);
    if (const auto& inside = (*known)->inside) {
      inside->become(inside_of(was.behaviors[former]), inside_of(use), path + use.id + "/",
                     transaction);
    }
  }
  for (std::size_t place = 0; place < slots_.size(); ++place) {
    undo.keep(slots_[place]->place);
    slots_[place]->place = place;
  }
  description_ = &next;
  sort_slots();
  list_slots();
  const bool same_members = slots_ == slots;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto former = std::find(slots.begin(), slots.end(), slots_[i]);
    if (former != slots.end()) {
      members_[i].trace = (*members)[static_cast<std::size_t>(former - slots.begin())].trace;
      if (!same_members) {
        members_[i].trace.inhibited_by = -1;
      }
    }
  }
  if (was.coordinator && next.coordinator &&
      transaction.keeps(*coordinator_, *was.coordinator, *next.coordinator)) {
    if (!same_members) {
      transaction.note_other_equipment(*coordinator_);
    }
    return;
  }
  make_coordinator(transaction.host(), transaction.problems());
  if (was.coordinator && next.coordinator) {
    transaction.note_lost(robot, path + next.coordinator->id);
  }
}

}  // namespace elsie::simulation
