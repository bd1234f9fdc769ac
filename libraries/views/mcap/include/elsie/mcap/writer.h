// Writing an MCAP file.
//
//   mcap::Writer writer("run.mcap", {.library = "elsie 0.1.0"});
//   const auto schema = writer.add_schema("example.Point", "jsonschema", R"({"type": "object"})");
//   const auto channel = writer.add_channel("/point", schema, "json");
//   writer.write(channel, 500'000'000, R"({"x": 1.0})");
//   writer.close();
//
// Each chunk is written in one piece, when it is full or when pass() says that its time is over. A
// process that is killed leaves all complete chunks, and Reader reads them. The same calls give the
// same bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "elsie/mcap/records.h"

namespace elsie::mcap {

enum class Compression { none, zstd };

struct WriterOptions {
  std::string profile{};
  std::string library{};
  Compression compression = Compression::zstd;
  int level = 3;                              // of zstd: 1 (fast) to 19 (small)
  std::size_t chunk_bytes = 1U << 20U;        // a chunk with as many is full, before compression
  std::uint64_t chunk_ns = 1'000'000'000ULL;  // so is one whose messages span this time
};

class Writer {
 public:
  /// Creates the file, or empties it. Like all calls below, throws McapError when the file cannot
  /// be written (a full disk); the file then ends after the last complete chunk.
  explicit Writer(const std::filesystem::path& file, WriterOptions options = {});
  /// Without close(): writes the chunk that was begun and leaves the file without its end.
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Both return the id, from 1. They throw std::length_error for more than 65535, and for a
  /// channel std::invalid_argument when there is no such schema (0: none).
  std::uint16_t add_schema(std::string name, std::string encoding, std::string data);
  std::uint16_t add_channel(std::string topic, std::uint16_t schema, std::string encoding,
                            std::map<std::string, std::string> metadata = {});

  /// Writes a message. Throws std::invalid_argument when there is no such channel. Times are ns
  /// since any instant that is the same for the whole file; `publish_time_ns`: by default the log
  /// time.
  void write(std::uint16_t channel, std::uint64_t log_time_ns, std::string_view data,
             std::optional<std::uint64_t> publish_time_ns = std::nullopt);
  /// Writes metadata, after the chunk that was begun.
  void write(const Metadata& metadata);

  /// Says that this time (ns) has come, and that all later messages have this time or a later one.
  /// Writes the current chunk if a message of this time would begin the next one. This changes how
  /// soon messages are in the file, but not the final content.
  void pass(std::uint64_t now_ns);
  /// Writes the chunk that was begun.
  void flush();
  /// Writes the rest, the summary and the footer. Nothing may be written after it.
  void close();

  /// Metadata that write_in_emergency() adds after the last chunk. Its value `time` is set to the
  /// time of the last pass(), s.
  void set_last_words(Metadata metadata, const std::string& time);
  /// For the last moments of a process, also in a signal's handler: writes the chunk that was begun
  /// without compression, and the last words, without allocating memory. Nothing may be written
  /// after it. Returns whether there was a file to write to.
  bool write_in_emergency() noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::mcap
