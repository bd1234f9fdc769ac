#include "elsie/live/address.h"

#include <charconv>
#include <optional>
#include <string_view>

#include "elsie/base/error.h"

#include "gate.h"

namespace elsie::live {
namespace {

std::optional<std::uint16_t> port_of(std::string_view text) {
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return port;
}

}  // namespace

bool Address::is_loopback() const { return live::is_loopback(host); }

std::string Address::url() const {
  const bool is_v6 = host.find(':') != host.npos;
  return "ws://" + (is_v6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

Address address_of(const std::string& text, const std::string& named_by) {
  Address address;
  const std::size_t colon = text.rfind(':');
  if (colon != text.npos) {
    address.host = text.substr(0, colon);
    if (address.host.starts_with('[') && address.host.ends_with(']')) {
      address.host = address.host.substr(1, address.host.size() - 2);
    }
  }
  const auto port = port_of(colon == text.npos ? std::string_view(text)
                                               : std::string_view(text).substr(colon + 1));
  if (!port || !is_numeric(address.host)) {
    throw base::BadInput(named_by + ": '" + text +
                         "' is no port to listen on; expected a number from 0 (any free port) to "
                         "65535, or ADDRESS:PORT with a numeric address, as in 0.0.0.0:8765");
  }
  address.port = *port;
  return address;
}

}  // namespace elsie::live
