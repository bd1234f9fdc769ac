// The formats in which a run can be recorded, by the suffix of the file's name. A new format is a
// recorder of its own, see CONTRIBUTING.md, and a line in formats.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/simulation/observer.h"

namespace elsie::recording {

/// The rate at which a run with steps of this length is recorded, when this rate is asked for:
/// samples are a whole number of steps apart.
double rate_in(double rate_hz, double step_s);

/// How to record; a format without a place for pictures ignores `images`.
struct RecorderOptions {
  /// Samples per simulated second, rounded to whole steps, at most one a step; must be positive.
  double rate_hz = 10.0;
  /// True: records the pictures of the cameras; each sample has those that are new.
  bool images = false;
  /// True: records the time that each behaviour took to answer; the simulation must measure it.
  bool with_times = false;
  /// Ids of the robots to record. Empty: the first Format::most_robots. In a table the others have
  /// no rows; in formats for viewers, their poses alone are recorded.
  std::vector<std::string> robots{};
  /// The program that records: "elsie 0.1.0".
  std::string program = "elsie";
  /// Called with a sentence when a plugin fails to draw: the recording lacks its sketches, and the
  /// run goes on. Empty: the fault ends the run.
  std::function<void(const std::string&)> warn{};
};

struct Format {
  std::string_view suffix{};       // ".csv"
  std::string_view description{};  // "a table"
  std::string_view mark{};         // the first bytes of every such file
  std::string_view maker{};        // text in its first kilobyte if Elsie wrote it
  bool images = false;             // true: it has a place for pictures
  /// Robots that are recorded in full when RecorderOptions::robots is empty.
  std::size_t most_robots = std::numeric_limits<std::size_t>::max();
  /// Creates the file at once, and throws an exception with a sentence when it cannot.
  std::unique_ptr<simulation::Observer> (*recorder)(const std::filesystem::path& file,
                                                    const RecorderOptions& options) = nullptr;
};

/// All formats; a file without a suffix, such as a device, gets the first.
std::span<const Format> formats();
/// The format with the suffix of the file's name; null: no format has this suffix.
const Format* format_of(const std::filesystem::path& file);
/// Checks, before any work is done, that a recording can be written there: the name has a suffix of
/// formats() or is that of a device, and an existing file is a recording. Throws base::BadInput,
/// which begins with `named_by`.
void require_recording(const std::filesystem::path& file, const std::string& named_by);
/// The suffixes for messages and help: ".csv or .mcap" with " or " between them. `with_images`:
/// only of formats with a place for pictures.
std::string suffixes(std::string_view between, bool with_images = false);

}  // namespace elsie::recording
