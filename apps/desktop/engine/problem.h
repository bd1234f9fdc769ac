// A problem of a file, as the engine reports it.
#pragma once

#include <QString>

namespace elsie::desktop {

struct Problem {
  QString file;
  int line = 0;  // from 1; 0 for the whole file
  QString message;
  bool is_warning = false;  // the world is valid, but may not run well

  bool operator==(const Problem&) const = default;
};

}  // namespace elsie::desktop
