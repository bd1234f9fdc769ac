// Records as bytes, each appended to a text.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/mcap/records.h"

#include "format.h"

namespace elsie::mcap {

/// The time of a message and its place in the records of its chunk.
struct MessagePlace {
  std::uint64_t log_time_ns;
  std::uint64_t offset;
};

/// A chunk in the file.
struct ChunkPlace {
  std::uint64_t first_ns = 0, last_ns = 0;                 // log times
  std::uint64_t start = 0, length = 0;                     // of the chunk's record
  std::map<std::uint16_t, std::uint64_t> message_indexes;  // by channel, from the file's start
  std::uint64_t message_indexes_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0, size = 0;
};

/// Metadata in the file.
struct MetadataPlace {
  std::uint64_t start, length;
  std::string name;
};

struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0;
  std::uint32_t metadata = 0;
  std::uint32_t chunks = 0;
  std::uint64_t first_ns = 0, last_ns = 0;
  std::map<std::uint16_t, std::uint64_t> by_channel;
};

/// Records of one kind in the summary.
struct Group {
  Opcode opcode;
  std::uint64_t start, length;
};

void append(std::string& out, const Header& header);
void append(std::string& out, const Schema& schema);
void append(std::string& out, const Channel& channel);
void append(std::string& out, const Message& message);
void append(std::string& out, const Metadata& metadata);
void append(std::string& out, std::uint16_t channel, const std::vector<MessagePlace>& messages);
void append(std::string& out, const ChunkPlace& chunk);
void append(std::string& out, const MetadataPlace& metadata);
void append(std::string& out, const Statistics& statistics);
void append(std::string& out, const Group& group);
void append_data_end(std::string& out, std::uint32_t checksum);
/// The head of a chunk's record, up to the messages, whose length is in ChunkPlace.
void append_chunk_head(std::string& out, const ChunkPlace& chunk, std::uint32_t checksum);
/// `out` begins with the summary, and its first byte is at `summary_start` in the file (0: there is
/// none).
void append_footer(std::string& out, std::uint64_t summary_start, std::uint64_t offsets_start);

}  // namespace elsie::mcap
