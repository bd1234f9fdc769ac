// All observers of a run that the command line shows.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interrupts.h"
#include "progress.h"
#include "run_views.h"

namespace elsie::program {

class Watchers {
 public:
  /// `views`: null for none. `shows_progress`: on a terminal. `others` must outlive this.
  Watchers(std::unique_ptr<RunViews> views, bool shows_progress,
           std::span<simulation::Observer* const> others)
      : views_(std::move(views)) {
    if (views_) {
      all_.assign(views_->observers().begin(), views_->observers().end());
    }
    if (shows_progress) {
      all_.push_back(&progress_.emplace());
    }
    all_.push_back(&interrupt_);
    all_.insert(all_.end(), others.begin(), others.end());
  }
  Watchers(const Watchers&) = delete;
  Watchers& operator=(const Watchers&) = delete;

  std::span<simulation::Observer* const> all() const { return all_; }
  /// Draws the picture of the views, if they have one.
  void draw(const simulation::Simulation& simulation, const std::string& line) const {
    if (views_) {
      views_->draw(simulation, line);
    }
  }
  /// Shows the end of a live run until the user ends the program.
  void linger(const simulation::Simulation& simulation) const {
    if (views_) {
      views_->linger(simulation);
    }
  }

 private:
  std::unique_ptr<RunViews> views_;
  std::optional<ProgressBar> progress_;
  InterruptGuard interrupt_;
  std::vector<simulation::Observer*> all_;
};

}  // namespace elsie::program
