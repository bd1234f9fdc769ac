// What is in an MCAP file: a container of messages with times, in channels that say of what kind
// their messages are.
//
// The format is described at https://mcap.dev/spec; this module follows it, knows nothing of robots
// and is usable on its own. A file that Writer writes:
//
//   magic, header, metadata and chunks as they come, end of data, summary, footer, magic
//
// A chunk holds messages, and the schemas and channels that come up first in it, compressed as a
// whole. Behind it stand the places of its messages. The summary repeats schemas and channels, and
// says where chunks and metadata are, so that readers need not go through the file.
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
  std::string profile;  // what the file promises beyond the format; may be empty
  std::string library;  // which program wrote it
};

/// What messages are made of.
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

/// Names and values that belong to the file as a whole, or to a place in it.
struct Metadata {
  std::string name;
  std::map<std::string, std::string> values;
};

}  // namespace elsie::mcap
