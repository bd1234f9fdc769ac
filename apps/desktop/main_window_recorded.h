// The recording that a window plays.
#pragma once

#include "main_window.h"
#include "recorded_world.h"

namespace elsie::desktop {

struct MainWindow::Recorded {
  QString title;
  RecordedWorld world;
  QString text;     // the world's text when it was opened
  QString verdict;  // on the run that was made here; "" before it has ended
};

}  // namespace elsie::desktop
