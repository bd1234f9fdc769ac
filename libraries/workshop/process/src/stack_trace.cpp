#include "stack_trace.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <string_view>

#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "elsie/plugin/own_library.h"

#include "loaded_libraries.h"

namespace elsie::process {
namespace {

constexpr int kMostFrames = 64;  // examined
constexpr int kMostShown = 24;

char addr2line[256];  // its path; "": not found

struct CodeLocation {
  const char* file = nullptr;  // of the library or program
  std::uintptr_t offset = 0;   // from its beginning
  const void* base = nullptr;
};

CodeLocation location_of(const void* address) {
  Dl_info info{};
  if (dladdr(address, &info) == 0 || !info.dli_fname) {
    return {};
  }
  const auto base = reinterpret_cast<std::uintptr_t>(info.dli_fbase);
  return {info.dli_fname, reinterpret_cast<std::uintptr_t>(address) - base, info.dli_fbase};
}

/// "0x1234", zero-terminated.
using Hex = std::array<char, 20>;
Hex hex(std::uintptr_t number) {
  Hex text{};
  char digits[16];
  std::size_t count = 0;
  do {
    digits[count++] = "0123456789abcdef"[number % 16];
    number /= 16;
  } while (number != 0);
  text[0] = '0';
  text[1] = 'x';
  std::reverse_copy(digits, digits + count, text.begin() + 2);
  return text;
}

/// The output of addr2line, in static memory, because nothing can be allocated.
struct Lines {
  char text[32 * 1024];
  std::size_t size = 0;

  std::string_view all() const { return {text, size}; }
};
Lines lines;

/// Takes " (discriminator 2)" out: locations of one line in the machine's code.
void leave_out_discriminators() {
  constexpr std::string_view kMark = " (discriminator ";
  for (std::size_t at; (at = lines.all().find(kMark)) != std::string_view::npos;) {
    const std::size_t end = std::min(lines.all().find(')', at), lines.size - 1) + 1;
    std::copy(lines.text + end, lines.text + lines.size, lines.text + at);
    lines.size -= end - at;
  }
}

/// Adds the output of a process, but does not wait for long.
void read_lines(int pipe, pid_t process) {
  constexpr int kPatience_ms = 5000;
  pollfd ready{pipe, POLLIN, 0};
  while (lines.size < sizeof(lines.text) && poll(&ready, 1, kPatience_ms) > 0) {
    const ssize_t count = read(pipe, lines.text + lines.size, sizeof(lines.text) - lines.size);
    if (count <= 0) {
      break;
    }
    lines.size += static_cast<std::size_t>(count);
  }
  leave_out_discriminators();
  for (int i = 0; i < 100 && waitpid(process, nullptr, WNOHANG) == 0; ++i) {
    const timespec pause{0, 10'000'000};
    nanosleep(&pause, nullptr);
  }
}

/// Asks addr2line for the lines of these locations in one file, with inlined calls.
void add_lines(const CodeLocation* locations, int count) {
  std::array<Hex, kMostShown> addresses;
  std::array<char*, kMostShown + 5> words{};
  char option[] = "-Cfpie";
  std::size_t size = 0;
  words[size++] = addr2line;
  words[size++] = option;
  words[size++] = const_cast<char*>(locations->file);
  for (int i = 0; i < count; ++i) {
    addresses[static_cast<std::size_t>(i)] = hex(locations[i].offset);
    words[size++] = addresses[static_cast<std::size_t>(i)].data();
  }
  int ends[2];
  if (pipe(ends) != 0) {
    return;
  }
  // Not fork(), which takes malloc's locks: the fault may have interrupted malloc.
  const pid_t child = _Fork();
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) {
      dup2(nowhere, STDERR_FILENO);
    }
    execv(addr2line, words.data());
    _exit(127);
  }
  close(ends[1]);
  if (child > 0) {
    read_lines(ends[0], child);
  }
  close(ends[0]);
}

/// Whether a line of addr2line, "function at file:line", is in the plugin's own source, neither the
/// system's nor Elsie's.
bool is_own_source(std::string_view line) {
  const std::size_t at = line.rfind(" at /");
  if (at == std::string_view::npos) {
    return false;  // "at ??:?"
  }
  const std::string_view file = line.substr(at + 4);
  return !file.starts_with("/usr/") && file.find("/include/elsie/") == std::string_view::npos;
}

