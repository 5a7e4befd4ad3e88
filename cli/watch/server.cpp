#include "cli/watch/server.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>

#include <array>
#include <chrono>
#include <optional>
#include <random>
#include <set>
#include <string_view>
#include <utility>

namespace loadpath::cli {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using Error = boost::system::error_code;
using Request = http::request<http::empty_body>;
using Response = http::response<http::string_body>;

constexpr std::chrono::seconds patience{30};  // with one that asks or takes slowly

/// 128 random bits, which cannot be guessed.
std::string drawn_word() {
  constexpr std::string_view digits = "0123456789abcdef";
  std::random_device device;
  std::string word;
  for (int part = 0; part < 4; ++part) {
    for (unsigned bits = device(), n = 0; n < 8; ++n, bits >>= 4) word += digits[bits & 15u];
  }
  return word;
}

}  // namespace

class Listener;

struct Server::State {
  State(asio::io_context& context, unsigned short port)
      : acceptor(context, tcp::endpoint(asio::ip::address_v4::loopback(), port)), word(drawn_word()) {}

  tcp::acceptor acceptor;
  std::string word;
  Revision revision;
  std::set<std::shared_ptr<Listener>> listeners;  // pages that are open
};

/// A page that receives every revision by server-sent events.
class Listener : public std::enable_shared_from_this<Listener> {
 public:
  Listener(beast::tcp_stream stream, std::weak_ptr<Server::State> state)
      : stream_(std::move(stream)), state_(std::move(state)) {}

  void start() {
    stream_.expires_never();
    waiting_ =
        "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\nConnection: close\r\n\r\n";
    watch_end();
    notify();
  }
  /// Sends the newest revision; of several during one write only the last.
  void notify() {
    if (writing_) {
      is_late_ = true;
      return;
    }
    const auto state = state_.lock();
    if (state == nullptr) return;
    waiting_ += "data: " + news_of(state->revision) + "\n\n";
    writing_ = true;
    asio::async_write(stream_, asio::buffer(waiting_), [self = shared_from_this()](Error error, std::size_t) {
      self->writing_ = false;
      self->waiting_.clear();
      if (error) return self->leave();
      if (std::exchange(self->is_late_, false)) self->notify();
    });
  }

 private:
  /// A page sends nothing more; reading detects its end.
  void watch_end() {
    stream_.async_read_some(asio::buffer(said_), [self = shared_from_this()](Error error, std::size_t) {
      error ? self->leave() : self->watch_end();
    });
  }
  void leave() {
    if (const auto state = state_.lock()) state->listeners.erase(shared_from_this());
  }

  beast::tcp_stream stream_;
  std::weak_ptr<Server::State> state_;
  std::string waiting_;
  std::array<char, 64> said_{};
  bool writing_ = false, is_late_ = false;
};

namespace {

/// One question and its answer.
class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(tcp::socket socket, std::shared_ptr<Server::State> state)
      : stream_(std::move(socket)), state_(std::move(state)) {}

  void start() {
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, request_, [self = shared_from_this()](Error error, std::size_t) {
      if (!error) self->answer();
    });
  }

 private:
  void answer() {
    const std::string_view target(request_.target().data(), request_.target().size());
    const std::string root = "/" + state_->word + "/";
    if (!is_for_us()) return send(http::status::forbidden, "text/plain", "this address is served on loopback only\n");
    if (request_.method() != http::verb::get && request_.method() != http::verb::head)
      return send(http::status::method_not_allowed, "text/plain", "the page is only read\n");
    if (target == root) return send(http::status::ok, "text/html", live_page(state_->revision));
    if (target == root + "problem") return send(http::status::ok, "text/plain", state_->revision.problem);
    if (target == root + "events") return listen();
    send(http::status::not_found, "text/plain", "unknown page; `loadpath watch` prints the address\n");
  }
  /// Another site's page may direct its own name here; it cannot use ours.
  [[nodiscard]] bool is_for_us() const {
    const auto host = request_[http::field::host];
    const std::string port = ":" + std::to_string(state_->acceptor.local_endpoint().port());
    return host == "127.0.0.1" + port || host == "localhost" + port;
  }
  void listen() {
    const auto listener = std::make_shared<Listener>(std::move(stream_), state_);
    state_->listeners.insert(listener);
    listener->start();
  }
  void send(http::status status, std::string_view type, std::string body) {
    response_ = Response(status, 11);
    response_.set(http::field::content_type, std::string(type) + "; charset=utf-8");
    response_.set(http::field::cache_control, "no-store");
    response_.set("X-Content-Type-Options", "nosniff");
    response_.set("Referrer-Policy", "no-referrer");
    response_.set("Content-Security-Policy",
                  "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; "
                  "font-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
    if (status == http::status::method_not_allowed) response_.set(http::field::allow, "GET, HEAD");
    response_.keep_alive(false);
    response_.content_length(body.size());
    if (request_.method() != http::verb::head) response_.body() = std::move(body);
    serializer_.emplace(response_);
    if (request_.method() == http::verb::head) serializer_->split(true);
    const auto done = [self = shared_from_this()](Error, std::size_t) {
      Error ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    };
    if (request_.method() == http::verb::head)
      http::async_write_header(stream_, *serializer_, done);
    else
      http::async_write(stream_, *serializer_, done);
  }

  beast::tcp_stream stream_;
  std::shared_ptr<Server::State> state_;
  beast::flat_buffer buffer_{16384};
  Request request_;
  Response response_;
  std::optional<http::response_serializer<http::string_body>> serializer_;
};

void accept(const std::shared_ptr<Server::State>& state) {
  state->acceptor.async_accept([state](Error error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) std::make_shared<Session>(std::move(socket), state)->start();
    accept(state);
  });
}

}  // namespace

Server::Server(asio::io_context& context, unsigned short port) : state_(std::make_shared<State>(context, port)) {
  accept(state_);
}

Server::~Server() {
  Error ignored;
  state_->acceptor.close(ignored);
  state_->listeners.clear();
}

std::string Server::address() const {
  return "http://127.0.0.1:" + std::to_string(state_->acceptor.local_endpoint().port()) + "/" + state_->word + "/";
}

void Server::publish(Revision revision) {
  state_->revision = std::move(revision);
  const auto listeners = state_->listeners;  // one may leave during the loop
  for (const auto& listener : listeners) listener->notify();
}

}  // namespace loadpath::cli
