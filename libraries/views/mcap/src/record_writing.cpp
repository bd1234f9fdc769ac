#include "record_writing.h"

#include <cstring>

#include "bytes.h"

namespace elsie::mcap {
namespace {

/// Appends a record whose content is appended by `content`.
template <class Content>
void record(std::string& out, Opcode opcode, Content content) {
  put(out, static_cast<std::uint8_t>(opcode));
  const std::size_t length_at = out.size();
  put(out, std::uint64_t{0});
  const std::size_t start = out.size();
  content();
  const std::uint64_t length = out.size() - start;
  std::memcpy(out.data() + length_at, &length, sizeof(length));
}

void put_counts(std::string& out, const std::map<std::uint16_t, std::uint64_t>& counts) {
  constexpr std::size_t kEntry = sizeof(std::uint16_t) + sizeof(std::uint64_t);
  put(out, length32(counts.size() * kEntry));
  for (const auto& [key, value] : counts) {
    put(out, key);
    put(out, value);
  }
}

}  // namespace

void append(std::string& out, const Header& header) {
  record(out, Opcode::header, [&] {
    put_text(out, header.profile);
    put_text(out, header.library);
  });
}

void append(std::string& out, const Schema& schema) {
  record(out, Opcode::schema, [&] {
    put(out, schema.id);
    put_text(out, schema.name);
    put_text(out, schema.encoding);
    put_text(out, schema.data);
  });
}

void append(std::string& out, const Channel& channel) {
  record(out, Opcode::channel, [&] {
    put(out, channel.id);
    put(out, channel.schema);
    put_text(out, channel.topic);
    put_text(out, channel.encoding);
    put_texts(out, channel.metadata);
  });
}

void append(std::string& out, const Message& message) {
  record(out, Opcode::message, [&] {
    put(out, message.channel);
    put(out, message.sequence);
    put(out, message.log_time_ns);
    put(out, message.publish_time_ns);
    out.append(message.data);
  });
}

void append(std::string& out, const Metadata& metadata) {
  record(out, Opcode::metadata, [&] {
    put_text(out, metadata.name);
    put_texts(out, metadata.values);
  });
}

void append(std::string& out, std::uint16_t channel, const std::vector<MessagePlace>& messages) {
  record(out, Opcode::message_index, [&] {
    put(out, channel);
    put(out, length32(messages.size() * sizeof(MessagePlace)));
    for (const MessagePlace& message : messages) {
      put(out, message.log_time_ns);
      put(out, message.offset);
    }
  });
}

void append(std::string& out, const ChunkPlace& chunk) {
  record(out, Opcode::chunk_index, [&] {
    put(out, chunk.first_ns);
    put(out, chunk.last_ns);
    put(out, chunk.start);
    put(out, chunk.length);
    put_counts(out, chunk.message_indexes);
    put(out, chunk.message_indexes_length);
    put_text(out, chunk.compression);
    put(out, chunk.compressed_size);
    put(out, chunk.size);
  });
}

void append(std::string& out, const MetadataPlace& metadata) {
  record(out, Opcode::metadata_index, [&] {
    put(out, metadata.start);
    put(out, metadata.length);
    put_text(out, metadata.name);
  });
}

void append(std::string& out, const Statistics& statistics) {
  record(out, Opcode::statistics, [&] {
    put(out, statistics.messages);
    put(out, statistics.schemas);
    put(out, statistics.channels);
    put(out, std::uint32_t{0});  // attachments
    put(out, statistics.metadata);
    put(out, statistics.chunks);
    put(out, statistics.first_ns);
    put(out, statistics.last_ns);
    put_counts(out, statistics.by_channel);
  });
}

void append(std::string& out, const Group& group) {
  record(out, Opcode::summary_offset, [&] {
    put(out, static_cast<std::uint8_t>(group.opcode));
    put(out, group.start);
    put(out, group.length);
  });
}

void append_data_end(std::string& out, std::uint32_t checksum) {
  record(out, Opcode::data_end, [&] { put(out, checksum); });
}

void append_chunk_head(std::string& out, const ChunkPlace& chunk, std::uint32_t checksum) {
  put(out, static_cast<std::uint8_t>(Opcode::chunk));
  put(out, chunk.length - kPrefix);
  put(out, chunk.first_ns);
  put(out, chunk.last_ns);
  put(out, chunk.size);
  put(out, checksum);
  put_text(out, chunk.compression);
  put(out, chunk.compressed_size);
}

void append_footer(std::string& out, std::uint64_t summary_start, std::uint64_t offsets_start) {
  put(out, static_cast<std::uint8_t>(Opcode::footer));
  put(out, std::uint64_t{kFooter});
  put(out, summary_start);
  put(out, offsets_start);
  put(out, crc(out));
}

}  // namespace elsie::mcap
