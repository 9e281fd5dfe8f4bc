// The program `wakesurf` beside this one as a server process on a port of its own, and a well-behaved
// blocking client of it, for benchmarks of the whole path.
#pragma once

#include "protocol/wire/bytes.hpp"

#include <nlohmann/json_fwd.hpp>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::bench {

struct ServerAddress {
    std::string host, port, token;
    std::string url; ///< as a browser opens it
};

/// Serves one dataset until destroyed. Throws std::runtime_error if the process ends instead of serving.
class LiveServer {
  public:
    explicit LiveServer(const std::string& dataset);

    /// Returns the words that start a program: its path, or another program that becomes it.
    using Launch = std::function<std::vector<std::string>(const std::filesystem::path& program)>;

    /// Serves several datasets, with further arguments.
    LiveServer(const std::vector<std::string>& datasets,
               const std::vector<std::string>& arguments,
               const Launch& launch);

    const ServerAddress& address() const { return address_; }

    pid_t process() const { return pid_; }

  private:
    ServerAddress address_;
    pid_t pid_ = -1;
    std::jthread process_;
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
