#include "client.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>  // before Asio, which needs it and does not include it

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace elsie::test {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using beast::error_code;

constexpr std::chrono::seconds kLong{60};  // a frame that has not come then never comes

/// Connects, and does operations one after the other.
class Line {
 public:
  explicit Line(std::uint16_t port) {
    await([&](auto done) {
      stream_.next_layer().async_connect(tcp::endpoint(asio::ip::address_v4::loopback(), port),
                                         [done](error_code error) { done(error); });
    });
  }

  template <class Start>
  void await(const Start& start) {
    std::optional<error_code> result;
    start([&result](error_code error) { result = error; });
    io_.restart();
    io_.run_for(kLong);
    if (!result) throw std::runtime_error("nothing has come from the server");
    if (*result) throw beast::system_error(*result);
  }

  asio::io_context io_;
  websocket::stream<beast::tcp_stream> stream_{io_};
};

template <class Number>
void add(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}
template <class Number>
Number take(std::string& bytes) {
  Number number;
  if (bytes.size() < sizeof(number)) throw std::runtime_error("a frame is too short");
  std::memcpy(&number, bytes.data(), sizeof(number));
  bytes.erase(0, sizeof(number));
  return number;
}

}  // namespace

Answer knock(std::uint16_t port, const Knock& knock) {
  Line line(port);
  http::request<http::empty_body> request(http::verb::get, "/", 11);
  if (!knock.host.empty()) request.set(http::field::host, knock.host);
  if (!knock.origin.empty()) request.set(http::field::origin, knock.origin);
  if (knock.upgrades) {
    request.set(http::field::connection, "Upgrade");
    request.set(http::field::upgrade, "websocket");
    request.set(http::field::sec_websocket_version, "13");
    request.set(http::field::sec_websocket_key, "dGhlIHNhbXBsZSBub25jZQ==");
    if (!knock.protocols.empty()) {
      request.set(http::field::sec_websocket_protocol, knock.protocols);
    }
  }
  auto& stream = line.stream_.next_layer();
  line.await([&](auto done) {
    http::async_write(stream, request, [done](error_code error, std::size_t) { done(error); });
  });
  beast::flat_buffer buffer;
  http::response<http::string_body> answer;
  line.await([&](auto done) {
    http::async_read(stream, buffer, answer,
                     [done](error_code error, std::size_t) { done(error); });
  });
  return {static_cast<int>(answer.result_int()), answer.body(),
          std::string(answer[http::field::sec_websocket_protocol])};
}

std::shared_ptr<void> keep_silent(std::uint16_t port) { return std::make_shared<Line>(port); }

class Client::Impl {
 public:
  Impl(std::uint16_t port, const Knock& knock) : line_(port) {
    line_.stream_.read_message_max(0);  // any size
    line_.stream_.set_option(
        websocket::stream_base::decorator([knock](websocket::request_type& request) {
          request.set(http::field::sec_websocket_protocol, knock.protocols);
          if (!knock.origin.empty()) request.set(http::field::origin, knock.origin);
        }));
    line_.await([&](auto done) {
      line_.stream_.async_handshake(knock.host, "/", [done](error_code error) { done(error); });
    });
  }

  Frame read() {
    beast::flat_buffer buffer;
    line_.await([&](auto done) {
      line_.stream_.async_read(buffer, [done](error_code error, std::size_t) { done(error); });
    });
    return {line_.stream_.got_text(), beast::buffers_to_string(buffer.data())};
  }

  void write(const std::string& bytes, bool is_text) {
    line_.stream_.text(is_text);
    line_.await([&](auto done) {
      line_.stream_.async_write(asio::buffer(bytes),
                                [done](error_code error, std::size_t) { done(error); });
    });
  }

  int close_code() {
    try {
      for (;;) read();
    } catch (const beast::system_error&) {
      return line_.stream_.reason().code;
    }
  }

 private:
  Line line_;
};

Client::Client(std::uint16_t port, const Knock& knock)
    : impl_(std::make_unique<Impl>(port, knock)) {}
Client::~Client() = default;

Client::Frame Client::read() { return impl_->read(); }

nlohmann::json Client::text(const std::string& op) {
  for (;;) {
    const Frame frame = read();
    if (!frame.is_text) continue;
    auto json = nlohmann::json::parse(frame.bytes);
    if (json.at("op") == op) return json;
  }
}

Message Client::message(std::uint32_t subscription) {
  for (;;) {
    const auto message = message_of(read());
    if (message && message->subscription == subscription) return *message;
  }
}

PlaybackState Client::state(const std::string& request) {
  return state_that([&](const PlaybackState& state) { return state.request == request; });
}

std::optional<Message> Client::message_of(const Frame& frame) {
  if (frame.is_text || frame.bytes.at(0) != 1) return std::nullopt;
  std::string bytes = frame.bytes.substr(1);
  Message message;
  message.subscription = take<std::uint32_t>(bytes);
  message.time_ns = take<std::uint64_t>(bytes);
  message.text = bytes;
  return message;
}

std::optional<PlaybackState> Client::state_of(const Frame& frame) {
  if (frame.is_text || frame.bytes.at(0) != 5) return std::nullopt;
  std::string bytes = frame.bytes.substr(1);
  PlaybackState state;
  state.status = take<std::uint8_t>(bytes);
  state.time_ns = take<std::uint64_t>(bytes);
  state.speed = take<float>(bytes);
  state.did_seek = take<std::uint8_t>(bytes) != 0;
  const auto length = take<std::uint32_t>(bytes);
  if (length != bytes.size()) throw std::runtime_error("an id of another length");
  state.request = bytes;
  return state;
}

void Client::send_text(const std::string& text) { impl_->write(text, true); }
void Client::send_bytes(const std::string& bytes) { impl_->write(bytes, false); }

void Client::steer(bool plays, float speed, std::optional<double> seek_s,
                   const std::string& request) {
  std::string bytes(1, '\3');
  add(bytes, static_cast<std::uint8_t>(plays ? 0 : 1));
  add(bytes, speed);
  add(bytes, static_cast<std::uint8_t>(seek_s ? 1 : 0));
  add(bytes, static_cast<std::uint64_t>(std::llround(seek_s.value_or(0.0) * 1e9)));
  add(bytes, static_cast<std::uint32_t>(request.size()));
  send_bytes(bytes + request);
}

void Client::subscribe(std::uint32_t subscription, std::uint32_t channel) {
  send({{"op", "subscribe"}, {"subscriptions", {{{"id", subscription}, {"channelId", channel}}}}});
}

int Client::close_code() { return impl_->close_code(); }

}  // namespace elsie::test
