#include "tests/bench/live_server.hpp"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <nlohmann/json.hpp>
#include <sys/socket.h>

#include <stdexcept>

namespace wakesurf::bench {

namespace asio = boost::asio;
namespace beast = boost::beast;
using nlohmann::json;

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
