// The gain from a second worker: whole batches of the program with one worker and with two, in
// turn.
//
//   batch_throughput PROGRAM
//
// Then 10,000 short runs with two workers: as copies of a process, and as programs of their own.
// Median of 3 pairs.
//
// Runs have several lengths: in short runs, starting processes and writing results take a larger
// share. Every batch lasts seconds, so that reading the experiment matters little. Median of 9
// pairs of batches. Prints Markdown.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>

#include "statistics.h"

namespace {

namespace fs = std::filesystem;

constexpr int kPairs = 9;

struct Work {
  const char* name;
  const char* world;
  int endure;  // the world's goal, from 1, that sets the length of a run
  int simulated_s;
  int runs;
};
constexpr Work kWork[] = {{"clutter, 10 s", "clutter.xml", 3, 10, 200},
                          {"clutter, 100 s", "clutter.xml", 3, 100, 50},
                          {"ten robots, 60 s", "ten_robots.xml", 2, 60, 16}};

/// A folder that is removed at the end.
class Folder {
 public:
  Folder() : path_((fs::temp_directory_path() / "elsie-bench-XXXXXX").string()) {
    if (!mkdtemp(path_.data())) {
      throw std::runtime_error("cannot make a folder");
    }
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  fs::path operator/(const std::string& name) const { return fs::path(path_) / name; }

 private:
  std::string path_;
};

void write_experiment(const fs::path& file, const Work& work) {
  std::ofstream(file) << "<experiment format=\"1\"><worlds><world file=\"" << ELSIE_SOURCE_DIR
                      << "/worlds/" << work.world << "\"/></worlds><set path=\"goal[" << work.endure
                      << "]/@time\" value=\"" << work.simulated_s << "\"/><seeds from=\"1\" to=\""
                      << work.runs << "\"/><limits time=\"" << work.simulated_s
                      << "\"/></experiment>\n";
}

/// Seconds from a batch's command to its end.
double seconds_of(const std::string& program, const Folder& folder, int workers,
                  const std::string& more = "") {
  const fs::path database = folder / "results.sqlite";
  fs::remove(database);
  const std::string command = "'" + program + "' batch '" + (folder / "work.xml").string() +
                              "' --quiet --database '" + database.string() + "' --workers " +
                              std::to_string(workers) + more;
  const auto start = std::chrono::steady_clock::now();
  const int status = std::system(command.c_str());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (status != 0) {
    throw std::runtime_error("a batch failed");
  }
  return seconds;
}

void measure(const std::string& program, const Work& work) {
  const Folder folder;
  write_experiment(folder / "work.xml", work);
  std::vector<double> one, two, ratio;
  for (int pair = 0; pair < kPairs; ++pair) {
    one.push_back(work.runs / seconds_of(program, folder, 1));
    two.push_back(work.runs / seconds_of(program, folder, 2));
    ratio.push_back(two.back() / one.back());
  }
  std::printf("| %s | %d | %.1f | %.1f | %.2f | %.2f to %.2f |\n", work.name, work.runs,
              elsie::bench::median(one), elsie::bench::median(two), elsie::bench::median(ratio),
              *std::min_element(ratio.begin(), ratio.end()),
              *std::max_element(ratio.begin(), ratio.end()));
  std::fflush(stdout);
}

/// Seconds of processor time of all processes that have ended.
double processor_seconds() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

void compare(const std::string& program) {
  constexpr Work kShort{"clutter, 1 s", "clutter.xml", 3, 1, 10'000};
  constexpr int kShortPairs = 3;
  const Folder folder;
  write_experiment(folder / "work.xml", kShort);
  std::vector<double> copies, programs, ratio, copies_ms, programs_ms;
  for (int pair = 0; pair < kShortPairs; ++pair) {
    const double start = processor_seconds();
    copies.push_back(kShort.runs / seconds_of(program, folder, 2));
    const double middle = processor_seconds();
    programs.push_back(kShort.runs / seconds_of(program, folder, 2, " --fresh-processes"));
    copies_ms.push_back(1e3 * (middle - start) / kShort.runs);
    programs_ms.push_back(1e3 * (processor_seconds() - middle) / kShort.runs);
    ratio.push_back(copies.back() / programs.back());
  }
  std::printf(
      "\n| runs of | runs in a batch | copies, runs/s | programs, runs/s | ratio | spread of the "
      "ratio | copies, ms of processor time a run | programs, ms |\n|---|---|---|---|---|---|---|"
      "---|\n| %s | %d | %.0f | %.0f | %.1f | %.1f to %.1f | %.2f | %.2f |\n",
      kShort.name, kShort.runs, elsie::bench::median(copies), elsie::bench::median(programs),
      elsie::bench::median(ratio), *std::min_element(ratio.begin(), ratio.end()),
      *std::max_element(ratio.begin(), ratio.end()), elsie::bench::median(copies_ms),
      elsie::bench::median(programs_ms));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: batch_throughput PROGRAM\n");
    return 2;
  }
  try {
    std::printf(
        "| runs of | runs in a batch | one worker, runs/s | two workers, runs/s | ratio | spread "
        "of the ratio "
        "|\n|---|---|---|---|---|---|\n");
    for (const Work& work : kWork) {
      measure(argv[1], work);
    }
    compare(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "batch_throughput: %s\n", error.what());
    return 1;
  }
}
