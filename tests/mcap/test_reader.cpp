#include <catch2/catch.hpp>

#include "support.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("A file that is not an MCAP file is refused in a sentence") {
  CHECK_THROWS_WITH(mcap::Reader("/nowhere.mcap"),
                    "recording '/nowhere.mcap' cannot be read: No such file or directory");
  CHECK_THROWS_WITH(mcap::Reader("/"), "recording '/' is a directory");
  McapFile file("time_s,robot,x_m,y_m\n");
  CHECK_THROWS_WITH(
      mcap::Reader(file.path),
      "'" + file.path.string() + "' is not an MCAP file: it does not begin with the format's mark");
  CHECK(!mcap::may_be_mcap(file.path));
  file.set("");
  CHECK_THROWS_WITH(mcap::Reader(file.path), Catch::Contains("is not an MCAP file"));
}

TEST_CASE("A file of another version of the format is refused by name") {
  McapFile file;
  write_small(file.path, 1);
  CHECK(mcap::may_be_mcap(file.path));
  std::string bytes = file.bytes();
  bytes[5] = '1';
  file.set(bytes);
  CHECK_THROWS_WITH(
      mcap::Reader(file.path),
      Catch::Contains("is an MCAP file of another version, '1'; expected version '0'"));
}

TEST_CASE("Messages outside of chunks, and records that Elsie does not write, are read past") {
  // By hand, from the specification: header, schema 0 (to be ignored), channel 7, a message, an
  // attachment, a record of an application's own, end of data, footer.
  const auto u16 = [](unsigned v) { return std::string{char(v & 255U), char(v >> 8U)}; };
  const auto u32 = [&](unsigned v) { return u16(v & 0xffffU) + u16(v >> 16U); };
  const auto u64 = [&](unsigned v) { return u32(v) + u32(0); };
  const auto text = [&](const std::string& t) { return u32(unsigned(t.size())) + t; };
  const auto record = [&](int opcode, const std::string& content) {
    return std::string(1, char(opcode)) + u64(unsigned(content.size())) + content;
  };
  const std::string magic{"\x89MCAP0\r\n", 8};
  McapFile file(
      magic + record(1, text("") + text("by hand") + "a field of a later version") +
      record(3, u16(0) + text("s") + text("") + u32(0)) +
      record(4, u16(7) + u16(0) + text("/a") + text("json") + u32(0)) +
      record(5, u16(7) + u32(3) + u64(12) + u64(11) + "{}") +
      record(9, u64(0) + u64(0) + text("note.txt") + text("text/plain") + u64(2) + "hi" + u32(0)) +
      record(0x80, "whatever") + record(0x0f, u32(0)) + record(2, u64(0) + u64(0) + u32(0)) +
      magic);
  const Read read = read_all(file.path);
  CHECK(read.messages == std::vector<std::string>{"/a 3 12 {}"});
  CHECK(read.missing_end.empty());
}

TEST_CASE("A compression that this program does not read is named") {
  McapFile file;
  write_small(file.path, 1);
  std::string bytes = file.bytes();
  bytes.replace(bytes.find("zstd"), 4, "what");
  file.set(bytes);
  CHECK_THROWS_WITH(read_all(file.path), Catch::Contains("it is compressed with 'what'"));
}
