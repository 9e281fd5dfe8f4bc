#include "tests/support/server/websocket_client.hpp"

#include <stdexcept>

namespace wakesurf::tests {

using nlohmann::json;

HttpReply
handshake(RawSocket& socket, std::uint16_t port, Headers headers, std::string_view target) {
    std::string text =
        "GET " + std::string(target) +
        " HTTP/1.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
        "Sec-WebSocket-Protocol: wakesurf.v1\r\n";
    bool host = false;
    for (const auto& [name, value] : headers) {
        host = host || name == "Host";
        text += name + ": " + value + "\r\n";
    }
    if (!host)
        text += "Host: 127.0.0.1:" + std::to_string(port) + "\r\n";
    socket.send(text + "\r\n");
    return read_reply(socket);
}

unsigned WebSocketClient::Message::close_code() const {
    if (opcode != 8 || payload.size() < 2)
        return 0;
    return static_cast<unsigned char>(payload[0]) * 256u + static_cast<unsigned char>(payload[1]);
}

WebSocketClient::WebSocketClient(const ServerProcess& server, const std::string& session)
    : WebSocketClient(server, session, server.bearer()) {}

WebSocketClient::WebSocketClient(const ServerProcess& server,
                                 const std::string& session,
                                 Headers headers)
    : socket_(server.port()) {
    if (handshake(socket_, server.port(), std::move(headers)).status != 101)
        throw std::runtime_error("the server refused the WebSocket");
    if (!session.empty())
        result("session.join", {{"session", session}});
}

void WebSocketClient::send_frame(int opcode, std::string_view payload, bool last) {
    std::string bytes{static_cast<char>((last ? 0x80 : 0) | opcode)};
    const std::size_t size = payload.size();
    const int length_bytes = size < 126 ? 0 : size < 65536 ? 2 : 8;
    bytes += static_cast<char>(0x80 | (length_bytes == 0   ? static_cast<int>(size)
                                       : length_bytes == 2 ? 126
                                                           : 127));
    for (int i = length_bytes - 1; i >= 0; --i)
        bytes += static_cast<char>((std::uint64_t{size} >> (8 * i)) & 0xff);
    bytes += std::string(4, '\0'); // a mask of zeros changes nothing
    bytes += payload;
    socket_.send(bytes);
}

WebSocketClient::Message WebSocketClient::receive() {
    for (;;) {
        const std::string head = socket_.receive_exactly(2);
        if (head.empty())
            return {};
        Message message;
        message.opcode = head[0] & 0x0f;
        std::uint64_t size = static_cast<unsigned char>(head[1]) & 0x7f;
        if (size >= 126) {
            const std::string length = socket_.receive_exactly(size == 126 ? 2 : 8);
            size = 0;
            for (const char c : length)
                size = size << 8 | static_cast<unsigned char>(c);
        }
        if (size > 0)
            message.payload = socket_.receive_exactly(size);
        if (message.opcode != 9)
            return message;
        send_frame(10, message.payload);
    }
}

WebSocketClient::Message WebSocketClient::closing() {
    Message message = receive();
    while (message.opcode == 1 || message.opcode == 2)
        message = receive();
    return message;
}

void WebSocketClient::read_one() {
    const Message message = receive();
    if (message.opcode == 1) {
        texts_.push_back(json::parse(message.payload));
    } else if (message.opcode == 2) {
        const auto* bytes = reinterpret_cast<const std::byte*>(message.payload.data());
        frames_.emplace_back(bytes, bytes + message.payload.size());
    } else {
        throw std::runtime_error("the server closed the WebSocket: " + message.payload);
    }
}

template <class Kept>
typename Kept::value_type
WebSocketClient::take(Kept& kept,
                      const std::function<bool(const typename Kept::value_type&)>& wanted) {
    for (std::size_t seen = 0;; read_one())
        for (; seen < kept.size(); ++seen)
            if (wanted(kept[seen])) {
                auto found = std::move(kept[seen]);
                kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(seen));
                return found;
            }
}

json WebSocketClient::answer(const json& id) {
    return take(texts_, [&](const json& each) { return each.contains("id") && each["id"] == id; });
}

json WebSocketClient::notification(const std::string& method) {
    return take(texts_,
                [&](const json& each) { return each.value("method", "") == method; })["params"];
}

std::vector<std::byte> WebSocketClient::frame() {
    return take(frames_, [](const auto&) { return true; });
}

json WebSocketClient::call(const std::string& method, json parameters) {
    const int id = next_id();
    send({{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(parameters)}});
    return answer(id);
}

json WebSocketClient::result(const std::string& method, json parameters) {
    const json whole = call(method, std::move(parameters));
    if (!whole.contains("result"))
        throw std::runtime_error(method + " failed: " + whole.dump());
    return whole["result"];
}

} // namespace wakesurf::tests
