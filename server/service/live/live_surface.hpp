// A surface that is kept up to date: the newest edit wins. An edit raises the epoch, stops the running job and leaves at
// most one next job; what passes return goes into a ring that subscribers read. A moving surface follows the session's
// clock: when computing is slower than the clock, times are left out, never queued.
#pragma once

#include "server/service/base/loop.hpp"
#include "server/service/compute/compute_pool.hpp"
#include "server/service/compute/pass_budgets.hpp"
#include "server/service/live/build_progress.hpp"
#include "server/service/live/frame_cursor.hpp"
#include "server/service/live/surface_build.hpp"
#include "server/service/live/surface_job.hpp"
#include "server/service/live/surface_stage.hpp"
#include "server/service/live/surface_waiters.hpp"
#include "server/service/live/told_ranges.hpp"
#include "server/service/live/update_ring.hpp"
#include "server/service/session/data/datasets.hpp"
#include "server/service/session/records/observer.hpp"

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

namespace wakesurf::server {

class Metrics;

/// Loop thread only. Held by shared_ptr because a job's result finds its way back through a weak one.
class LiveSurface : public std::enable_shared_from_this<LiveSurface> {
  public:
    struct Events {
        std::function<void(const SurfaceProgress&)> progress;
        std::function<void(const SurfaceOutcome&)> done;
        std::function<void(const SurfaceRanges&)> ranges; ///< may be empty
    };

    /// What it runs on. All outlive it.
    struct Services {
        Loop& loop;
        ComputePool& pool;
        const core::Clock& clock;
        Metrics* metrics; ///< may be null
        SurfaceBuild::Memory memory{};
    };

    using Waiter = SurfaceWaiters::Waiter;

    /// @param session  takes turns with others in the pool
    LiveSurface(std::string id,
                std::uint32_t number,
                std::string session,
                Services services,
                Events events);
    ~LiveSurface();
    LiveSurface(const LiveSurface&) = delete;
    LiveSurface& operator=(const LiveSurface&) = delete;

    /// Makes `wanted` (whose number and epoch are filled in here) the surface to build; returns its epoch.
    /// @param rest  nothing is built until somebody looks at it or waits
    std::uint32_t rebuild(SurfaceJob wanted, bool rest = false);

    /// Somebody looks at it: if it rests, or there was no memory for it the last time, it is built.
    void begin_now();

    /// Falls back to its parameters, and rests: what it takes is free once the running job has ended. What it was is still told. Built
    /// again, it is the same, bit by bit.
    void fall_back();

    /// No one is there: falls back, and stops what is being computed; unless somebody looks at it after all.
    void put_to_rest();

    /// Somebody is there again: what put_to_rest() stopped is computed again.
    void resume();

    /// Somebody does not show it any more. If no one else does either, it is not computed for as long as that lasts, neither for edits nor
    /// for the clock; what is there stays. Whoever subscribes or waits has it computed. One that no one ever showed is computed always.
    void turned_away();

    /// Nothing of it is built or being built.
    bool resting() const { return rests(stage_); }

    /// Somebody has it on the screen, or waits for it.
    bool looked_at() const { return ring_->read() || !waiters_->empty(); }

    /// When somebody last asked for it.
    std::chrono::steady_clock::time_point asked_for() const { return asked_for_; }

    /// There is nothing to build just now: an epoch whose outcome is `error`, told from the loop. Returns the epoch.
    /// @param rest  no one has asked for it yet
    std::uint32_t refuse(core::SurfaceKind kind, core::Error error, bool rest = false);

    /// Computes no further; what is there by now stays, and `reason` (Cancelled) is the outcome until it is rebuilt. False when
    /// nothing was under way.
    bool stop(core::Error reason);

    /// Epochs will be above `epoch`, for a surface that has been before. Call it before the first is built.
    void continue_after(std::uint32_t epoch) { epoch_ = epoch; }

    /// The time of the session's clock; nothing: never set. Surfaces that do not move ignore it.
    /// @param jumped  somebody chose this time: a job for another one that is long at work is given up
    void show(std::optional<double> time, bool playing, bool jumped);

