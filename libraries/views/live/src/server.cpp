#include "server.h"

#include <array>
#include <chrono>
#include <csignal>
#include <list>
#include <optional>
#include <thread>
#include <utility>  // before Asio, which needs it and does not include it

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <fcntl.h>

#include "elsie/base/error.h"

#include "hub.h"

namespace elsie::live {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using beast::error_code;
using std::chrono::seconds;

constexpr std::size_t kMostClients = 32;
constexpr std::size_t kMostConnections =
    4 * kMostClients;                               // with those that have not said who they are
constexpr std::size_t kMostOfARequest = 8U << 10U;  // bytes
constexpr std::size_t kMostOfAMessage = 1U << 20U;  // bytes, from a client
constexpr int kSendBuffer = 256 << 10;  // bytes; more only makes what a slow client sees older
constexpr std::chrono::milliseconds kBetweenTries{100};
constexpr seconds kToConnect{10}, kToPart{2}, kSilence{300};

/// Programs that a plugin starts must not keep it open.
void keep_to_this_process(int descriptor) { fcntl(descriptor, F_SETFD, FD_CLOEXEC); }

std::string_view text_of(boost::beast::string_view text) { return {text.data(), text.size()}; }

/// One client, from its first byte on. Its handlers keep it alive.
class Session final : public std::enable_shared_from_this<Session> {
 public:
  Session(tcp::socket socket, Hub& hub, const std::vector<std::string>& origins)
      : stream_(std::move(socket)), hub_(hub), origins_(origins) {}
  ~Session() {
    if (client_) hub_.leave(*client_);
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  void start() {
    parser_.header_limit(kMostOfARequest);
    parser_.body_limit(kMostOfARequest);
    tcp_stream().expires_after(kToConnect);
    http::async_read(tcp_stream(), buffer_, parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (!error) self->receive();
                     });
  }

  void finish() {
    if (!is_open_) {
      tcp_stream().close();
      return;
    }
    is_open_ = false;
    // The good-bye waits for what is being sent, which a client that does not read never takes.
    parting_.expires_after(kToPart);
    parting_.async_wait([self = shared_from_this()](error_code error) {
      if (!error) self->tcp_stream().close();
    });
    stream_.async_close({websocket::close_code::going_away, "the run is no longer shown"},
                        [self = shared_from_this()](error_code) { self->parting_.cancel(); });
  }

 private:
  beast::tcp_stream& tcp_stream() { return stream_.next_layer(); }

  void receive() {
    const auto& request = parser_.get();
    const auto header = [&](http::field name) { return text_of(request[name]); };
    Visitor visitor{.host = header(http::field::host),
                    .origin = std::nullopt,
                    .protocols = header(http::field::sec_websocket_protocol)};
    if (request.count(http::field::origin) > 0) visitor.origin = header(http::field::origin);
    const auto refusal = refusal_of(visitor, origins_);
    const auto protocol = protocol_of(visitor);
    if (refusal) return refuse(http::status::forbidden, *refusal);
    if (hub_.present() >= kMostClients) {
      return refuse(http::status::service_unavailable,
                    "there are " + std::to_string(kMostClients) + " clients already");
    }
    if (!websocket::is_upgrade(request)) {
      return refuse(http::status::upgrade_required,
                    "this is the live view of a run of elsie; open this address in Foxglove, as a "
                    "Foxglove WebSocket");
    }
    if (!protocol) {
      return refuse(http::status::bad_request, std::string("the protocol is unknown; expected ") +
                                                   kProtocols[0] + " or " + kProtocols[1] +
                                                   " in Sec-WebSocket-Protocol");
    }
    accept(*protocol);
  }

  void refuse(http::status status, const std::string& sentence) {
    answer_.result(status);
    answer_.version(11);
    answer_.set(http::field::content_type, "text/plain; charset=utf-8");
    answer_.set(http::field::connection, "close");
    if (status == http::status::upgrade_required) answer_.set(http::field::upgrade, "websocket");
    answer_.body() = sentence + "\n";
    answer_.prepare_payload();
    http::async_write(tcp_stream(), answer_, [self = shared_from_this()](error_code, std::size_t) {
      error_code ignored;
      self->tcp_stream().socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  void accept(Protocol protocol) {
    tcp_stream().expires_never();  // from here on the web socket's own limits
    websocket::stream_base::timeout limits;
    limits.handshake_timeout = kToPart;
    limits.idle_timeout = kSilence;
    limits.keep_alive_pings = true;
    stream_.set_option(limits);
    stream_.set_option(
        websocket::stream_base::decorator([protocol](websocket::response_type& response) {
          response.set(http::field::sec_websocket_protocol, kProtocols[static_cast<int>(protocol)]);
        }));
    stream_.auto_fragment(false);  // a message is one frame
    stream_.read_message_max(kMostOfAMessage);
    stream_.async_accept(parser_.get(), [self = shared_from_this(), protocol](error_code error) {
      if (!error) self->begin(protocol);
    });
  }

  void begin(Protocol protocol) {
    is_open_ = true;
    const auto executor = stream_.get_executor();
    client_ = hub_.join(protocol, [executor, weak = weak_from_this()] {
      asio::post(executor, [weak] {
        if (const auto self = weak.lock()) self->write();
      });
    });
    buffer_.clear();
    read();
    write();
  }

  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      if (error) return self->leave();
      self->hear();
    });
  }

