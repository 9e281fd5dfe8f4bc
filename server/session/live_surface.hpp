// A surface that is kept up to date: newest edit wins. An edit bumps the epoch, stops the running job and leaves at
// most one next job; a finished state goes to the subscribers and to whoever waits for it.
#pragma once

#include "server/session/compute_pool.hpp"
#include "server/session/loop.hpp"
#include "server/session/observer.hpp"
#include "server/session/surface_job.hpp"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Loop thread only. Held by shared_ptr because a job's result finds its way back through a weak one.
class LiveSurface : public std::enable_shared_from_this<LiveSurface> {
  public:
    struct Events {
        std::function<void(std::uint32_t epoch, bool final)> progress;
        std::function<void(const SurfaceOutcome&)> done;
    };

    using Waiter = std::function<void(core::Result<SurfaceOutcome>)>;

    LiveSurface(std::string id, std::uint32_t number, Loop& loop, ComputePool& pool, Events events);
    ~LiveSurface();
    LiveSurface(const LiveSurface&) = delete;
    LiveSurface& operator=(const LiveSurface&) = delete;

    /// Makes `wanted` (whose number, epoch and coarse budget are filled in here) the surface to build; returns its epoch.
    std::uint32_t rebuild(SurfaceJob wanted);

    /// There is nothing to build just now: an epoch whose outcome is `error`, told from the loop. Returns the epoch.
    std::uint32_t refuse(core::SurfaceKind kind, core::Error error);

    /// Epochs will be above `epoch`, for a surface that has been before. Call it before the first is built.
    void continue_after(std::uint32_t epoch) { epoch_ = epoch; }

    /// True while the wanted surface is not built yet.
    bool busy() const { return running_ || !started_; }

    /// The same data, opened again: lets go of the old one's time-steps.
    void renew_flow(std::shared_ptr<const core::Flow> flow) { wanted_.flow = std::move(flow); }

    /// Stops computing and answers everybody who waits with NotFound.
    void retire();

    std::uint32_t number() const { return number_; }

    std::uint32_t epoch() const { return epoch_; }

    const SurfaceJob& wanted() const { return wanted_; }

    SurfaceOutcome outcome() const;

    /// The newest state, if it is of the current epoch.
    std::shared_ptr<const SurfaceState> state() const { return state_; }

    void subscribe(FrameSink& sink);
    void unsubscribe(FrameSink& sink);
    bool subscribed(const FrameSink& sink) const;

    /// Calls back once `epoch` or a later one is final or has failed, or with complete == false after `patience`.
    /// Error: OverLimit for too many waiters; what the computation failed with; NotFound when the surface goes.
    /// Returns a ticket for forget(), which lets go of the waiter without calling it.
    std::uint64_t wait(std::uint32_t epoch, std::chrono::milliseconds patience, Waiter waiter);
    void forget(std::uint64_t ticket);

  private:
    struct Waiting {
        std::uint64_t id;
        std::uint32_t epoch;
        Waiter answer;
        std::shared_ptr<void> timer;
    };

    void start();
    void published(std::uint32_t epoch, core::Result<SurfaceState> result);
    void finished(double cut_short);
    void settle();
    void give_up(std::uint64_t waiter);
    void learn(const SurfaceState& state);
    void aim(double coarse_seconds);

    std::string id_;
    std::uint32_t number_;
    Loop& loop_;
    ComputePool& pool_;
    Events events_;

    std::uint32_t epoch_ = 0;
    SurfaceJob wanted_;
    bool started_ = true; ///< the wanted job has been given to the pool
    bool running_ = false;
    std::stop_source stop_{std::nostopstate};
    std::shared_ptr<const SurfaceState> state_;
    std::optional<core::Error> error_;
    double coarse_quads_ = 1000;
    double final_seconds_ = 1.0; ///< of the newest final pass; pessimistic before the first

    std::vector<FrameSink*> sinks_;
    std::vector<Waiting> waiting_;
    std::uint64_t next_waiter_ = 1;
};

} // namespace wakesurf::server
