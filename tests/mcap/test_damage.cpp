#include <algorithm>
#include <cstring>
#include <random>

#include <catch2/catch.hpp>

#include "support.h"

using namespace elsie;
using namespace elsie::test;

namespace {

/// What can be read of the file, whether it ends well or not.
Read readable_part(const std::filesystem::path& file, bool& damaged) {
  Read all;
  damaged = false;
  try {
    mcap::Reader reader(file);
    try {
      while (const auto message = reader.next()) {
        all.messages.push_back(
            reader.channels().at(message->channel).topic + " " + std::to_string(message->sequence) +
            " " + std::to_string(message->log_time_ns) + " " + std::string(message->data));
      }
      all.missing_end = reader.missing_end();
    } catch (const mcap::McapError&) {
      damaged = true;
      CHECK_THROWS_AS(reader.next(), mcap::McapError);  // and it stays so
    }
  } catch (const mcap::McapError&) {
    damaged = true;
  }
  return all;
}

/// Whether a part has nothing that the whole has not, and in the same order.
bool within(const std::vector<std::string>& part, const std::vector<std::string>& all) {
  auto at = all.begin();
  for (const std::string& message : part) {
    at = std::find(at, all.end(), message);
    if (at++ == all.end()) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("Cut off at any byte, a file gives all its complete chunks and says what is missing") {
  for (const auto compression : {mcap::Compression::zstd, mcap::Compression::none}) {
    McapFile whole;
    write_small(whole.path, 4, {.compression = compression});
    const std::string bytes = whole.bytes();
    const auto all = read_all(whole.path).messages;
    REQUIRE(all.size() == 12);
    McapFile cut;
    std::size_t most = 0;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      cut.set(bytes.substr(0, length));
      INFO(length << " of " << bytes.size() << " bytes");
      bool damaged = false;
      const Read part = readable_part(cut.path, damaged);
      const std::size_t header = bytes.find("run") - 4 - 9;  // the first record after it
      CHECK(damaged == (length < header));
      CHECK(within(part.messages, all));
      CHECK(part.messages.size() % 3 == 0);  // whole chunks
      CHECK(part.messages.size() >= most);   // and never fewer than of a shorter file
      CHECK(part.missing_end.empty() == damaged);
      most = part.messages.size();
    }
    CHECK(most == all.size());
  }
}

TEST_CASE("A chunk whose end is in the file is read, however little follows") {
  McapFile whole;
  write_small(whole.path, 2);
  const std::string bytes = whole.bytes();
  // The first chunk's record: after magic, header and metadata.
  const std::size_t chunk = bytes.find("zstd") - 4 - 28 - 9;
  REQUIRE(bytes[chunk] == 6);
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data() + chunk + 1, 8);
  McapFile cut(bytes.substr(0, chunk + 9 + length));
  CHECK(read_all(cut.path).messages.size() == 3);
  cut.set(bytes.substr(0, chunk + 9 + length - 1));
  CHECK(read_all(cut.path).messages.empty());
}

TEST_CASE("Any byte that is changed is found, or changes nothing that is read") {
  for (const auto compression : {mcap::Compression::zstd, mcap::Compression::none}) {
    McapFile whole;
    write_small(whole.path, 3, {.compression = compression});
    const std::string bytes = whole.bytes();
    const auto all = read_all(whole.path).messages;
    McapFile changed;
    std::size_t found = 0;
    for (std::size_t at = 0; at < bytes.size(); ++at) {
      std::string wrong = bytes;
      wrong[at] = static_cast<char>(wrong[at] ^ 0x10);
      changed.set(wrong);
      INFO("byte " << at);
      bool damaged = false;
      const Read part = readable_part(changed.path, damaged);
      CHECK(within(part.messages, all));
      found += damaged || !part.missing_end.empty() ? 1 : 0;
    }
    CHECK(found == bytes.size());  // data and summary each have a checksum over everything
  }
}

TEST_CASE("Damage is reported with the kind of record and its place") {
  McapFile file;
  write_small(file.path, 2, {.compression = mcap::Compression::none});
  std::string bytes = file.bytes();
  const std::size_t at = bytes.find("{\"i\":1}");
  bytes[at + 5] = '9';
  file.set(bytes);
  CHECK_THROWS_WITH(
      read_all(file.path),
      Catch::StartsWith("'" + file.path.string() + "' is damaged: the chunk at byte ") &&
          Catch::Contains(": its checksum is ") && Catch::Contains(" and should be "));
}

TEST_CASE("Whatever bytes there are, reading ends, with an error or without") {
  McapFile small, packed;
  write_small(small.path, 3, {.compression = mcap::Compression::none});
  write_small(packed.path, 3);
  std::mt19937 random(1);
  McapFile file;
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = (round % 2 == 0 ? small : packed).bytes();
    const auto somewhere = [&] { return random() % bytes.size(); };
    for (unsigned i = 0, n = 1 + random() % 8; i < n; ++i) {
      switch (random() % 5) {
        case 0:
          bytes[somewhere()] = static_cast<char>(random());
          break;
        case 1:
          bytes.erase(somewhere(), random() % 20);
          break;
        case 2:
          bytes.insert(somewhere(), std::string(random() % 20, static_cast<char>(random())));
          break;
        case 3:  // a length or a time of all ones
          bytes.replace(somewhere(), 8, std::string(8, '\xff'));
          break;
        default: {
          const std::string piece = bytes.substr(somewhere(), random() % 200);
          bytes.insert(somewhere(), piece);
        }
      }
    }
    file.set(bytes);
    bool damaged = false;
    readable_part(file.path, damaged);
  }
  SUCCEED();
}

TEST_CASE("A chunk that says it is huge takes no memory for it") {
  McapFile file;
  write_small(file.path, 1);
  std::string bytes = file.bytes();
  const std::size_t size = bytes.find("zstd") - 4 - 4 - 8;
  bytes.replace(size, 8, std::string(7, '\xff') + '\x7f');
  file.set(bytes);
  CHECK_THROWS_WITH(
      read_all(file.path),
      Catch::Contains("it cannot be decompressed: fewer bytes come out than it says"));
  bytes.replace(size, 8, std::string("\x01\0\0\0\0\0\0\0", 8));
  file.set(bytes);
  CHECK_THROWS_WITH(read_all(file.path), Catch::Contains("more bytes come out than it says"));
}
