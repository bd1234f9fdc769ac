// Who may connect, without connections.
#include <catch2/catch.hpp>

#include "elsie/base/error.h"
#include "elsie/live/address.h"

#include "gate.h"

using namespace elsie::live;

namespace {

bool is_let_in(const std::string& host, std::optional<std::string_view> origin = std::nullopt) {
  const std::string others[] = {"https://viewer.example.org"};
  return !refusal_of({host, origin, ""}, others);
}

}  // namespace

TEST_CASE("Programs of this machine and pages of Foxglove are let in, other pages are not") {
  CHECK(is_let_in("127.0.0.1:8765"));
  CHECK(is_let_in("127.0.0.1:8765", "https://app.foxglove.dev"));
  CHECK(is_let_in("127.0.0.1:8765", "https://studio.foxglove.dev"));
  CHECK(is_let_in("127.0.0.1:8765", "file://"));
  CHECK(is_let_in("127.0.0.1:8765", "http://localhost:8080"));
  CHECK(is_let_in("127.0.0.1:8765", "http://[::1]:8080"));
  CHECK(is_let_in("127.0.0.1:8765", "https://viewer.example.org"));
  for (const char* origin :
       {"https://evil.example", "null", "", "https://app.foxglove.dev.evil.example",
        "http://app.foxglove.dev", "https://localhost.evil.example",
        "https://127.0.0.1.evil.example", "https://viewer.example.org:444"}) {
    CAPTURE(origin);
    CHECK_FALSE(is_let_in("127.0.0.1:8765", origin));
  }
}

TEST_CASE("A name that may lead elsewhere tomorrow is refused as a host") {
  for (const char* host : {"localhost", "LOCALHOST:8765", "[::1]:8765", "192.168.0.7:8765"}) {
    CAPTURE(host);
    CHECK(is_let_in(host));
  }
  for (const char* host : {"", "rebound.example:8765", "127.0.0.1.rebound.example", "["}) {
    CAPTURE(host);
    CHECK_FALSE(is_let_in(host));
  }
}

TEST_CASE("The newer protocol is spoken if both are offered, none if neither is") {
  const auto chosen = [](std::string_view offered) {
    return protocol_of({"127.0.0.1", std::nullopt, offered});
  };
  CHECK(chosen("foxglove.websocket.v1, foxglove.sdk.v1") == Protocol::sdk);
  CHECK(chosen(" foxglove.websocket.v1") == Protocol::websocket);
  CHECK_FALSE(chosen(""));
  CHECK_FALSE(chosen("chat, foxglove.sdk.v10"));
}

TEST_CASE("An address is a port, or a numeric address with a port") {
  CHECK(address_of("9000", "--live").url() == "ws://127.0.0.1:9000");
  CHECK(address_of("9000", "--live").is_loopback());
  CHECK(address_of("0", "--live").port == 0);
  CHECK(address_of("0.0.0.0:9000", "--live").url() == "ws://0.0.0.0:9000");
  CHECK_FALSE(address_of("0.0.0.0:9000", "--live").is_loopback());
  CHECK(address_of("[::1]:9000", "--live").url() == "ws://[::1]:9000");
  CHECK(address_of("[::1]:9000", "--live").is_loopback());
  for (const char* wrong :
       {"", "-1", "65536", "8765x", "example.org:8765", ":8765", "127.0.0.1:"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH(address_of(wrong, "--live"),
                      Catch::StartsWith("--live: '" + std::string(wrong) + "' is no port"));
  }
}
