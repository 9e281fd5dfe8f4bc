// A world of its own: virtual time, one queue of events, one source of chance. The same seed makes the same
// world, step for step, so that a run that fails can be replayed. After FoundationDB's and TigerBeetle's
// simulations (docs/measurements.md).
#pragma once

#include "core/base/clock.hpp"
#include "server/base/loop.hpp"
#include "server/base/secret.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <span>
#include <utility>

namespace wakesurf::simulation {

using Duration = std::chrono::microseconds;
using Instant = std::chrono::steady_clock::time_point;

/// The clock and the events. One thread at a time.
class World final : public core::Clock {
  public:
    explicit World(std::uint64_t seed) : random_(seed) {}

    Instant now() const override { return now_; }

    /// Runs `task` after `delay`; tasks due at the same time run in the order of the calls.
    void after(Duration delay, std::function<void()> task) {
        events_.emplace(std::pair(now_ + delay, next_++), std::move(task));
    }

    /// Lets time pass until `end`.
    void run_until(Instant end) {
        while (!events_.empty() && events_.begin()->first.first <= end) {
            auto event = events_.extract(events_.begin());
            now_ = event.key().first;
            note(static_cast<std::uint64_t>(now_.time_since_epoch().count()));
            event.mapped()();
        }
        now_ = end;
    }

    void run_for(Duration time) { run_until(now_ + time); }

    /// Returns a digest of the times of all events, and of all notes.
    std::uint64_t digest() const { return digest_; }

    void note(std::uint64_t value) {
        digest_ = (digest_ ^ value) * 0x9e3779b97f4a7c15u + (digest_ >> 29);
    }

    /// Returns a whole number from 0 to `below` - 1.
    std::uint64_t pick(std::uint64_t below) { return random_() % below; }

    bool chance(double part) { return static_cast<double>(random_() >> 11) * 0x1p-53 < part; }

    double between(double lo, double hi) {
        return lo + (hi - lo) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }

    Duration time_between(Duration lo, Duration hi) {
        return lo + Duration(pick(static_cast<std::uint64_t>((hi - lo).count()) + 1));
    }

  private:
    Instant now_{};
    std::uint64_t next_ = 0;
    std::uint64_t digest_ = 0;
    std::map<std::pair<Instant, std::uint64_t>, std::function<void()>> events_;
    std::mt19937_64 random_;
};

/// The server's loop in a world. Tasks posted to a loop that has ended never run: its server has crashed.
class WorldLoop final : public server::Loop {
  public:
    /// @param rested  called after each task
    WorldLoop(World& world, std::function<void()> rested)
        : world_(world), rested_(std::move(rested)) {}

    /// Runs tasks in the order of posting, a moment later.
    void post(std::function<void()> task) override {
        posted_until_ = std::max(posted_until_, world_.now() + Duration(world_.pick(200)));
        later(std::chrono::duration_cast<Duration>(posted_until_ - world_.now()), std::move(task));
    }

    std::shared_ptr<void> after(std::chrono::milliseconds delay,
                                std::function<void()> task) override {
        auto ticket = std::make_shared<std::function<void()>>(std::move(task));
        later(delay, [weak = std::weak_ptr(ticket)] {
            if (const auto due = weak.lock())
                (*due)();
        });
        return ticket;
    }

  private:
    void later(Duration delay, std::function<void()> task) {
        world_.after(delay, [this, alive = std::weak_ptr(alive_), task = std::move(task)] {
            if (alive.expired())
                return;
            task();
            rested_();
        });
    }

    World& world_;
    std::function<void()> rested_;
    Instant posted_until_{};
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

class WorldEntropy final : public server::Entropy {
  public:
    explicit WorldEntropy(World& world) : world_(world) {}

    void fill(std::span<std::byte> out) override {
        for (std::byte& each : out)
            each = static_cast<std::byte>(world_.pick(256));
    }

  private:
    World& world_;
};

} // namespace wakesurf::simulation
