// Records of the format, and the bytes around them.
#pragma once

#include <cstdint>
#include <string_view>

#include <zlib.h>

namespace elsie::mcap {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
constexpr std::size_t kVersionAt = 5;  // the byte of the magic that is the version

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F,
};

/// The prefix of each record: its opcode and its length.
constexpr std::size_t kPrefix = 1 + sizeof(std::uint64_t);
/// The length of the two places in a footer. Its checksum covers them and follows them.
constexpr std::size_t kFooterPlaces = 2 * sizeof(std::uint64_t);
constexpr std::size_t kFooter = kFooterPlaces + sizeof(std::uint32_t);

/// The CRC-32 of these bytes after others, whose CRC-32 is `before` (0 at first).
inline std::uint32_t crc(std::string_view bytes, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()));
}

}  // namespace elsie::mcap
