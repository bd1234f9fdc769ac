// Reading an MCAP file from its beginning to its end, a chunk at a time.
//
//   mcap::Reader reader("run.mcap");
//   while (const auto message = reader.next()) {
//     const mcap::Channel& channel = reader.channels().at(message->channel);
//     ...
//   }
//   if (!reader.missing_end().empty()) { ... }  // the writer was killed
//
// Checksums are verified where the file has them. A file that breaks off, because its writer was
// killed or is still running, is read to its last complete chunk. Any other departure from the
// format is an error. Chunks may be compressed with zstd or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/mcap/records.h"

namespace elsie::mcap {

/// True if the file begins like an MCAP file. False if it cannot be read.
bool may_be_mcap(const std::filesystem::path& file);

class Reader {
 public:
  /// Reads the header. Throws McapError when the file cannot be opened, is not an MCAP file, has
  /// another version, or breaks off before its header ends.
  explicit Reader(const std::filesystem::path& file);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const Header& header() const;

  /// The next message in the order of the file; none after the last one. Its data are valid until
  /// the next call. Throws McapError when the file is damaged, from then on at every call.
  std::optional<Message> next();

  // The contents of the file before the message that was last read; all after the last message.
  const std::map<std::uint16_t, Schema>& schemas() const;
  const std::map<std::uint16_t, Channel>& channels() const;
  const std::vector<Metadata>& metadata() const;
  /// The number of complete chunks.
  std::uint64_t chunks() const;

  /// After the last message: a sentence about an end that is missing; empty when the file is whole.
  const std::string& missing_end() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::mcap
