#include <catch2/catch.hpp>

#include "support.h"

using namespace elsie;
using namespace elsie::test;

TEST_CASE("What was written is read back: header, schemas, channels, messages, metadata") {
  for (const auto compression : {mcap::Compression::zstd, mcap::Compression::none}) {
    McapFile file;
    write_small(file.path, 3, {.profile = "p", .library = "tests", .compression = compression});
    mcap::Reader reader(file.path);
    CHECK(reader.header().profile == "p");
    CHECK(reader.header().library == "tests");
    const auto first = reader.next();
    REQUIRE(first);
    CHECK(first->data == "{\"i\":0}");
    CHECK(first->log_time_ns == 0);
    const auto second = reader.next();
    REQUIRE(second);
    CHECK(second->publish_time_ns == 1);
    int rest = 0;
    while (reader.next()) {
      ++rest;
    }
    CHECK(rest == 7);
    CHECK(!reader.next());
    CHECK(reader.missing_end().empty());
    REQUIRE(reader.schemas().size() == 1);
    CHECK(reader.schemas().at(1).name == "example.Point");
    CHECK(reader.schemas().at(1).encoding == "jsonschema");
    CHECK(reader.schemas().at(1).data == R"({"type": "object"})");
    REQUIRE(reader.channels().size() == 2);
    CHECK(reader.channels().at(1).topic == "/fast");
    CHECK(reader.channels().at(1).schema == 1);
    CHECK(reader.channels().at(1).encoding == "json");
    CHECK(reader.channels().at(1).metadata.at("robot") == "r1");
    CHECK(reader.channels().at(2).schema == 0);
    REQUIRE(reader.metadata().size() == 2);
    CHECK(reader.metadata()[0].name == "run");
    CHECK(reader.metadata()[0].values.at("seed") == "7");
    CHECK(reader.metadata()[1].values.at("outcome") == "success");
  }
}

TEST_CASE("A chunk ends after its span of time, or when it has so many bytes") {
  McapFile file;
  write_small(file.path, 5);
  CHECK(read_all(file.path).chunks == 5);
  write_small(file.path, 5, {.chunk_ns = 100 * kSecond});
  CHECK(read_all(file.path).chunks == 1);
  write_small(file.path, 5, {.chunk_bytes = 1});
  CHECK(read_all(file.path).chunks == 15);
}

TEST_CASE("The same calls give the same bytes") {
  McapFile one, other;
  write_small(one.path, 4);
  write_small(other.path, 4);
  CHECK(one.bytes() == other.bytes());
}

TEST_CASE("Messages whose times go backwards are kept in their order") {
  McapFile file;
  {
    mcap::Writer writer(file.path);
    const auto channel = writer.add_channel("/a", 0, "json");
    for (const std::uint64_t time : {5 * kSecond, kSecond, 3 * kSecond}) {
      writer.write(channel, time, "{}");
    }
    writer.close();
  }
  CHECK(read_all(file.path).messages ==
        std::vector<std::string>{"/a 0 5000000000 {}", "/a 1 1000000000 {}", "/a 2 3000000000 {}"});
}

TEST_CASE("A file of nothing, and one of channels without messages, are whole") {
  McapFile file;
  mcap::Writer(file.path).close();
  CHECK(read_all(file.path).missing_end.empty());
  {
    mcap::Writer writer(file.path);
    writer.add_channel("/a", writer.add_schema("s", "jsonschema", "{}"), "json");
    writer.close();
  }
  const Read read = read_all(file.path);
  CHECK(read.messages.empty());
  CHECK(read.chunks == 1);
  CHECK(read.missing_end.empty());
}

TEST_CASE("A chunk is in the file as soon as the next one begins") {
  McapFile file;
  mcap::Writer writer(file.path);
  const auto channel = writer.add_channel("/a", 0, "json");
  writer.write(channel, 0, "{}");
  CHECK(read_all(file.path).messages.empty());
  writer.write(channel, kSecond, "{}");
  Read read = read_all(file.path);
  CHECK(read.messages == std::vector<std::string>{"/a 0 0 {}"});
  CHECK_THAT(read.missing_end, Catch::Contains("after 1 complete chunk;"));
  writer.flush();
  CHECK(read_all(file.path).messages.size() == 2);
}

