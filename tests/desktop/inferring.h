// A robot whose fuzzy inference is shown.
#pragma once

#include "watch/fuzzy_instant.h"
#include "watch/fuzzy_panel.h"
#include "window.h"

namespace elsie::desktop {

/// The fuzzy viewer in front, with the inference of a run that has paused.
inline FuzzyPanel* inferring(Window& window) {
  window->arrange("watch");
  show_dock(window.window(), "dock_fuzzy");
  auto* fuzzy = window->findChild<FuzzyPanel*>();
  window.bench().run();
  REQUIRE(wait_for([&] { return !fuzzy->now().degrees.empty(); }));
  window.bench().pause();
  return fuzzy;
}

}  // namespace elsie::desktop
