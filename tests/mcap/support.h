// Small MCAP files, and what is in them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

#include "elsie/mcap/reader.h"
#include "elsie/mcap/writer.h"

#include "folder.h"

namespace elsie::test {

/// A file of its own for each test, gone at the end.
struct McapFile {
  McapFile() { set(""); }
  explicit McapFile(const std::string& bytes) { set(bytes); }

  std::string bytes() const {
    std::ifstream in(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  }
  void set(const std::string& bytes) const {
    std::filesystem::remove(path);  // file systems are slow to empty a file
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  }

  const Folder folder{};
  const std::filesystem::path path = folder / "file.mcap";
};

struct Read {
  std::vector<std::string> messages;  // "TOPIC SEQUENCE TIME DATA"
  std::string missing_end;
  std::uint64_t chunks = 0;
};

/// Everything in a file. Throws McapError.
inline Read read_all(const std::filesystem::path& file) {
  Read all;
  mcap::Reader reader(file);
  while (const auto message = reader.next()) {
    all.messages.push_back(reader.channels().at(message->channel).topic + " " +
                           std::to_string(message->sequence) + " " +
                           std::to_string(message->log_time_ns) + " " + std::string(message->data));
  }
  all.missing_end = reader.missing_end();
  all.chunks = reader.chunks();
  return all;
}

constexpr std::uint64_t kSecond = 1'000'000'000;

/// Two channels, metadata before and after, a message each half second on the one and each second
/// on the other, from 0 to `seconds`: a chunk for each second.
inline void write_small(const std::filesystem::path& file, int seconds,
                        mcap::WriterOptions options = {}, bool with_end = true) {
  mcap::Writer writer(file, std::move(options));
  writer.write(mcap::Metadata{"run", {{"seed", "7"}}});
  const auto schema = writer.add_schema("example.Point", "jsonschema", R"({"type": "object"})");
  const auto fast = writer.add_channel("/fast", schema, "json", {{"robot", "r1"}});
  const auto slow = writer.add_channel("/slow", 0, "json");
  for (int i = 0; i < 2 * seconds; ++i) {
    const std::uint64_t now = static_cast<std::uint64_t>(i) * kSecond / 2;
    writer.write(fast, now, "{\"i\":" + std::to_string(i) + "}");
    if (i % 2 == 0) {
      writer.write(slow, now, "{}", now + 1);
    }
  }
  if (with_end) {
    writer.write(mcap::Metadata{"result", {{"outcome", "success"}, {"hash", "0123"}}});
    writer.close();
  }
}

}  // namespace elsie::test