TEST_CASE("When its time is over a chunk is written, whether another message comes or not") {
  McapFile file, other;
  mcap::Writer writer(file.path), unhurried(other.path);
  for (mcap::Writer* each : {&writer, &unhurried}) {
    each->write(each->add_channel("/a", 0, "json"), 0, "{}");
  }
  writer.pass(kSecond - 1);
  CHECK(read_all(file.path).messages.empty());
  writer.pass(kSecond);
  CHECK(read_all(file.path).messages.size() == 1);
  writer.pass(9 * kSecond);  // nothing is left to write
  CHECK(read_all(file.path).chunks == 1);
  for (mcap::Writer* each : {&writer, &unhurried}) {
    each->write(1, 10 * kSecond, "{}");
    each->close();
  }
  CHECK(file.bytes() == other.bytes());
}

TEST_CASE("A writer that is not closed leaves its messages, without an end") {
  McapFile file;
  write_small(file.path, 3, {}, false);
  const Read read = read_all(file.path);
  CHECK(read.messages.size() == 9);
  CHECK_THAT(read.missing_end,
             Catch::StartsWith("the end is missing: the file breaks off at byte "));
}

TEST_CASE("In an emergency the chunk that was begun is written as it is") {
  McapFile file;
  {
    mcap::Writer writer(file.path);
    const auto channel = writer.add_channel("/a", 0, "json");
    writer.write(channel, 0, "{}");
    writer.write(channel, kSecond, R"({"last": true})");
    CHECK(writer.write_in_emergency());
    CHECK_THROWS_AS(writer.flush(), mcap::McapError);
  }
  const Read read = read_all(file.path);
  CHECK(read.messages ==
        std::vector<std::string>{"/a 0 0 {}", R"(/a 1 1000000000 {"last": true})"});
  CHECK(!read.missing_end.empty());
  mcap::Writer closed(file.path);
  closed.close();
  CHECK(!closed.write_in_emergency());
}

TEST_CASE("In an emergency the last words follow, with the time until then") {
  for (const bool begun : {false, true}) {
    McapFile file;
    {
      mcap::Writer writer(file.path);
      writer.set_last_words({"result", {{"outcome", "stopped"}}}, "simulated_s");
      const auto channel = writer.add_channel("/a", 0, "json");
      writer.write(channel, 0, "{}");
      if (!begun) {
        writer.flush();
      }
      writer.pass(12'340'000'000);
      CHECK(writer.write_in_emergency());
    }
    mcap::Reader reader(file.path);
    while (reader.next()) {
    }
    REQUIRE(reader.metadata().size() == 1);
    CHECK(reader.metadata()[0].name == "result");
    CHECK(reader.metadata()[0].values.at("outcome") == "stopped");
    CHECK(reader.metadata()[0].values.at("simulated_s") == "0000000012.340000000");
  }
  McapFile file;
  {
    mcap::Writer writer(file.path);
    writer.set_last_words({"result", {{"outcome", "stopped"}}}, "simulated_s");
    writer.close();
  }
  mcap::Reader reader(file.path);
  CHECK(!reader.next());
  CHECK(reader.metadata().empty());
}

TEST_CASE("A file that cannot be written says so") {
  CHECK_THROWS_WITH(
      mcap::Writer("/nowhere/at/all.mcap"),
      "recording '/nowhere/at/all.mcap' cannot be created: No such file or directory");
  CHECK_THROWS_WITH(mcap::Writer("/dev/full"),
                    "recording '/dev/full' could not be written: No space left on device");
}

TEST_CASE("Channels and schemas that are not there are refused") {
  McapFile file;
  mcap::Writer writer(file.path);
  CHECK_THROWS_AS(writer.write(1, 0, "{}"), std::invalid_argument);
  CHECK_THROWS_AS(writer.write(0, 0, "{}"), std::invalid_argument);
  CHECK_THROWS_WITH(writer.add_channel("/a", 1, "json"), Catch::Contains("names schema 1"));
}
