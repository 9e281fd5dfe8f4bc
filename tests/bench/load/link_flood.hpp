// A client with one share link at its worst: as many sockets as it can get, each sending edits that are
// refused as fast as the server takes them, and downloads in a loop.
#pragma once

#include "tests/bench/live_server.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace wakesurf::bench {

struct FloodOptions {
    std::size_t sockets = 2048;
    std::size_t downloads = 16;
    std::string mesh; ///< path of the file to download
};

struct FloodCounts {
    std::size_t let_in = 0;      ///< sockets that are open now
    std::size_t turned_away = 0; ///< handshakes that were refused
    std::size_t edits = 0;       ///< sent
    std::size_t downloaded = 0;
    std::size_t not_downloaded = 0;
};

/// Runs on a thread of its own, at a low priority, so that it takes no processor time from the server.
class LinkFlood {
  public:
    /// @param address  with the key of the link for a token
    LinkFlood(ServerAddress address, FloodOptions options);
    ~LinkFlood();
    LinkFlood(const LinkFlood&) = delete;
    LinkFlood& operator=(const LinkFlood&) = delete;

    FloodCounts counts() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::bench
