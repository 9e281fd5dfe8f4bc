// A running server, asked over HTTP like any script would.

#include "server/app/session_server.hpp"

#include "server/app/command_output.hpp"
#include "server/base/limits.hpp"
#include "server/net/io_loop.hpp"
#include "server/net/methods/dispatcher.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/session_files.hpp"
#include "server/sessions/journal/sqlite_journal.hpp"
#include "server/sessions/journal/state_store.hpp"
#include "server/sessions/session_exchange.hpp"

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
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

/// Has no data: surfaces stay parameters, and nothing is computed.
class NoDatasets final : public Datasets {
  public:
    std::vector<std::string> ids() const override { return {}; }

    core::Result<OpenDataset> open(const std::string& id) const override {
        return fail(Error::Code::NotFound, "no dataset `" + id + "` is open here",
                    "serve it to look at its surfaces");
    }
};

class StateSessions final : public SessionServer {
  public:
    StateSessions(StoredSessions kept, bool changes)
        : kept_(std::move(kept)),
          journal_(changes ? std::make_unique<SqliteJournal>(loop_, std::move(kept_.store), nullptr)
                           : nullptr),
          grants_({loop_, clock_, entropy_, unix_seconds, journal_.get()}),
          sessions_({loop_, pool_, datasets_, entropy_, nullptr, journal_.get(), &clock_}),
          dispatcher_(method_table(),
                      {sessions_, datasets_, [] { return nlohmann::json::array(); }, prober_,
                       grants_, clock_, loop_, journal_.get()},
                      {limits::message_bytes, limits::message_depth, limits::batch}),
          files_(loop_, pool_, sessions_, datasets_, journal_.get()) {
        const auto restored =
            restore_sessions(std::exchange(kept_.sessions, {}), sessions_, grants_);
        for (const RestoredSessions::Refused& each : restored.refused)
            tell(stderr, "wakesurf: {}: kept aside: {}\n", each.session, each.record.why);
        sessions_.on_gone([this](const std::string& id) { grants_.forget(id); });
    }

    core::Result<Answer>
    ask(const std::string& method, const std::string& path, const std::string& body) override {
        std::optional<Answer> answer;
        HttpRequest request;
        request.method = method;
        request.path = path;
        request.body = body;
        const Respond respond = [&answer](const HttpResponse& response) {
            answer = {response.status, *response.body};
        };
        if (path == "/rpc")
            dispatcher_.dispatch(body, {}, nullptr, [&answer](std::string text) {
                answer = {200, std::move(text)};
            });
        else if (method == "POST")
            files_.post(request, {}, respond);
        else if (!files_.get(request, respond))
            answer = Answer{404, "{}"};
        while (!answer)
            context_.run_one();
        return std::move(*answer);
    }

  private:
    StoredSessions kept_;
    SystemEntropy entropy_;
    core::SteadyClock clock_;
    boost::asio::io_context context_{1};
    IoLoop loop_{context_};
    NoDatasets datasets_;
    ComputePool pool_{1};
    Prober prober_{loop_, pool_};
    std::unique_ptr<SqliteJournal> journal_; ///< null: read-only
    Grants grants_;
    SessionDirectory sessions_;
    Dispatcher dispatcher_;
    SessionFiles files_;
};

} // namespace

core::Result<std::unique_ptr<SessionServer>> sessions_in(const std::filesystem::path& folder,
                                                         bool changes) {
    std::error_code ignored;
    if (!std::filesystem::exists(folder / "sessions.sqlite", ignored))
        return fail(Error::Code::NotFound, "there are no sessions in " + folder.string(),
                    "give the folder that `wakesurf serve --state` was given");
    auto kept = StoredSessions::open(folder);
    if (!kept && kept.error().code == Error::Code::OverLimit)
        return fail(Error::Code::OverLimit, "a running server keeps its sessions in this folder",
                    "ask that server: --url with the address it printed when it started, "
                    "http://HOST:PORT/#token=...");
    if (!kept)
        return tl::unexpected(kept.error());
    return std::make_unique<StateSessions>(std::move(*kept), changes);
}

namespace {

std::string token_of(std::string_view fragment) {
    constexpr std::string_view name = "token=";
    while (!fragment.empty()) {
        const auto end = std::min(fragment.find('&'), fragment.size());
        const std::string_view word = fragment.substr(0, end);
        if (word.starts_with(name))
            return std::string(word.substr(name.size()));
        fragment.remove_prefix(std::min(end + 1, fragment.size()));
    }
    return {};
}

} // namespace

std::string ServerAddress::authority() const {
    const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
    return name + ":" + port;
}

core::Result<ServerAddress> parse_server_address(const std::string& url) {
    const auto wrong =
        core::fail(core::Error::Code::InvalidArgument, "this is not the address of a server",
                   "give the one it printed: http://HOST:PORT/#token=...");
    ServerAddress out;
    std::string_view rest = url;
    if (rest.starts_with("https://"))
        out.tls = true;
    else if (!rest.starts_with("http://"))
        return wrong;
    rest.remove_prefix(out.tls ? 8 : 7);
    const auto hash = std::min(rest.find('#'), rest.size());
    out.token = token_of(rest.substr(std::min(hash + 1, rest.size())));
    rest = rest.substr(0, hash);
    while (rest.ends_with('/'))
        rest.remove_suffix(1);
    const auto slash = std::min(rest.find('/'), rest.size());
    out.prefix = rest.substr(slash);
    rest = rest.substr(0, slash);
    const auto printable = [](char c) { return c > ' ' && c < 0x7f && c != '?'; };
    if (!std::all_of(out.prefix.begin(), out.prefix.end(), printable))
        return wrong;
    const auto bracket = rest.starts_with('[') ? rest.find(']') : 0;
    if (bracket == std::string_view::npos)
        return wrong;
    const auto colon = rest.find(':', bracket);
    out.host = rest.substr(bracket == 0 ? 0 : 1, bracket == 0 ? colon : bracket - 1);
    out.port = colon == std::string_view::npos ? (out.tls ? "443" : "80")
                                               : std::string(rest.substr(colon + 1));
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    if (out.host.empty() || out.port.empty() || out.port.size() > 5 ||
        !std::all_of(out.port.begin(), out.port.end(), digit))
        return wrong;
    return out;
}

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
