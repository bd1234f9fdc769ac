// Drives a fuzz target where there is no libFuzzer: files are damaged at random, without regard to
// what code they reach. Takes what scripts/fuzz gives to libFuzzer:
//
//   fuzz_TARGET -max_total_time=SECONDS -artifact_prefix=PREFIX [-...] FOLDER...
//   fuzz_TARGET FILE
//
// The input at hand lies in PREFIXinput while it is tried; when the target crashes, it stays there.
// The same seeds are damaged in the same way each time, as far as the time reaches.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "fuzz.h"

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void try_out(const std::string& input) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

/// Cuts, doubles, replaces or flips something of it, or takes a piece of another one.
std::string damaged(std::string input, const std::string& other, std::mt19937& random) {
  const auto below = [&](std::size_t end) { return end == 0 ? 0 : random() % end; };
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(input.size() + 1);
    const std::size_t count = below(std::min<std::size_t>(64, input.size() - at) + 1);
    switch (below(6)) {
      case 0:
        input.erase(at, count);
        break;
      case 1:
        input.insert(at, input.substr(at, count));
        break;
      case 2:
        input.insert(at, 1, static_cast<char>(below(256)));
        break;
      case 3:
        input.resize(at);
        break;
      case 4:
        input.replace(at, count, other.substr(below(other.size() + 1), 64));
        break;
      default:
        if (at < input.size()) {
          input[at] = static_cast<char>(input[at] ^ (1 << below(8)));
        }
    }
  }
  return input;
}

}  // namespace

int main(int argc, char** argv) {
  double seconds = 10.0;
  std::string prefix = "fuzz-";
  std::vector<std::string> seeds;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    constexpr std::string_view kTime = "-max_total_time=";
    constexpr std::string_view kPrefix = "-artifact_prefix=";
    if (argument.starts_with(kTime)) {
      seconds = std::stod(std::string(argument.substr(kTime.size())));
    } else if (argument.starts_with(kPrefix)) {
      prefix = argument.substr(kPrefix.size());
    } else if (fs::is_directory(argument)) {
      std::vector<fs::path> files;
      for (const auto& entry : fs::directory_iterator(argument)) {
        files.push_back(entry.path());
      }
      std::sort(files.begin(), files.end());
      for (const fs::path& file : files) {
        seeds.push_back(content_of(file));
      }
    } else if (!argument.starts_with('-')) {
      try_out(content_of(argument));
      return 0;
    }
  }
  if (seeds.empty()) {
    std::fprintf(stderr, "driver: there is no file to begin with\n");
    return 2;
  }
  const fs::path at_hand = prefix + "input";
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  std::mt19937 random(1);
  std::size_t tried = 0;
  for (; tried < seeds.size() || Clock::now() < end; ++tried) {
    const std::string& seed = seeds[tried < seeds.size() ? tried : random() % seeds.size()];
    const std::string input =
        tried < seeds.size() ? seed : damaged(seed, seeds[random() % seeds.size()], random);
    std::ofstream(at_hand, std::ios::binary) << input;
    alarm(60);  // what hangs is a finding, too
    try_out(input);
  }
  fs::remove(at_hand);
  std::printf("stat::number_of_executed_units: %zu\n", tried);
  return 0;
}
