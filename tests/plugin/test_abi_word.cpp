#include <catch2/catch.hpp>

#include "elsie/plugin/abi_word.h"

using Catch::Contains;
using elsie::plugin::abi_mismatch;
using elsie::plugin::host_abi_word;

TEST_CASE("A library with the host's own word fits") {
  CHECK_FALSE(abi_mismatch(host_abi_word(), host_abi_word()));
}

TEST_CASE("Before 1.0 any other minor version is refused, and the sentence names both") {
  CHECK_THAT(*abi_mismatch("api=0.2", "api=0.1"),
             Contains("plugin interface 0.1, which is older than this program's 0.2") &&
                 Contains("rebuild it with the headers of this Elsie (plugin interface 0.2)"));
  CHECK_THAT(*abi_mismatch("api=0.2", "api=0.3"),
             Contains("plugin interface 0.3, which is newer than this program's 0.2"));
}

TEST_CASE("From 1.0 on, minor versions up to the host's fit") {
  CHECK_FALSE(abi_mismatch("api=1.10", "api=1.9"));
  CHECK_FALSE(abi_mismatch("api=1.10", "api=1.0"));
  CHECK(abi_mismatch("api=1.10", "api=1.11"));
  CHECK(abi_mismatch("api=1.10", "api=0.10"));
  CHECK(abi_mismatch("api=1.10", "api=2.0"));
}

TEST_CASE("Every setting that differs is named with both values") {
  CHECK_THAT(
      *abi_mismatch("api=0.1;sanitizer=none;pointer=8", "api=0.1;sanitizer=address;pointer=4"),
      Contains("sanitizer=address, where this program has sanitizer=none") &&
          Contains("pointer=4, where this program has pointer=8"));
}

TEST_CASE("Of another interface, whose word may have other settings, only the version is named") {
  CHECK_THAT(
      *abi_mismatch("api=0.2;rtti=on", "api=0.1"),
      Contains("was built for plugin interface 0.1, which is older than this program's 0.2;"));
}

TEST_CASE("A flag that changes type information or exceptions is named") {
  const std::string host(host_abi_word());
  const auto with = [&](const std::string& setting, const std::string& other) {
    std::string word = host;
    return word.replace(word.find(setting), setting.size(), other);
  };
  CHECK_THAT(*abi_mismatch(host, with("rtti=on", "rtti=off by -fno-rtti")),
             Contains("was built with rtti=off by -fno-rtti, where this program has rtti=on"));
  CHECK(abi_mismatch(host, with("exceptions=on", "exceptions=off by -fno-exceptions")));
  CHECK(abi_mismatch(host, with("wchar_t=4", "wchar_t=2 by -fshort-wchar")));
}

TEST_CASE("A setting that one side does not know is a difference") {
  CHECK_THAT(*abi_mismatch("api=0.1;pointer=8", "api=0.1"),
             Contains("with no pointer, where this program has pointer=8"));
  CHECK_THAT(*abi_mismatch("api=0.1", "api=0.1;enums=short"),
             Contains("with enums=short, where this program has no enums"));
}

TEST_CASE("Words that make no sense are refused") {
  for (const char* const word :
       {"", ";", "=", "api", "api=", "api=1", "api=x.y", "api=0.1.2", "api=0.", "api=-1.0"}) {
    INFO(word);
    CHECK(abi_mismatch("api=0.1", word));
  }
}
