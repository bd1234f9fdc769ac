// What plugins draw, for the snapshots of a window.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/simulation/simulation.h"
#include "elsie/snapshots/snapshots.h"

namespace elsie::server {

/// What plugins draw, and the outlines of robots where their localisations believe them to be.
class Marks {
 public:
  /// Marks beyond these are counted only.
  static constexpr std::size_t kMost = 200'000;

  /// Lists the present ones. Robots with a plugin that fails to draw are left out from then on; a
  /// note says so once.
  void list(const simulation::Simulation& simulation);
  /// A new run has begun, or its plugins have changed.
  void forget_failures() { failed_.clear(); }

  const std::vector<snapshots::MarkState>& listed() const { return marks_; }
  std::size_t left_out() const { return left_out_; }
  std::vector<simulation::Note> take_notes() { return std::exchange(notes_, {}); }

 private:
  template <class List>
  void add_all(const std::string& whose, const List& list);
  void add(const Sketch& sketch);
  void add_belief(const simulation::RobotView& robot);
  void add(Sketch::Kind kind, SketchRole role, const Vector3& from, const Vector3& to,
           std::string_view text = {});

  std::vector<snapshots::MarkState> marks_;
  std::size_t left_out_ = 0;
  std::set<std::string> failed_;  // robots; "": measures
  std::vector<simulation::Note> notes_;
};

}  // namespace elsie::server
