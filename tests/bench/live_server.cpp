#include "tests/bench/live_server.hpp"

#include "server/service/base/shipped_files.hpp"
#include "server/service/catalogue/child_process.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <nlohmann/json.hpp>
#include <sys/socket.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace wakesurf::bench {

namespace asio = boost::asio;
namespace beast = boost::beast;
using nlohmann::json;

namespace {

/// `wakesurf: http://HOST:PORT/#token=TOKEN`
ServerAddress parse_first_line(std::string_view line) {
    const std::size_t scheme = line.find("http://");
    const std::size_t slash = line.find("/#token=");
    if (scheme == std::string_view::npos || slash == std::string_view::npos)
        throw std::runtime_error("the server's first line has no address");
    const std::string_view authority = line.substr(scheme + 7, slash - scheme - 7);
    const std::size_t colon = authority.rfind(':');
    return {std::string(authority.substr(0, colon)), std::string(authority.substr(colon + 1)),
            std::string(line.substr(slash + 8)), std::string(line.substr(scheme))};
}

/// The newest child of this process.
pid_t newest_child() {
    pid_t newest = -1;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream children(task.path() / "children");
        for (pid_t child = -1; children >> child;)
            newest = std::max(newest, child);
    }
    return newest;
}

} // namespace

LiveServer::LiveServer(const std::string& dataset)
    : LiveServer({dataset}, {}, [](const auto& program) {
          return std::vector<std::string>{program.string()};
      }) {}

LiveServer::LiveServer(const std::vector<std::string>& datasets,
                       const std::vector<std::string>& arguments,
                       const Launch& launch) {
    const auto promise = std::make_shared<std::promise<ServerAddress>>();
    std::future<ServerAddress> ready = promise->get_future();
    std::vector<std::string> command = launch(server::this_program().parent_path() / "wakesurf");
    command.emplace_back("serve");
    command.insert(command.end(), datasets.begin(), datasets.end());
    command.insert(command.end(), {"--listen", "127.0.0.1:0", "--log-level", "error"});
    command.insert(command.end(), arguments.begin(), arguments.end());
    process_ = std::jthread([promise, command](const std::stop_token& stop) {
        bool first = true;
        const auto line = [&](std::string_view text) {
            if (std::exchange(first, false))
                promise->set_value(parse_first_line(text));
        };
        const auto outcome =
            server::run_child(command.front(), {command.begin() + 1, command.end()}, 0, line, stop);
        if (first)
            promise->set_exception(std::make_exception_ptr(
                std::runtime_error(outcome ? outcome->errors : outcome.error().message)));
    });
    address_ = ready.get();
    pid_ = newest_child();
}

struct LiveClient::Socket {
    asio::io_context context;
    beast::websocket::stream<asio::ip::tcp::socket> stream{context};

    /// Text as a string, frames left in `frame`.
    bool read(std::string& text, protocol::Bytes& frame) {
        beast::flat_buffer buffer;
        stream.read(buffer);
        if (stream.got_text()) {
            text = beast::buffers_to_string(buffer.data());
            return true;
        }
        const auto* first = static_cast<const std::byte*>(buffer.data().data());
        frame.assign(first, first + buffer.size());
        return false;
    }
};

LiveClient::LiveClient(const ServerAddress& address) : socket_(std::make_unique<Socket>()) {
    asio::ip::tcp::resolver resolver(socket_->context);
    asio::connect(socket_->stream.next_layer(), resolver.resolve(address.host, address.port));
    socket_->stream.next_layer().set_option(asio::ip::tcp::no_delay(true));
    socket_->stream.read_message_max(64u << 20);
    const std::string bearer = "Bearer " + address.token;
    socket_->stream.set_option(
        beast::websocket::stream_base::decorator([bearer](beast::websocket::request_type& request) {
            request.set(beast::http::field::authorization, bearer);
            request.set(beast::http::field::sec_websocket_protocol, "wakesurf.v1");
        }));
    socket_->stream.handshake(address.host + ":" + address.port, "/ws");
}

LiveClient::~LiveClient() = default;

void LiveClient::send(const std::string& method, const json& parameters) {
    socket_->stream.text(true);
    const json message{
        {"jsonrpc", "2.0"}, {"id", ++id_}, {"method", method}, {"params", parameters}};
    socket_->stream.write(asio::buffer(message.dump()));
}

json LiveClient::call(const std::string& method, const json& parameters) {
    send(method, parameters);
    std::string text;
    protocol::Bytes dropped;
    for (;;) {
        if (!socket_->read(text, dropped))
            continue;
        json message = json::parse(text);
        if (message.value("id", 0) != id_)
            continue;
        if (message.contains("error"))
            throw std::runtime_error(method + ": " +
                                     message["error"]["message"].get<std::string>());
        return message["result"];
    }
}

void LiveClient::hang_up() {
    ::shutdown(socket_->stream.next_layer().native_handle(), SHUT_RDWR);
}

protocol::Bytes LiveClient::next_frame() {
    std::string dropped;
    protocol::Bytes frame;
    while (socket_->read(dropped, frame)) {
    }
    return frame;
}

} // namespace wakesurf::bench
