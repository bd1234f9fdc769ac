#include "text_table.h"

#include <cstdio>

std::string text(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), format, value);
  return buffer;
}

std::string counted(std::int64_t count, const std::string& what) {
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

const char* are(std::int64_t count) { return count == 1 ? "is" : "are"; }