    /// True while the wanted surface is not built yet.
    bool busy() const;

    /// The same data, opened again: lets go of the old one's time-steps.
    void renew_data(const OpenDataset& data) {
        wanted_.plan.flow = data.flow;
        wanted_.plan.levels = data.levels;
        wanted_.store = data.store;
        wanted_.scalars = data.scalars;
    }

    /// Stops computing and answers everybody who waits with NotFound.
    void retire();

    std::uint32_t number() const { return number_; }

    std::uint32_t epoch() const { return epoch_; }

    const SurfaceJob& wanted() const { return wanted_; }

    SurfaceOutcome outcome() const;

    /// How far it is on the way to being complete.
    BuildStanding standing() const;

    /// The pass that the newest state comes from, if that is an early one: what was asked for is not there yet.
    std::optional<SurfacePass> early() const;

    /// What its values range over since it began to play, as last told.
    const ValueRanges& ranges() const { return ranges_.told(); }

    /// The newest state, if there is one of the current epoch.
    SharedUpdate newest() const { return ring_->newest(); }

    /// What subscribers read.
    const std::shared_ptr<UpdateRing>& ring() const { return ring_; }

    /// Calls back once `epoch` or a later one is final at the clock's time, or has failed, or with complete == false after
    /// `patience`. While the clock runs the first state of full quality will do.
    /// Error: OverLimit for too many waiters; what the computation failed with; NotFound when the surface goes.
    /// Returns a ticket for forget(), which lets go of the waiter without calling it.
    std::uint64_t wait(std::uint32_t epoch, std::chrono::milliseconds patience, Waiter waiter);
    void forget(std::uint64_t ticket);

  private:
    struct Running {
        std::uint32_t epoch;
        SurfacePass pass;
        std::stop_source stop;
        std::chrono::steady_clock::time_point since;
        std::chrono::steady_clock::time_point wanted; ///< before it could be given to the pool
        std::shared_ptr<core::WorkDone> work;
        std::weak_ptr<SurfaceBuild> build;
    };

    /// What it was before it fell back, told until it is built again or its time changes.
    struct Fallen {
        SurfaceOutcome outcome;
        std::optional<double> time; ///< of the session's clock
    };

    /// One a pace: the coarse pass of an edit does not wait for the long one that it ends.
    std::array<std::optional<Running>, 2> lanes_;

    bool running() const; ///< a job of the current epoch
    bool unseen() const;  ///< hidden by all
    void advance();
    std::optional<SurfacePass> next_pass() const;
    Pace pace(const SurfacePass& pass) const;
    void start(Pace pace, const SurfacePass& pass);
    void finished(Pace pace, core::Result<Update> result, double seconds);
    void publish(const SurfacePass& pass, Update update);
    void failed(const SurfacePass& pass, core::Error error, double seconds);
    void conclude();
    void begin_epoch();
    void begin_build();
    void let_go_of_build();
    void stop_jobs();
    void give_up_stale();
    void encode_key();
    double finest() const;
    double seconds_since(std::chrono::steady_clock::time_point time) const;

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
    std::uint32_t next_seq_ = 0; ///< of the epoch: above all updates that were given out
    std::chrono::steady_clock::time_point asked_for_{};
    std::optional<std::chrono::steady_clock::time_point> turned_away_; ///< by the last one who did
    SurfaceJob wanted_;
    std::optional<core::Error> error_;
    std::optional<double> time_; ///< of the session's clock
    bool playing_ = false;
    std::chrono::steady_clock::time_point jumped_{}; ///< when somebody chose the time

    // Of the current epoch.
    std::chrono::steady_clock::time_point began_{};
    std::chrono::steady_clock::time_point pass_wanted_{}; ///< the one that is next or runs
    std::shared_ptr<SurfaceBuild> build_;
    std::optional<SurfacePass> shown_; ///< the pass that the newest state comes from

    BuildProgress progress_;
    ToldRanges ranges_; ///< of this epoch and those before that it plays on from

    PassBudgets budgets_{true};
    std::shared_ptr<void> trim_, overtake_, hide_; ///< timers
};

} // namespace wakesurf::server
