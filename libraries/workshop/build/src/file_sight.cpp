#include "file_sight.h"

#include <chrono>
#include <fstream>
#include <iterator>
#include <sstream>
#include <thread>
#include <utility>

#include <sys/stat.h>

namespace elsie::build {
namespace {

namespace fs = std::filesystem;

std::int64_t status_change_of(const fs::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) != 0
             ? 0
             : std::int64_t{status.st_ctim.tv_sec} * 1'000'000'000 + status.st_ctim.tv_nsec;
}

}  // namespace

Hash& Hash::add(std::string_view bytes) {
  hash_.add(bytes);
  hash_.add_byte(0xff);  // so that "ab", "c" differs from "a", "bc"
  return *this;
}

std::string Hash::text() const {
  std::ostringstream out;
  out << std::hex << hash_.value();
  return out.str();
}

std::optional<std::string> content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return std::nullopt;
  }
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

Sight look_at(const std::vector<fs::path>& files) {
  Sight sight;
  for (const fs::path& file : files) {
    Seen seen;
    seen.hash = Hash().add(content_of(file).value_or("")).text();
    seen.status_changed_ns =
        status_change_of(file);  // last, so that it is no older than the content
    sight.emplace(file, std::move(seen));
  }
  return sight;
}

std::optional<fs::path> changed_file(const Sight& before, const Sight& after,
                                     std::int64_t start_ns) {
  for (const auto& [file, now] : after) {
    const auto old = before.find(file);
    if (old == before.end() ? now.status_changed_ns > start_ns : old->second != now) {
      return file;
    }
  }
  return std::nullopt;
}

std::int64_t instant_before_now(const fs::path& scratch) {
  constexpr int kMostMilliseconds = 50;
  const auto instant = [&] {
    std::ofstream(scratch) << ' ';
    return status_change_of(scratch);
  };
  const std::int64_t first = instant();
  for (int i = 0; i < kMostMilliseconds; ++i) {
    if (instant() > first) {
      return first;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return first - 1;
}

}  // namespace elsie::build
