// A surface that is kept up to date: the newest edit wins. An edit raises the epoch, stops the running job
// and leaves at most one next job; results of passes go into a ring that subscribers read. A moving surface
// follows the session's clock: when computing is slower than the clock, times are left out, never queued.
#pragma once

#include "server/base/loop.hpp"
#include "server/data/datasets.hpp"
#include "server/live/announced_ranges.hpp"
#include "server/live/build_progress.hpp"
#include "server/live/compute/compute_pool.hpp"
#include "server/live/compute/pass_budgets.hpp"
#include "server/live/frame_cursor.hpp"
#include "server/live/surface_build.hpp"
#include "server/live/surface_events.hpp"
#include "server/live/surface_job.hpp"
#include "server/live/surface_stage.hpp"
#include "server/live/surface_waiters.hpp"
#include "server/live/update_ring.hpp"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::server {

class Metrics;

/// Computes one surface. Loop thread only. Owned by shared_ptr because a job's result is delivered through a
/// weak one.
class LiveSurface : public std::enable_shared_from_this<LiveSurface> {
  public:
    struct Events {
        std::function<void(const SurfaceProgress&)> progress;
        std::function<void(const SurfaceOutcome&)> done;
        std::function<void(const SurfaceRanges&)> ranges{}; ///< may be empty
    };

    /// Refers to the parts of the server that it uses, which outlive it.
    struct Services {
        Loop& loop;
        ComputePool& pool;
        const core::Clock& clock;
        Metrics* metrics; ///< may be null
        SurfaceBuild::Memory memory{};
    };

    using Waiter = SurfaceWaiters::Waiter;

    /// @param session  the key for taking turns in the pool
    LiveSurface(std::string id,
                std::uint32_t number,
                std::string session,
                Services services,
                Events events);
    ~LiveSurface();
    LiveSurface(const LiveSurface&) = delete;
    LiveSurface& operator=(const LiveSurface&) = delete;

    /// Makes `wanted` (whose number and epoch are filled in here) the surface to build; returns its epoch.
    /// @param rest  suspended until a client shows it or waits for it
    std::uint32_t rebuild(SurfaceJob wanted, bool rest = false);

    /// Builds it for a client that shows it, if it is suspended or had no memory the last time.
    void begin_now();

    /// Suspends it to its parameters: its memory is free once the running job has ended. Its outcome is still
    /// reported. Built again, it has the same bits.
    void fall_back();

    /// Suspends it and stops its computation, for an empty session; does nothing if it is still shown.
    void put_to_rest();

    /// Continues the computation that put_to_rest() stopped.
    void resume();

    /// Records that a client has stopped showing it. If no client shows it, it is computed neither for edits
    /// nor for the clock; its state stays. A client that subscribes or waits restarts it. A surface that was
    /// never shown is always computed.
    void turned_away();

    /// Says that it is suspended: neither built nor being built.
    bool resting() const { return rests(stage_); }

    /// Says whether a client shows it or waits for it.
    bool has_viewers() const { return ring_->read() || !waiters_->empty(); }

    /// Returns the time of the last request for it.
    std::chrono::steady_clock::time_point asked_for() const { return asked_for_; }

    /// Begins an epoch that cannot be built now: its outcome is `error`, reported from the loop. Returns the
    /// epoch.
    /// @param rest  no client has asked for it yet
    std::uint32_t refuse(core::SurfaceKind kind, core::Error error, bool rest = false);

    /// Stops computing; the present state stays, and `reason` (Cancelled) is the outcome until it is rebuilt.
    /// Returns false if nothing was being computed.
    bool stop(core::Error reason);

    /// Makes epochs begin above `epoch`, for a restored surface. Call it before the first build.
    void continue_after(std::uint32_t epoch) { epoch_ = epoch; }

    /// Sets the time of the session's clock; empty: never set. Surfaces that do not move ignore it.
    /// @param jumped  a user chose this time: a long job for another time is cancelled
    void show(std::optional<double> time, bool playing, bool jumped);

    /// Says whether the wanted surface is not complete yet.
    bool busy() const;

    /// Takes the same data, opened again, and releases the time-steps of the old.
    void renew_data(const OpenDataset& data) {
        wanted_.plan.flow = data.flow;
        wanted_.plan.levels = data.levels;
        wanted_.store = data.store;
        wanted_.scalars = data.scalars;
    }

    /// Stops computing and answers all waiters with NotFound.
    void retire();

    std::uint32_t number() const { return number_; }