  void hear() {
    const auto data = buffer_.cdata();
    const std::string_view bytes(static_cast<const char*>(data.data()), data.size());
    hub_.hear(*client_, stream_.got_text() ? request_of_text(bytes) : request_of_bytes(bytes));
    buffer_.consume(buffer_.size());
    read();
  }

  void write() {
    if (!is_open_) return;
    if (hub_.is_flooded(*client_)) return leave();
    if (is_writing_) return;
    frame_ = hub_.next(*client_);
    if (!frame_) return;
    is_writing_ = true;
    stream_.binary(!frame_->is_text);
    const std::string_view body = frame_->body ? *frame_->body : std::string_view();
    const std::array<asio::const_buffer, 2> parts{asio::buffer(frame_->head),
                                                  asio::buffer(body.data(), body.size())};
    stream_.async_write(parts, [self = shared_from_this()](error_code error, std::size_t) {
      self->is_writing_ = false;
      if (!error) self->write();
    });
  }

  /// The connection is over.
  void leave() {
    is_open_ = false;
    if (client_) hub_.leave(*std::exchange(client_, std::nullopt));
    tcp_stream().close();
  }

  websocket::stream<beast::tcp_stream> stream_;
  asio::steady_timer parting_{stream_.get_executor()};
  Hub& hub_;
  const std::vector<std::string>& origins_;
  beast::flat_buffer buffer_;
  http::request_parser<http::string_body> parser_;
  http::response<http::string_body> answer_;
  std::optional<ClientId> client_;
  std::optional<Frame> frame_;  // that is being sent
  bool is_open_ = false, is_writing_ = false;
};

}  // namespace

class Server::Impl {
 public:
  explicit Impl(const Address& address) : address_(address) {
    error_code error;
    const tcp::endpoint place(asio::ip::make_address(address.host, error), address.port);
    if (!error) acceptor_.open(place.protocol(), error);
    if (!error) keep_to_this_process(acceptor_.native_handle());
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(place, error);
    if (!error) acceptor_.listen(static_cast<int>(kMostClients), error);
    if (error) {
      const bool is_taken = error == asio::error::address_in_use;
      throw base::BadInput(
          "--live: cannot listen on " + address_.url() + ": " +
          (is_taken ? std::string("the port is in use by another program; choose another one, or 0 "
                                  "for any free one: --live 0")
                    : error.message()));
    }
    address_.port = acceptor_.local_endpoint().port();
  }

  ~Impl() {
    if (!thread_.joinable()) return;
    asio::post(io_, [this] {
      is_ending_ = true;
      error_code ignored;
      acceptor_.close(ignored);
      pause_.cancel();
      for (const auto& each : sessions_) {
        if (const auto session = each.lock()) session->finish();
      }
    });
    thread_.join();
  }

  const Address& address() const { return address_; }

  void start(Hub& hub, std::vector<std::string> origins) {
    hub_ = &hub;
    origins_ = std::move(origins);
    accept();
    // Signals are for the threads of the run.
    sigset_t all, before;
    sigemptyset(&all);
    for (const int each : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&all, each);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    thread_ = std::thread([this] { io_.run(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

 private:
  void accept() {
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      if (is_ending_) return;
      if (!error) {
        admit(std::move(socket));
        return accept();
      }
      // There are no more descriptors, perhaps; a moment later there may be.
      pause_.expires_after(kBetweenTries);
      pause_.async_wait([this](error_code) {
        if (!is_ending_) accept();
      });
    });
  }

  void admit(tcp::socket socket) {
    keep_to_this_process(socket.native_handle());
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
    socket.set_option(asio::socket_base::send_buffer_size(kSendBuffer), ignored);
    sessions_.remove_if([](const auto& each) { return each.expired(); });
    if (sessions_.size() >= kMostConnections) return;
    const auto session = std::make_shared<Session>(std::move(socket), *hub_, origins_);
    sessions_.push_back(session);
    session->start();
  }

  Address address_;
  asio::io_context io_{1};
  tcp::acceptor acceptor_{io_};
  asio::steady_timer pause_{io_};
  Hub* hub_ = nullptr;
  std::vector<std::string> origins_;
  std::list<std::weak_ptr<Session>> sessions_;
  bool is_ending_ = false;
  std::thread thread_;
};

Server::Server(const Address& address) : impl_(std::make_unique<Impl>(address)) {}
Server::~Server() = default;

const Address& Server::address() const { return impl_->address(); }
void Server::start(Hub& hub, std::vector<std::string> origins) {
  impl_->start(hub, std::move(origins));
}

}  // namespace elsie::live
