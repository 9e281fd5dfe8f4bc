// A WebSocket client that can also misbehave.
#pragma once

#include "tests/support/server/raw_socket.hpp"
#include "tests/support/server/server_process.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::tests {

/// Returns the status of an upgrade to `target`; 101 if it was granted.
HttpReply
handshake(RawSocket& socket, std::uint16_t port, Headers headers, std::string_view target = "/ws");

class WebSocketClient {
  public:
    /// Connects with the server's token, and joins `session` unless that is empty.
    explicit WebSocketClient(const ServerProcess& server, const std::string& session = "main");

    /// Connects with these headers instead of the token.
    WebSocketClient(const ServerProcess& server, const std::string& session, Headers headers);

    struct Message {
        int opcode = 0; ///< 1 text, 2 binary, 8 close; 0 when the connection has ended
        std::string payload;

        unsigned close_code() const;
    };

    void send_frame(int opcode, std::string_view payload, bool last = true);

    void send(const nlohmann::json& message) { send_frame(1, message.dump()); }

    /// Returns the next message; pings are answered on the way.
    Message receive();

    /// Returns the message that closes the connection; what came before it is passed over.
    Message closing();

    /// Sends a call; returns its whole answer. Messages before the answer are kept for `next_*`.
    nlohmann::json call(const std::string& method,
                        nlohmann::json parameters = nlohmann::json::object());

    /// Does what call() does, but returns the result and throws for an error.
    nlohmann::json result(const std::string& method,
                          nlohmann::json parameters = nlohmann::json::object());

    /// Returns the answer to the request with this id; null: to what had none that could be read.
    nlohmann::json answer(const nlohmann::json& id);

    /// Returns the next notification of a method.
    nlohmann::json notification(const std::string& method);

    /// Returns the next frame.
    std::vector<std::byte> frame();

    RawSocket& socket() { return socket_; }

    int next_id() { return ++id_; }

  private:
    template <class Kept>
    typename Kept::value_type
    take(Kept& kept, const std::function<bool(const typename Kept::value_type&)>& wanted);
    void read_one();

    RawSocket socket_;
    int id_ = 0;
    std::deque<nlohmann::json> texts_;
    std::deque<std::vector<std::byte>> frames_;
};

} // namespace wakesurf::tests
