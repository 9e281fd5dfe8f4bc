#include "server/net/http_connection.hpp"

#include "server/limits.hpp"
#include "server/net/http_error.hpp"
#include "server/net/websocket_connection.hpp"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include <cctype>
#include <memory>
#include <optional>

namespace wakesurf::server {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;
using boost::system::error_code;

namespace {

constexpr const char* content_policy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; "
                                       "worker-src 'self'; connect-src 'self'; "
                                       "style-src 'self'; img-src 'self' data: blob:; object-src "
                                       "'none'; base-uri 'none'; form-action 'none'; "
                                       "frame-ancestors 'none'";

/// Errors of reading that deserve an answer before the connection closes.
std::optional<HttpResponse> answer_to(error_code error) {
    if (error == http::error::body_limit)
        return http_error(413, "the body is longer than 65536 bytes", "send less at once");
    if (error == http::error::header_limit)
        return http_error(431, "the header is longer than 8192 bytes", "send fewer headers");
    if (error.category() == http::make_error_code(http::error::bad_method).category() &&
        error != http::error::end_of_stream && error != http::error::partial_message)
        return http_error(400, "this is not an HTTP request", "speak HTTP/1.1");
    return std::nullopt;
}

class HttpConnection final : public Connection,
                             public std::enable_shared_from_this<HttpConnection> {
  public:
    HttpConnection(tcp::socket socket, NetServices services)
        : stream_(std::move(socket)), services_(services) {
        services_.connections.add(*this);
    }

    ~HttpConnection() override { services_.connections.remove(*this); }

    void read();

    void go_away() override { stream_.close(); }

    void abandon() override { stream_.close(); }

    void announce(const std::string&) override {}

  private:
    using Request = http::request<http::string_body>;
    using Response = http::response<http::span_body<const char>>;

    void handle(Request request);
    void upgrade(const HttpRequest& request, const Identity& identity);
    void respond(const HttpResponse& response, bool keep_alive, bool head);

    beast::tcp_stream stream_;
    beast::flat_buffer buffer_;
    NetServices services_;
    std::optional<http::request_parser<http::string_body>> parser_;
    std::shared_ptr<const std::string> body_; ///< of the response under way
    std::optional<Response> response_;
};

HttpRequest plain(const http::request<http::string_body>& request) {
    HttpRequest out;
    out.method = std::string(request.method_string());
    const auto target = request.target();
    out.path = std::string(target.substr(0, target.find('?')));
    for (const auto& field : request) {
        std::string name(field.name_string());
        for (char& c : name)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        out.headers.emplace_back(std::move(name), std::string(field.value()));
    }
    out.body = request.body();
    out.upgrade = beast::websocket::is_upgrade(request);
    return out;
}

void HttpConnection::read() {
    parser_.emplace();
    parser_->header_limit(limits::http_header_bytes);
    parser_->body_limit(limits::message_bytes);
    stream_.expires_after(limits::handshake);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                         if (!error)
                             return self->handle(self->parser_->release());
                         if (const auto answer = answer_to(error))
                             self->respond(*answer, false, false);
                         else
                             self->stream_.close();
                     });
}

void HttpConnection::handle(Request request) {
    stream_.expires_never(); // an answer may take its time; writing it sets the clock again
    const HttpRequest values = plain(request);
    if (values.upgrade) {
        const auto identity = services_.routes.admit_upgrade(values);
        if (!identity)
            return respond(identity.error(), false, false);
        return upgrade(values, *identity);
    }
    const bool keep_alive = request.keep_alive();
    const bool head = request.method() == http::verb::head;
    services_.routes.handle(
        values, [self = shared_from_this(), keep_alive, head](const HttpResponse& response) {
            self->respond(response, keep_alive, head);
        });
}

void HttpConnection::upgrade(const HttpRequest& request, const Identity& identity) {
    if (services_.clients >= limits::clients)
        return respond(
            http_error(503, "the server has as many clients as it may have", "try again later"),
            false, false);
    serve_websocket(stream_.release_socket(), request, identity, services_);
}

void HttpConnection::respond(const HttpResponse& response, bool keep_alive, bool head) {
    body_ = response.body;
    response_.emplace();
    response_->result(response.status);
    response_->version(11);
    response_->set(http::field::server, "wakesurf");
    response_->set("X-Content-Type-Options", "nosniff");
    response_->set("X-Frame-Options", "DENY");
    response_->set("Referrer-Policy", "no-referrer");
    response_->set("Cross-Origin-Resource-Policy", "same-origin");
    response_->set("Content-Security-Policy", content_policy);
    for (const auto& [name, value] : response.headers)
        response_->insert(name, value);
    const bool bodiless = response.status == 204 || response.status == 304;
    if (!bodiless)
        response_->content_length(body_->size());
    if (!bodiless && !head)
        response_->body() = {body_->data(), body_->size()};
    response_->keep_alive(keep_alive);
    stream_.expires_after(limits::stalled);
    http::async_write(stream_, *response_,
                      [self = shared_from_this()](error_code error, std::size_t) {
                          if (!error && self->response_->keep_alive())
                              return self->read();
                          error_code ignored;
                          self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
                          self->stream_.close();
                      });
}

} // namespace

void serve_http(tcp::socket socket, NetServices services) {
    error_code ignored;
    if (services.connections.count() >= limits::connections) {
        socket.close(ignored);
        return;
    }
    socket.set_option(tcp::no_delay(true), ignored);
    std::make_shared<HttpConnection>(std::move(socket), services)->read();
}

} // namespace wakesurf::server
