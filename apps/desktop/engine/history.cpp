#include "engine/history.h"

namespace elsie::desktop {

void History::clear() {
  entries_.clear();
  place_ = 0;
}

void History::push(Entry entry) {
  entries_.resize(place_);
  entry.at_ms = clock_.elapsed();
  if (!entries_.empty()) {
    Entry& last = entries_.back();
    if (!entry.merge.isEmpty() && last.merge == entry.merge && last.file == entry.file &&
        last.is_opened == entry.is_opened && entry.at_ms - last.at_ms < kMerging_ms) {
      last.after = entry.after;
      last.at_ms = entry.at_ms;
      if (last.after == last.before) {
        entries_.pop_back();
        --place_;
      }
      return;
    }
  }
  entries_.push_back(std::move(entry));
  ++place_;
}

void History::stop_merging() {
  if (place_ > 0) {
    entries_[place_ - 1].merge.clear();
  }
}

const History::Entry* History::next_undo() const {
  return place_ > 0 ? &entries_[place_ - 1] : nullptr;
}

const History::Entry* History::next_redo() const {
  return place_ < entries_.size() ? &entries_[place_] : nullptr;
}

void History::undone() { entries_[--place_].merge.clear(); }

void History::redone() { ++place_; }

}  // namespace elsie::desktop
