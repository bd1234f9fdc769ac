// Who may connect. Any page in a browser may try to reach a server on the loopback, and a name of
// any page may lead there (DNS rebinding), so that both the page and the name are looked at.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace elsie::live {

/// An address of IPv4 or IPv6. It cannot lead to another machine tomorrow, as a name can.
bool is_numeric(const std::string& host);
/// "localhost", 127.x.y.z or ::1.
bool is_loopback(std::string_view host);

struct Visitor {
  std::string_view host;                   // the header Host; empty: none
  std::optional<std::string_view> origin;  // of a page in a browser; none: another program
  std::string_view protocols;              // the header Sec-WebSocket-Protocol
};

enum class Protocol { sdk, websocket };
constexpr const char* kProtocols[] = {"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// The protocol to speak; the newer one if the visitor knows both. None: it knows neither.
std::optional<Protocol> protocol_of(const Visitor& visitor);

/// Why a visitor is refused, as a sentence; none: it is welcome. Pages of this machine and of
/// Foxglove are, and those of `origins`.
std::optional<std::string> refusal_of(const Visitor& visitor, std::span<const std::string> origins);

}  // namespace elsie::live
