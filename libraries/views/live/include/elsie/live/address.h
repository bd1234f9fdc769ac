// Where a live view listens.
#pragma once

#include <cstdint>
#include <string>

namespace elsie::live {

struct Address {
  std::string host = "127.0.0.1";  // a numeric address, IPv4 or IPv6
  std::uint16_t port = 8765;       // 0: any free one

  /// Whether only programs of this machine reach it.
  bool is_loopback() const;
  /// "ws://127.0.0.1:8765"
  std::string url() const;
};

/// Reads "8765", "0.0.0.0:8765" or "[::1]:8765". Throws base::BadInput, which begins with
/// `named_by`.
Address address_of(const std::string& text, const std::string& named_by);

}  // namespace elsie::live
