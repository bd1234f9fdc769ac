#include "gate.h"

#include <algorithm>
#include <cctype>

#include <arpa/inet.h>

namespace elsie::live {
namespace {

// The program that is installed loads its page from a file.
constexpr std::string_view kFoxglove[] = {"https://app.foxglove.dev", "https://studio.foxglove.dev",
                                          "file://"};

std::string lower(std::string_view text) {
  std::string made(text);
  std::transform(made.begin(), made.end(), made.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return made;
}

/// "127.0.0.1" of "127.0.0.1:8765", "::1" of "[::1]".
std::string host_of(std::string_view authority) {
  if (authority.starts_with('[')) {
    const std::size_t end = authority.find(']');
    return lower(authority.substr(1, end == authority.npos ? end : end - 1));
  }
  return lower(authority.substr(0, authority.find(':')));
}

bool is_welcome(std::string_view origin, std::span<const std::string> origins) {
  if (std::find(std::begin(kFoxglove), std::end(kFoxglove), origin) != std::end(kFoxglove) ||
      std::find(origins.begin(), origins.end(), origin) != origins.end()) {
    return true;
  }
  for (const std::string_view scheme : {"http://", "https://"}) {
    if (origin.starts_with(scheme)) return is_loopback(host_of(origin.substr(scheme.size())));
  }
  return false;
}

}  // namespace

bool is_numeric(const std::string& host) {
  unsigned char bytes[sizeof(in6_addr)];
  return inet_pton(AF_INET, host.c_str(), bytes) == 1 ||
         inet_pton(AF_INET6, host.c_str(), bytes) == 1;
}

bool is_loopback(std::string_view host) {
  return host == "localhost" || host == "::1" ||
         (host.starts_with("127.") && is_numeric(std::string(host)));
}

std::optional<Protocol> protocol_of(const Visitor& visitor) {
  for (const Protocol protocol : {Protocol::sdk, Protocol::websocket}) {
    std::string_view rest = visitor.protocols;
    while (!rest.empty()) {
      std::string_view word = rest.substr(0, rest.find(','));
      rest.remove_prefix(std::min(rest.size(), word.size() + 1));
      while (word.starts_with(' ') || word.starts_with('\t')) word.remove_prefix(1);
      while (word.ends_with(' ') || word.ends_with('\t')) word.remove_suffix(1);
      if (word == kProtocols[static_cast<int>(protocol)]) return protocol;
    }
  }
  return std::nullopt;
}

std::optional<std::string> refusal_of(const Visitor& visitor,
                                      std::span<const std::string> origins) {
  const std::string host = host_of(visitor.host);
  if (!is_loopback(host) && !is_numeric(host)) {
    return "the host '" + std::string(visitor.host) +
           "' is no numeric address; connect to an address such as 127.0.0.1, or to localhost";
  }
  if (visitor.origin && !is_welcome(*visitor.origin, origins)) {
    return "pages of '" + std::string(*visitor.origin) +
           "' may not watch this run; `elsie run --live-origin` lets the pages of an origin in";
  }
  return std::nullopt;
}

}  // namespace elsie::live
