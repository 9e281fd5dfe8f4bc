// An HTTP server on loopback that answers whatever a test wants: bytes as they are, then perhaps a cut.
#pragma once

#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::tests {

class ScriptedWebServer {
  public:
    struct Reply {
        std::string bytes;   ///< header and body
        bool cut = false;    ///< the connection ends after them
        bool silent = false; ///< nothing else comes until the server ends
    };

    /// @param answer  answers the request's header; called from any thread
    explicit ScriptedWebServer(std::function<Reply(const std::string& header)> answer);
    ~ScriptedWebServer();
    ScriptedWebServer(const ScriptedWebServer&) = delete;
    ScriptedWebServer& operator=(const ScriptedWebServer&) = delete;

    std::uint16_t port() const { return port_; }

    /// Returns http://127.0.0.1:PORT/PATH.
    std::string address(const std::string& path) const;

    /// Returns the number of connections made so far.
    std::size_t connections() const;

  private:
    void accept_all();
    void serve(int connection);

    std::function<Reply(const std::string&)> answer_;
    int listening_ = -1;
    std::uint16_t port_ = 0;
    mutable std::mutex mutex_; ///< guards what follows
    bool ending_ = false;
    std::vector<int> connections_;
    std::vector<std::thread> threads_;
    std::thread accepting_; ///< last: it uses the rest
};

} // namespace wakesurf::tests
