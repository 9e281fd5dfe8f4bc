// Editors that use everything they are granted: sessions full of the largest surfaces with all fields, rakes
// that are dragged, clocks that run, downloads.
#pragma once

#include "tests/bench/live_server.hpp"

#include <atomic>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::bench {

/// Attacks from construction to destruction, each with threads and connections of its own. The threads have a
/// low priority: they stand for other machines, so their processor time must not be taken from the server.
class HostileTenants {
  public:
    /// @param sessions  each with an editor and a client that downloads
    HostileTenants(const ServerAddress& address, int sessions);
    ~HostileTenants();

    /// Returns the number of calls answered with -32014 so far, downloads with 503 among them.
    std::size_t refused() const { return refused_; }

    std::size_t downloads() const { return downloads_; }

    std::size_t edits() const { return edits_; }

  private:
    void edit(const std::stop_token& stop, int number);
    void fill_session(LiveClient& client, const std::string& session, int number);
    void download(const std::stop_token& stop, int number);

    ServerAddress address_;
    std::vector<std::atomic<int>> session_; ///< number of each; 0 before there is one
    std::atomic<std::size_t> refused_{0}, downloads_{0}, edits_{0};
    std::vector<std::jthread> threads_;
};

} // namespace wakesurf::bench
