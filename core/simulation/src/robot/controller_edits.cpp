// A controller becomes what an edited world describes.
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
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    slots_[i]->use = &next.behaviors[i];
    if (slots_[i]->inside) slots_[i]->inside->describe(inside_of(next.behaviors[i]));
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
  undo.keep(slots_, description_, coordinator_);
  const auto slots = slots_;
  slots_.clear();
  std::vector<std::size_t> formers;  // index among the old slots; their number if new
  for (const world::BehaviorUse& use : next.behaviors) {
    const std::size_t former = index_of(was.behaviors, use.id, 0);
    const bool is_known = former < slots.size();
    const bool stays = is_known && world::same(was.behaviors[former], use, world::Cost::object) &&
                       was.behaviors[former].inside.empty() == use.inside.empty() &&
                       transaction.keeps(*slots[former], was.behaviors[former], use);
    formers.push_back(stays ? former : slots.size());
    if (!stays) {
      slots_.push_back(make_slot(use, transaction.host(), transaction.problems()));
      if (is_known) {
        transaction.note_lost(robot, path + use.id);
      }
      continue;
    }
    slots_.push_back(slots[former]);
    if (const auto& inside = slots[former]->inside) {
      inside->become(inside_of(was.behaviors[former]), inside_of(use), path + use.id + "/",
                     transaction);
    }
  }
  description_ = &next;
  list_slots();
  const bool same_members = slots_ == slots;
  for (std::size_t i = 0; i < formers.size(); ++i) {
    if (formers[i] < slots.size()) {
      members_[i].trace = (*members)[formers[i]].trace;
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
