// The program `wakesurf` as a server process on a port of its own, and a well-behaved
// blocking client of it, for benchmarks of the whole path.
#pragma once

#include "protocol/wire/bytes.hpp"
#include "tests/support/server/server_process.hpp"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>

namespace wakesurf::bench {

struct ServerAddress {
    std::string host, port, token;
};

struct LiveServer : tests::ServerProcess {
    using ServerProcess::ServerProcess;

    ServerAddress address() const { return {"127.0.0.1", std::to_string(port()), token()}; }
};

/// A WebSocket. Every call blocks; throws std::runtime_error for an error answer or a lost connection.
class LiveClient {
  public:
    explicit LiveClient(const ServerAddress& address);
    ~LiveClient();

    /// Returns the result of a method; frames and notifications on the way are dropped.
    nlohmann::json call(const std::string& method, const nlohmann::json& parameters);

    /// Sends a call without waiting for its answer.
    void send(const std::string& method, const nlohmann::json& parameters);

    /// Returns the next frame; text on the way is dropped.
    protocol::Bytes next_frame();

    /// Ends the connection, also from another thread; pending calls then throw.
    void hang_up();

  private:
    struct Socket;
    std::unique_ptr<Socket> socket_;
    int id_ = 0;
};

} // namespace wakesurf::bench
