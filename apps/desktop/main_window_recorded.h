// The recording that a window plays.
#pragma once

#include "main_window.h"
#include "recorded_world.h"

namespace elsie::desktop {

struct MainWindow::Recorded {
  QString title;
  RecordedWorld world;
  QString text;     // as it was opened
  QString verdict;  // on the run that was made of it; "": none yet
};

}  // namespace elsie::desktop