/// The first line in the plugin's own source; "": none.
std::string_view first_own_line(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (is_own_source(line)) {
      constexpr std::string_view kInlined = " (inlined by) ";
      return line.starts_with(kInlined) ? line.substr(kInlined.size()) : line;
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return {};
}

}  // namespace

void write_error(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t count = write(STDERR_FILENO, text.data(), text.size());
    if (count <= 0) {
      return;
    }
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void prepare_stack_trace() {
  void* here[2];
  backtrace(here, 2);  // loads the library that it needs
  for (const char* file : {"/usr/bin/addr2line", "/usr/local/bin/addr2line"}) {
    if (addr2line[0] == '\0' && access(file, X_OK) == 0) {
      std::strncpy(addr2line, file, sizeof(addr2line) - 1);
    }
  }
}

namespace {

/// Asks for the lines of these locations, one library after the other.
void find_lines(const CodeLocation* locations, int count) {
  lines.size = 0;
  for (int first = 0, end = 0; first < count; first = end) {
    while (end < count && locations[end].base == locations[first].base) {
      ++end;
    }
    add_lines(locations + first, end - first);
  }
}

/// Writes the locations in their libraries, and in the source if that is known.
void write_locations(const CodeLocation* locations, int shown) {
  for (int i = 0; i < shown; ++i) {
    const char* const slash = std::strrchr(locations[i].file, '/');
    write_error("  ");
    write_error(slash ? slash + 1 : locations[i].file);
    write_error("+");
    write_error(hex(locations[i].offset).data());
    write_error("\n");
  }
  if (addr2line[0] == '\0') {
    write_error(
        "(install addr2line to see the lines of the source: on Debian, apt install binutils)\n");
    return;
  }
  find_lines(locations, shown);
  const std::string_view own = first_own_line(lines.all());
  if (!own.empty() && !lines.all().starts_with(own)) {
    write_error("the plugin's own line: ");
    write_error(own);
    write_error("\n");
  }
  write_error("in the source:\n");
  write_error(lines.all());
}

}  // namespace

std::string own_line(std::span<void* const> frames) {
  static std::mutex one_at_a_time;  // `lines` is shared
  const std::scoped_lock lock(one_at_a_time);
  std::array<CodeLocation, kMostShown> locations;
  int count = 0;
  for (void* const frame : frames) {
    const void* const call = static_cast<const char*>(frame) - 1;
    if (count < kMostShown && plugin_library_at(call)) {
      locations[static_cast<std::size_t>(count++)] = location_of(call);
    }
  }
  if (count == 0 || addr2line[0] == '\0') {
    return "";
  }
  find_lines(locations.data(), count);
  return std::string(first_own_line(lines.all()));
}

void write_stack_trace(const Fault& fault) noexcept {
  const void* const at = fault.at;
  if (at && !location_of(at).file) {  // the stack cannot be followed from there
    write_error("  ");
    write_error(hex(reinterpret_cast<std::uintptr_t>(at)).data());
    write_error(", where there is no code\n");
    const void* const back = fault.stack ? *fault.stack : fault.back;
    const CodeLocation caller =
        back ? location_of(static_cast<const char*>(back) - 1) : CodeLocation();
    if (caller.file) {
      write_locations(&caller, 1);
    }
    return;
  }
  void* frames[kMostFrames];
  const int count = backtrace(frames, kMostFrames);
  // The handler's own frames come first, then the signal's.
  const int found = static_cast<int>(std::find(frames, frames + count, at) - frames);
  const bool known = found < count;
  // Elsie's own code: this library, and the core, which calls the plugins.
  const void* const here = location_of(reinterpret_cast<const void*>(&write_stack_trace)).base;
  const void* const core = location_of(plugin::place_in_this_library()).base;
  CodeLocation locations[kMostShown];
  int shown = 0;
  bool left_own = known;
  for (int i = known ? found : 0; i < count && shown < kMostShown; ++i) {
    // All but the first are return addresses: the call is before them.
    const bool exact = known && i == found && !fault.is_after;
    const CodeLocation location =
        location_of(static_cast<const char*>(frames[i]) - (exact ? 0 : 1));
    const bool is_own = location.base == here || location.base == core;
    if (is_own && left_own && shown > 0) {
      break;
    }
    left_own = left_own || !is_own;
    if (left_own && location.file) {
      locations[shown++] = location;
    }
  }
  if (shown == 0) {
    write_error("  (the stack cannot be read)\n");
    return;
  }
  write_locations(locations, shown);
}

}  // namespace elsie::process
