// A TCP proxy that makes loopback behave like a distant or bad line: delay, limited rate, stalls, cuts. `tc
// netem` is not in every kernel, and a browser's own throttling does not reach WebSockets
// (docs/measurements.md, Broken networks).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace wakesurf::tests {

struct LineQuality {
    std::chrono::milliseconds delay{0}; ///< each way
    std::size_t bytes_per_second = 0;   ///< towards the client; 0: unlimited
};

/// Runs on a thread of its own; its destructor cuts everything. Thread-safe.
class DelayingProxy {
  public:
    /// Listens on a free loopback port and connects every client to 127.0.0.1:`target`.
    DelayingProxy(std::uint16_t target, LineQuality quality);
    ~DelayingProxy();
    DelayingProxy(const DelayingProxy&) = delete;
    DelayingProxy& operator=(const DelayingProxy&) = delete;

    std::uint16_t port() const;

    /// Ends every connection with a reset. New ones are accepted.
    void cut();

    /// Stops all traffic without closing connections, until called with false.
    void stall(bool stalled);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace wakesurf::tests
