#include "server/net/http_connection.hpp"

#include "server/base/limits.hpp"
#include "server/net/byte_stream.hpp"
#include "server/net/gate.hpp"
#include "server/net/websocket_connection.hpp"

#include <boost/asio/ssl/error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <spdlog/spdlog.h>

#include <cctype>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

namespace wakesurf::server {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;

namespace {

/// The size of the first read, before a connection has sent a request.
constexpr std::size_t first_bytes = 1024;

HttpResponse too_long(std::size_t longest_body) {
    return http_over_limit(413, longest_body,
                           "the body is longer than " + std::to_string(longest_body) + " bytes",
                           "send less at once");
}

/// Returns the answer to a read error that deserves one before the connection closes.
std::optional<HttpResponse> answer_to(error_code error, std::size_t longest_body) {
    if (error == http::error::body_limit)
        return too_long(longest_body);
    if (error == http::error::header_limit)
        return http_over_limit(431, limits::http_header_bytes,
                               "the header is longer than 8192 bytes", "send fewer headers");
    if (error.category() == http::make_error_code(http::error::bad_method).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message)
        return http_error(400, "this is not an HTTP request", "speak HTTP/1.1");
    return std::nullopt;
}

/// If a body's length can be read in two ways, a proxy in front may have taken the other one, and a client's
/// body would become the next request.
bool ambiguous(const http::request_header<>& header) {
    const auto codings = header.count(http::field::transfer_encoding);
    const auto lengths = header.count(http::field::content_length);
    const bool list = header[http::field::content_length].find(',') != beast::string_view::npos;
    return codings + lengths > 1 || list ||
           (codings == 1 && !beast::iequals(header[http::field::transfer_encoding], "chunked"));
}

std::optional<Rejection> rejection_of(unsigned status) {
    switch (status) {
    case 400:
        return Rejection::Malformed;
    case 401:
        return Rejection::Unauthenticated;
    case 403:
        return Rejection::Forbidden;
    case 413:
    case 431:
        return Rejection::TooLarge;
    case 429:
        return Rejection::RateLimited;
    default:
        return std::nullopt;
    }
}

class HttpConnection final : public Connection,
                             public std::enable_shared_from_this<HttpConnection> {
  public:
    HttpConnection(tcp::socket socket,
                   std::unique_ptr<Admission::Permit> permit,
                   NetServices services)
        : stream_(std::make_shared<ByteStream>(std::move(socket), services.tls)),
          timer_(stream_->get_executor()), services_(services), permit_(std::move(permit)) {
        services_.connections.add(*this);
    }

    ~HttpConnection() override { services_.connections.remove(*this); }

    void start(const boost::asio::ip::address& peer);

    void go_away() override { abandon(); }

    void abandon() override {
        timer_.cancel();
        stream_->close();
    }

  private:
    using Request = http::request<http::string_body>;
    using Response = http::response<http::span_body<const char>>;

    void after(std::chrono::milliseconds delay, std::function<void()> act);
    void expires_after(std::chrono::milliseconds delay);
    void no_deadline();
    void accept();
    void await_request(std::chrono::seconds patience);
    void read_header();
    void read_body();
    void failed(error_code error);
    void handle(Request request);
    void check_still_connected();
    void upgrade(const HttpRequest& request, const Admitted& admitted);
    void respond(const HttpResponse& response, bool keep_alive, bool head);
    void write();
    void written();
    void end();

    std::shared_ptr<ByteStream> stream_;
    boost::asio::steady_timer timer_;                  ///< the deadline, or what happens next
    bool timed_out_ = false;                           ///< the deadline closed the stream
    beast::flat_buffer buffer_{limits::message_bytes}; ///< the only limit on extensions of chunks
    NetServices services_;
    std::unique_ptr<Admission::Permit> permit_;
    std::optional<http::request_parser<http::string_body>> parser_;
    boost::asio::ip::address peer_; ///< or the client that a trusted proxy reports
    HttpResponse answer_;           ///< the pending response
    std::optional<Response> response_;
    std::optional<http::response_serializer<http::span_body<const char>>> serializer_;
    std::optional<std::stop_source> gone_; ///< fires when the client hangs up before its answer
    std::size_t longest_body_ = limits::message_bytes; ///< of the request being read
    bool named_ = false; ///< over TLS, under a name that other machines use
};

HttpRequest plain(const http::request_header<>& request) {
    HttpRequest out;
    out.method = std::string(request.method_string());
    const auto target = request.target();
    const auto mark = target.find('?');
    out.path = std::string(target.substr(0, mark));
    if (mark != target.npos)
        out.query = std::string(target.substr(mark + 1));
    for (const auto& field : request) {
        std::string name(field.name_string());
        for (char& c : name)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        out.headers.emplace_back(std::move(name), std::string(field.value()));
    }
    out.upgrade = beast::websocket::is_upgrade(request);
    return out;
}

/// Acts later, instead of what was to happen later before.
void HttpConnection::after(std::chrono::milliseconds delay, std::function<void()> act) {
    timer_.expires_after(delay);
    timer_.async_wait([weak = weak_from_this(), act = std::move(act)](error_code error) {
        const auto self = weak.lock();
        // A timer that was set again too late to be cancelled must not act.
        if (!error && self && self->timer_.expiry() <= boost::asio::steady_timer::clock_type::now())
            act();
    });
}

/// Sets the deadline at which the stream is closed.
void HttpConnection::expires_after(std::chrono::milliseconds delay) {
    after(delay, [this] {
        timed_out_ = true;
        stream_->close();
    });
}

void HttpConnection::no_deadline() {
    timer_.expires_at(boost::asio::steady_timer::time_point::max());
}

void HttpConnection::start(const boost::asio::ip::address& peer) {
    peer_ = peer;
    permit_->on_end([weak = weak_from_this()] {
        if (const auto self = weak.lock())
            self->stream_->close();
    });
    expires_after(limits::handshake);
    if (!services_.proxies.trusts(peer))
        return accept();
    stream_->async_proxy_header(
        [self = shared_from_this()](error_code error, const ProxyHeader& header) {
            if (error)
                return self->failed(error);
            if (header.from) {
                self->peer_ = *header.from;
                self->permit_->came_from(self->peer_, self->services_.proxies.trusts(self->peer_));
            }
            self->accept();
        });
}

void HttpConnection::accept() {
    stream_->async_accept([self = shared_from_this()](error_code error) {
        if (error)
            return self->failed(error);
        if (self->services_.tls != nullptr && !self->stream_->encrypted())
            return self->respond(http_text(400, "this port speaks TLS: use https:// or wss://\n"),
                                 false, false);
        self->await_request(limits::handshake);
    });
}

/// An idle connection may send nothing; after the first byte the whole header must follow.
void HttpConnection::await_request(std::chrono::seconds patience) {
    if (buffer_.size() > 0)
        return read_header();
    expires_after(patience);
    stream_->async_read_some(buffer_.prepare(first_bytes),
                             [self = shared_from_this()](error_code error, std::size_t bytes) {
                                 if (error)
                                     return self->failed(error);
                                 self->buffer_.commit(bytes);
                                 self->read_header();
                             });
}

void HttpConnection::read_header() {
    parser_.emplace();
    parser_->header_limit(limits::http_header_bytes);
    parser_->body_limit(limits::session_file_bytes); // the header will lower it
    expires_after(limits::handshake);
    http::async_read_header(
        *stream_, buffer_, *parser_, [self = shared_from_this()](error_code error, std::size_t) {
            self->longest_body_ =
                error && error != http::error::body_limit
                    ? limits::message_bytes
                    : self->services_.routes.longest_body(plain(self->parser_->get()));
            if (error)
                return self->failed(error);
            self->read_body();
        });
}

void HttpConnection::read_body() {
    if (ambiguous(parser_->get()))
        return respond(http_error(400,
                                  "the request states the length of its body in more than one way",
                                  "send one Content-Length, or one Transfer-Encoding: chunked"),
                       false, false);
    if (parser_->is_done())
        return handle(parser_->release());
    if (const auto length = parser_->content_length(); length && *length > longest_body_)
        return respond(too_long(longest_body_), false, false);
    parser_->body_limit(longest_body_);
    expires_after(longest_body_ > limits::message_bytes ? limits::session_file_time
                                                        : limits::handshake);
    http::async_read(*stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                         if (error)
                             return self->failed(error);
                         self->handle(self->parser_->release());
                     });
}

void HttpConnection::failed(error_code error) {
    if (timed_out_) {
        services_.metrics.reject(Rejection::HandshakeTimeout);
        return stream_->close();
    }
    if (const auto answer = answer_to(error, longest_body_))
        return respond(*answer, false, false);
    if (error.category() == boost::asio::error::get_ssl_category() ||
        error == boost::asio::error::no_protocol_option) {
        services_.metrics.reject(Rejection::Malformed);
        return end();
    }
    stream_->close();
}

void HttpConnection::handle(Request request) {
    no_deadline(); // an answer may take a while; writing it sets the deadline again
    HttpRequest values = plain(request);
    values.body = std::move(request.body());
    if (services_.proxies.trusts(peer_)) {
        const auto client = services_.proxies.client_of(peer_, values.list("x-forwarded-for"));
        permit_->came_from(client, services_.proxies.trusts(client));
    }
    values.from = permit_->from();
    const auto host = host_name(values.header("host"));
    named_ = stream_->encrypted() && host && !is_loopback(*host);
    if (values.upgrade) {
        const auto admitted = services_.routes.admit_upgrade(values);
        if (!admitted)
            return respond(admitted.error(), false, false);
        return upgrade(values, *admitted);
    }
    values.gone = gone_.emplace().get_token();
    check_still_connected();
    const bool keep_alive = request.keep_alive();
    const bool head = request.method() == http::verb::head;
    services_.routes.handle(
        values, [this] { permit_->let_in(); },
        [self = shared_from_this(), keep_alive, head](const HttpResponse& response) {
            self->respond(response, keep_alive, head);
        });
}

/// Nothing is read while a client waits for an answer: only the kernel knows that it has hung up.
void HttpConnection::check_still_connected() {
    after(limits::gone_check, [this] {
        if (!stream_->peer_gone())
            return check_still_connected();
        stream_->close();
        std::exchange(gone_, std::nullopt)->request_stop();
    });
}

void HttpConnection::upgrade(const HttpRequest& request, const Admitted& admitted) {
    permit_->let_in();
    services_.connections.remove(*this);
    no_deadline();
    stream_->put_back(beast::buffers_to_string(buffer_.data())); // frames may follow at once
    serve_websocket(std::move(stream_), request, admitted, services_, std::move(permit_));
}

void HttpConnection::respond(const HttpResponse& response, bool keep_alive, bool head) {
    if (const auto reason = rejection_of(response.status)) {
        services_.metrics.reject(*reason);
        spdlog::debug("event=refused client={} status={}", permit_->number(), response.status);
    }
    gone_.reset();
    answer_ = response;
    response_.emplace();
    response_->result(response.status);
    response_->version(11);
    response_->set(http::field::server, "wakesurf");
    const auto view = [](std::string_view text) {
        return beast::string_view(text.data(), text.size());
    };
    for (const auto& [name, value] : services_.headers.all())
        response_->set(view(name), view(value));
    if (named_)
        response_->set(http::field::strict_transport_security, view(transport_security));
    for (const auto& [name, value] : response.headers)
        response_->insert(name, value);
    const bool bodiless = response.status == 204 || response.status == 304;
    if (!bodiless)
        response_->content_length(answer_.body->size());
    if (!bodiless && !head)
        response_->body() = {answer_.body->data(), answer_.body->size()};
    response_->keep_alive(keep_alive);
    serializer_.emplace(*response_);
    write();
}

/// A large file may take long; the deadline is for a client that takes nothing.
void HttpConnection::write() {
    expires_after(limits::stalled);
    http::async_write_some(*stream_, *serializer_,
                           [self = shared_from_this()](error_code error, std::size_t) {
                               if (error && self->timed_out_)
                                   self->services_.metrics.reject(Rejection::Stalled);
                               if (error)
                                   return self->stream_->close();
                               if (!self->serializer_->is_done())
                                   return self->write();
                               self->written();
                           });
}

void HttpConnection::written() {
    const auto pause = std::exchange(answer_, {}).pause;
    permit_->wait();
    if (!response_->keep_alive())
        return end();
    if (pause.count() == 0)
        return await_request(limits::idle);
    services_.metrics.reject(Rejection::RateLimited);
    after(pause, [self = shared_from_this()] { self->await_request(limits::idle); });
}

void HttpConnection::end() {
    no_deadline();
    stream_->async_end([self = shared_from_this()](error_code) {});
}

} // namespace

void serve_http(tcp::socket socket, NetServices services) {
    error_code error;
    const auto from = socket.remote_endpoint(error);
    if (error)
        return; // closed meanwhile
    const auto peer = plain_address(from.address());
    auto permit = services.admission.admit(peer, services.proxies.trusts(peer));
    if (!permit)
        return;
    socket.set_option(tcp::no_delay(true), error);
    std::make_shared<HttpConnection>(std::move(socket), std::move(permit), services)->start(peer);
}

} // namespace wakesurf::server
