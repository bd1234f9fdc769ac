// What tests of windows wait for, however slow the machine is.
#pragma once

#include <QTest>
#include <QWidget>
#include <functional>

#include <catch2/catch.hpp>

namespace elsie::desktop {

inline constexpr int kPatience_ms = 60'000;

inline bool wait_for(const std::function<bool()>& is_so) {
  return QTest::qWaitFor(is_so, kPatience_ms);
}

/// Gives a window the keys. A bare X server does it only if it is asked, and not before the window
/// is shown.
inline bool is_activated(QWidget& window) {
  if (!window.isActiveWindow()) window.activateWindow();
  return window.isActiveWindow();
}
inline void activate(QWidget& window) {
  REQUIRE(wait_for([&] { return is_activated(window); }));
}

}  // namespace elsie::desktop
