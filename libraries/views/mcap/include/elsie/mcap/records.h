// The contents of an MCAP file: messages with times, in channels that name the kind of messages.
//
// https://mcap.dev/spec describes the format. This module knows nothing of robots and can be used
// on its own. A file that Writer writes:
//
//   magic, header, metadata and chunks in any order, end of data, summary, footer, magic
//
// A chunk holds messages, and the schemas and channels that were added while it was open; it is
// compressed as a whole. The places of its messages follow it. The summary repeats schemas and
// channels, and says where chunks and metadata are, so that a reader can go to them directly.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "elsie/base/error.h"

namespace elsie::mcap {

/// A file that cannot be read or written; what() is a sentence with the file's name.
class McapError : public base::Error {
 public:
  using base::Error::Error;
};

struct Header {
  std::string profile;  // conventions of the file beyond the format; may be empty
  std::string library;  // the program that wrote it
};

/// The type of messages.
struct Schema {
  std::uint16_t id = 0;  // from 1
  std::string name;
  std::string encoding;  // of `data`: "jsonschema"
  std::string data;
};

/// A stream of messages of one kind.
struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;  // 0: none
  std::string topic;
  std::string encoding;  // of the messages: "json"
  std::map<std::string, std::string> metadata;
};

struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;  // counts the messages of a channel, from 0
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  std::string_view data;
};

/// Names and values about the whole file, or about a place in it.
struct Metadata {
  std::string name;
  std::map<std::string, std::string> values;
};

}  // namespace elsie::mcap