    std::uint32_t epoch() const { return epoch_; }

    const SurfaceJob& wanted() const { return wanted_; }

    SurfaceOutcome outcome() const;

    /// Returns the progress towards the complete state.
    BuildStatus status() const;

    /// Returns the pass of the newest state if that is an early one.
    std::optional<SurfacePass> early() const;

    /// Returns the ranges of its values since it began to play, as last reported.
    const ValueRanges& ranges() const { return ranges_.announced(); }

    /// Returns the newest state of the current epoch; null without one.
    SharedUpdate newest() const { return ring_->newest(); }

    /// Returns the ring that subscribers read.
    const std::shared_ptr<UpdateRing>& ring() const { return ring_; }

    /// Calls back once `epoch` or a later one is final at the clock's time, or has failed, or with complete
    /// == false after `patience`. While the clock runs the first state of full quality suffices. Error:
    /// OverLimit for too many waiters; that of the computation; NotFound when the surface is deleted. Returns
    /// a ticket for forget(), which releases the waiter without calling it.
    /// @param checked  waits too until its error between stored times is estimated and its twin is compared
    std::uint64_t wait(std::uint32_t epoch,
                       std::chrono::milliseconds patience,
                       Waiter waiter,
                       bool checked = false);
    void forget(std::uint64_t ticket);

  private:
    struct Running {
        std::uint32_t epoch;
        SurfacePass pass;
        std::stop_source stop;
        std::chrono::steady_clock::time_point since;
        std::chrono::steady_clock::time_point wanted; ///< before the pool accepted it
        std::shared_ptr<core::WorkDone> work;
        std::weak_ptr<SurfaceBuild> build;
    };

    /// Holds its outcome before it was suspended, reported until it is built again or its time changes.
    struct Fallen {
        SurfaceOutcome outcome;
        std::optional<double> time; ///< of the session's clock
    };

    /// The running jobs, one a priority class: the coarse pass of an edit does not wait for the long one
    /// that it ends.
    std::array<std::optional<Running>, 2> running_;

    bool running() const;   ///< a job of the current epoch
    bool computing() const; ///< a job of the current epoch that leads to another state
    bool unseen() const;    ///< hidden by all
    void advance();
    std::optional<SurfacePass> next_pass() const;
    std::optional<SurfacePass> checking_pass() const;
    PriorityClass priority_of(const SurfacePass& pass) const;
    void start(PriorityClass priority, const SurfacePass& pass);
    void finished(PriorityClass priority, core::Result<Update> result, double seconds);
    void publish(const SurfacePass& pass, Update update);
    void failed(const SurfacePass& pass, core::Error error, double seconds);
    void conclude();
    void begin_epoch();
    void begin_build();
    void release_build();
    void stop_jobs();
    void give_up_stale();
    void encode_key();
    double finest() const;

    double seconds_since(std::chrono::steady_clock::time_point time) const {
        return std::chrono::duration<double>(services_.clock.now() - time).count();
    }

    std::string id_;
    std::uint32_t number_;
    std::string session_;
    Services services_;
    Events events_;
    std::shared_ptr<UpdateRing> ring_;
    std::shared_ptr<SurfaceWaiters> waiters_;

    std::uint32_t epoch_ = 0;
    SurfaceStage stage_ = SurfaceStage::Refused;
    std::optional<Fallen> fallen_;
    std::uint32_t next_seq_ = 0; ///< of the epoch: above all published updates
    std::chrono::steady_clock::time_point asked_for_{};
    /// The time at which the last client stopped showing it.
    std::optional<std::chrono::steady_clock::time_point> turned_away_;
    SurfaceJob wanted_;
    std::optional<core::Error> error_;
    std::optional<double> time_; ///< of the session's clock
    bool playing_ = false;
    /// The time at which a user chose the clock's time.
    std::chrono::steady_clock::time_point jumped_{};

    // The members below are of the current epoch.
    std::chrono::steady_clock::time_point began_{};
    std::chrono::steady_clock::time_point pass_wanted_{}; ///< of the pass that is next or runs
    std::shared_ptr<SurfaceBuild> build_;
    /// The pass of the newest state.
    std::optional<SurfacePass> shown_;

    BuildProgress progress_;
    AnnouncedRanges ranges_; ///< of this epoch and those before that it continues

    PassBudgets budgets_{true};
    std::shared_ptr<void> trim_, overtake_, hide_; ///< timers
};

} // namespace wakesurf::server
