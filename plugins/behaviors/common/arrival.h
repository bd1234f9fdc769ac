// Being at a place: for behaviours that go to one and say once that they are there.
#pragma once

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>

class Arrival {
 public:
  void reset() { is_there_ = false; }
  void remember(elsie::Memory& memory) { memory("arrived", is_there_); }
  bool is_there() const { return is_there_; }

  /// In each step: it is there once it `comes`, and for as long as it `stays`. Returns whether it
  /// has come in this step.
  bool step(bool comes, bool stays) {
    const bool was_there = is_there_;
    is_there_ = comes || (was_there && stays);
    return comes && !was_there;
  }

  /// In each step of a behaviour that is done while it is there. The event is raised when it has
  /// come, also when it comes again.
  void tell(bool is_there, const char* event, elsie::Response& response) {
    if (step(is_there, is_there)) response.events.push_back({event});
    if (is_there) response.status = elsie::Status::success;
  }

 private:
  bool is_there_ = false;
};
