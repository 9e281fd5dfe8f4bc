// A running server, asked over HTTP like any script would.
#include "server/app/server_address.hpp"
#include "server/app/session_server.hpp"
#include "server/base/limits.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>

#include <chrono>
#include <cstdlib>
#include <functional>
#include <utility>

namespace wakesurf::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using boost::system::error_code;
using core::Error;
using core::fail;

namespace {

constexpr std::chrono::seconds patience{60}; ///< for each step
constexpr std::size_t longest_answer = 4 * limits::session_file_bytes;

using Request = http::request<http::string_body>;

class RunningServer final : public SessionServer {
  public:
    RunningServer(ServerAddress address, std::filesystem::path authority)
        : address_(std::move(address)), authority_(std::move(authority)) {}

    core::Result<Answer>
    ask(const std::string& method, const std::string& path, const std::string& body) override;

  private:
    core::Result<Answer> exchange(beast::tcp_stream& stream, const Request& request);
    core::Result<Answer> exchange_encrypted(beast::tcp_stream stream, const Request& request);
    template <class Stream>
    core::Result<Answer> exchange_over(Stream& stream, const Request& request);
    error_code wait_for(beast::tcp_stream& stream,
                        const std::function<void(std::function<void(error_code)>)>& start);
    tl::unexpected<Error> no_answer(error_code why) const;

    ServerAddress address_;
    std::filesystem::path authority_;
    asio::io_context context_{1};
};

tl::unexpected<Error> RunningServer::no_answer(error_code why) const {
    return fail(Error::Code::Io, "no answer from " + address_.authority() + ": " + why.message(),
                "check that the server is running there");
}

/// Starts an asynchronous operation and waits for its end, because only such operations have a time limit.
error_code
RunningServer::wait_for(beast::tcp_stream& stream,
                        const std::function<void(std::function<void(error_code)>)>& start) {
    error_code outcome = asio::error::timed_out;
    stream.expires_after(patience);
    start([&outcome](error_code error) { outcome = error; });
    context_.restart();
    context_.run();
    return outcome;
}

template <class Stream>
core::Result<SessionServer::Answer> RunningServer::exchange_over(Stream& stream,
                                                                 const Request& request) {
    auto& socket = beast::get_lowest_layer(stream);
    const error_code sent = wait_for(socket, [&](std::function<void(error_code)> done) {
        http::async_write(stream, request,
                          [done = std::move(done)](error_code error, std::size_t) { done(error); });
    });
    if (sent)
        return no_answer(sent);
    beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    parser.body_limit(longest_answer);
    const error_code read = wait_for(socket, [&](std::function<void(error_code)> done) {
        http::async_read(stream, buffer, parser,
                         [done = std::move(done)](error_code error, std::size_t) { done(error); });
    });
    if (read)
        return no_answer(read);
    return Answer{parser.get().result_int(), std::move(parser.get().body())};
}

core::Result<SessionServer::Answer> RunningServer::exchange(beast::tcp_stream& stream,
                                                            const Request& request) {
    return exchange_over(stream, request);
}

core::Result<SessionServer::Answer> RunningServer::exchange_encrypted(beast::tcp_stream socket,
                                                                      const Request& request) {
    asio::ssl::context tls(asio::ssl::context::tls_client);
    error_code error;
    if (authority_.empty())
        tls.set_default_verify_paths(error);
    else
        tls.load_verify_file(authority_.string(), error);
    if (error)
        return fail(Error::Code::Io, "the certificates to trust cannot be read: " + error.message(),
                    "give --ca a PEM file");
    tls.set_verify_mode(asio::ssl::verify_peer);
    asio::ssl::stream<beast::tcp_stream> stream(std::move(socket), tls);
    stream.set_verify_callback(asio::ssl::host_name_verification(address_.host));
    SSL_set_tlsext_host_name(stream.native_handle(), address_.host.c_str());
    error = wait_for(beast::get_lowest_layer(stream), [&](std::function<void(error_code)> done) {
        stream.async_handshake(asio::ssl::stream_base::client,
                               [done = std::move(done)](error_code why) { done(why); });
    });
    if (error)
        return fail(Error::Code::Io,
                    "cannot open an encrypted connection to " + address_.authority() + ": " +
                        error.message(),
                    "give --ca the certificate of the authority that signed the server's");
    return exchange_over(stream, request);
}

core::Result<SessionServer::Answer>
RunningServer::ask(const std::string& method, const std::string& path, const std::string& body) {
    error_code error;
    const auto found = tcp::resolver(context_).resolve(address_.host, address_.port, error);
    if (error)
        return no_answer(error);
    beast::tcp_stream stream(context_);
    error = wait_for(stream, [&](std::function<void(error_code)> done) {
        stream.async_connect(
            found, [done = std::move(done)](error_code why, const tcp::endpoint&) { done(why); });
    });
    if (error)
        return no_answer(error);
    Request request(http::string_to_verb(method), address_.prefix + path, 11);
    request.set(http::field::host, address_.authority());
    request.set(http::field::connection, "close");
    if (!address_.token.empty())
        request.set(http::field::authorization, "Bearer " + address_.token);
    if (!body.empty())
        request.set(http::field::content_type, "application/json");
    request.body() = body;
    request.prepare_payload();
    return address_.tls ? exchange_encrypted(std::move(stream), request)
                        : exchange(stream, request);
}

} // namespace

core::Result<std::unique_ptr<SessionServer>> server_at(const std::string& url,
                                                       const std::filesystem::path& authority) {
    auto address = parse_server_address(url);
    if (!address)
        return tl::unexpected(address.error());
    return std::make_unique<RunningServer>(std::move(*address), authority);
}

} // namespace wakesurf::server
