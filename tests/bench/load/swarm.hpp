// Many viewers of one surface on one thread: each a WebSocket that joins a session, subscribes, and records
// when updates of the surface arrive.
#pragma once

#include "tests/bench/live_server.hpp"

#include <nlohmann/json_fwd.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::bench {

struct SwarmTarget {
    std::string session, surface;
};

/// The behaviour of a viewer.
struct ViewerHabits {
    std::size_t bytes_per_second = 0; ///< it reads at most; 0: all there is
    bool stalled = false;             ///< reads nothing once it has subscribed
};

/// A whole state of the surface that has arrived at a viewer.
struct Arrival {
    std::uint32_t viewer;
    std::uint32_t epoch;
    std::chrono::steady_clock::time_point at;
};

/// Runs on a thread of its own. Calls throw std::runtime_error if the server refuses or takes longer than a
/// minute.
class Swarm {
  public:
    Swarm(ServerAddress address, SwarmTarget target);
    ~Swarm();
    Swarm(const Swarm&) = delete;
    Swarm& operator=(const Swarm&) = delete;

    /// Connects `count` more viewers, at most 64 at a time, and waits until all have joined and subscribed.
    void connect(std::size_t count, ViewerHabits habits = {});

    /// Connects `count` clients that do nothing but stay.
    void connect_idle(std::size_t count);

    /// Cuts every connection without a goodbye and lets all come back at once with their resume tokens.
    /// Returns the seconds until the last one has joined and holds a whole state again.
    double storm();

    /// Sends a call through a viewer's connection and does not wait for its answer.
    void send(std::size_t viewer, const std::string& method, const nlohmann::json& parameters);

    /// Returns the arrivals since the last call.
    std::vector<Arrival> take_arrivals();

    /// Returns the bytes of all frames since the last call.
    std::size_t take_bytes();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::bench
