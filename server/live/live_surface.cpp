#include "server/live/live_surface.hpp"

#include "core/surface/playback/surface_at.hpp"
#include "server/base/limits.hpp"
#include "server/base/metrics.hpp"
#include "server/live/update_ring.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace wakesurf::server {

namespace {

/// A job for an obsolete time is cancelled only after this time of work: scrubbing shows intermediate states.
constexpr std::chrono::milliseconds patience_with_stale{150};
/// A key of so many vertices is encoded within some 15 ms.
constexpr std::size_t quick_key = 30'000;

bool is_early(const SurfacePass& pass) {
    return pass.phase == Phase::Coarse || pass.phase == Phase::Refined;
}

std::size_t index(PriorityClass priority) {
    return priority == PriorityClass::Quick ? 0 : 1;
}

} // namespace

LiveSurface::LiveSurface(
    std::string id, std::uint32_t number, std::string session, Services services, Events events)
    : id_(std::move(id)), number_(number), session_(std::move(session)), services_(services),
      events_(std::move(events)),
      ring_(std::make_shared<UpdateRing>(number, services.clock, [this] { encode_key(); })),
      waiters_(std::make_shared<SurfaceWaiters>(services.loop)) {}

LiveSurface::~LiveSurface() {
    stop_jobs();
    ring_->close();
    release_build();
}

/// A build may hold hundreds of megabytes, or be in use by another thread that wants memory.
void LiveSurface::release_build() {
    services_.pool.release(std::exchange(build_, nullptr));
}

void LiveSurface::stop_jobs() {
    for (auto& each : running_)
        if (each)
            each->stop.request_stop();
}

void LiveSurface::begin_epoch() {
    stop_jobs();
    ++epoch_;
    fallen_.reset();
    error_.reset();
    begin_build();
    next_seq_ = 0;
}

/// Begins the epoch's build with its first pass. Published updates are forgotten, and later ones have higher
/// numbers.
void LiveSurface::begin_build() {
    if (const SharedUpdate newest = ring_->newest())
        next_seq_ = newest->wire.seq + 1;
    ring_->begin(epoch_);
    release_build();
    shown_.reset();
    overtake_.reset();
    began_ = pass_wanted_ = asked_for_ = services_.clock.now();
    progress_.begin(began_);
}

std::uint32_t LiveSurface::rebuild(SurfaceJob wanted, bool rest) {
    begin_epoch();
    if (wanted.plan.parameters.kind != wanted_.plan.parameters.kind || !wanted_.plan.flow)
        budgets_ = PassBudgets(!core::moves(wanted.plan.parameters));
    else if (wanted.plan.parameters != wanted_.plan.parameters)
        budgets_.forget();
    if (!plays_on(wanted_, wanted))
        ranges_.begin();
    wanted_ = std::move(wanted);
    wanted_.number = number_;
    wanted_.epoch = epoch_;
    stage_ = rest ? SurfaceStage::Resting : SurfaceStage::Begun;
    advance();
    return epoch_;
}

void LiveSurface::begin_now() {
    asked_for_ = services_.clock.now();
    if (ring_->read())
        turned_away_.reset();
    const bool no_memory =
        stage_ == SurfaceStage::Failed && error_->code == core::Error::Code::OverLimit;
    if (stage_ == SurfaceStage::Withheld)
        stage_ = SurfaceStage::Refused;
    if (resting() || no_memory) {
        fallen_.reset();
        error_.reset();
        begin_build();
        stage_ = SurfaceStage::Begun;
    }
    advance(); // it may have been hidden
}

void LiveSurface::fall_back() {
    if (stage_ < SurfaceStage::Begun)
        return;
    fallen_ = {outcome(), time_};
    fallen_->outcome.checks_pending = false;
    stop_jobs();
    begin_build();
    stage_ = SurfaceStage::Resting;
}

void LiveSurface::put_to_rest() {
    if (has_viewers())
        return;
    const bool interrupted = stage_ >= SurfaceStage::Begun && busy();
    fall_back();
    if (interrupted)
        stage_ = SurfaceStage::Interrupted;
}

void LiveSurface::resume() {
    if (stage_ == SurfaceStage::Interrupted)
        begin_now();
}

void LiveSurface::turned_away() {
    turned_away_ = services_.clock.now();
    hide_ = services_.loop.after(limits::hidden_after, [weak = weak_from_this()] {
        const auto self = weak.lock();
        if (self && self->unseen())
            self->stop_jobs();
    });
}

bool LiveSurface::unseen() const {
    return turned_away_ && services_.clock.now() - *turned_away_ >= limits::hidden_after &&
           !has_viewers();
}

std::uint32_t LiveSurface::refuse(core::SurfaceKind kind, core::Error error, bool rest) {
    begin_epoch();
    stage_ = rest ? SurfaceStage::Withheld : SurfaceStage::Refused;
    wanted_.plan.parameters.kind = kind;
    renew_data({}); // of data that may be replaced
    error_ = std::move(error);
    services_.loop.post([weak = weak_from_this(), epoch = epoch_] {
        const auto self = weak.lock();
        if (self && self->epoch_ == epoch)
            self->conclude();
    });
    return epoch_;
}

bool LiveSurface::stop(core::Error reason) {
    if (error_ || !busy())
        return false;
    stop_jobs();
    stage_ = SurfaceStage::Refused; // results of running jobs are dropped
    error_ = std::move(reason);
    conclude();
    return true;
}

void LiveSurface::show(std::optional<double> time, bool playing, bool jumped) {
    time_ = time;
    playing_ = playing;
    if (stage_ < SurfaceStage::Failed || !core::moves(wanted_.plan.parameters))
        return;
    if (fallen_ && (time_.has_value() != fallen_->time.has_value() ||
                    core::age_at(wanted_.plan.parameters, time_) !=
                        core::age_at(wanted_.plan.parameters, fallen_->time)))
        fallen_.reset();
    if (!computing())
        pass_wanted_ = services_.clock.now();
    if (jumped) {
        jumped_ = services_.clock.now();
        give_up_stale();
    }
    advance();
}

/// Cancels jobs of the current epoch for another time. Steps already computed are kept; path surfaces are
/// built once for all times.
void LiveSurface::give_up_stale() {
    if (wanted_.plan.parameters.kind == core::SurfaceKind::Path)
        return;
    const auto now = services_.clock.now();
    for (auto& each : running_) {
        if (!each || is_early(each->pass) || each->epoch != epoch_ || each->pass.time == time_)
            continue;
        if (each->since >= jumped_) // of the time jumped to, or the clock has advanced since
            continue;
        if (now - each->since >= patience_with_stale) {
            each->stop.request_stop();
            continue;
        }
        overtake_ = services_.loop.after(patience_with_stale, [weak = weak_from_this()] {
            if (const auto self = weak.lock())
                self->give_up_stale();
        });
    }
}

bool LiveSurface::busy() const {
    return computing() || (!unseen() && next_pass().has_value());
}

bool LiveSurface::running() const {
    return std::ranges::any_of(running_, [this](const auto& each) {
        return each && each->epoch == epoch_ && build_ && each->build.lock() == build_;
    });
}

bool LiveSurface::computing() const {
    return running() && !std::ranges::any_of(running_, [this](const auto& each) {
               return each && each->epoch == epoch_ && each->pass.checking;
           });
}

std::optional<SurfacePass> LiveSurface::early() const {
    return shown_ && is_early(*shown_) ? shown_ : std::nullopt;
}

/// Returns the next pass; empty once all are done.
std::optional<SurfacePass> LiveSurface::next_pass() const {
    if (stage_ <= SurfaceStage::Failed)
        return std::nullopt;
    const core::SurfaceParameters& p = wanted_.plan.parameters;
    const bool moving = core::moves(p);
    const std::optional<double> time = moving ? time_ : std::nullopt;
    const auto early = [&](Phase phase) {
        return SurfacePass{phase, budgets_.quads(phase), time, budgets_.separation(phase)};
    };
    const auto age = [&](std::optional<double> at) { return core::age_at(p, at); };
    // Near the release there is little to build, and a level set has no coarser one.
    const bool begun = age(time) > 0.0 && p.kind != core::SurfaceKind::Level;
    if (begun && stage_ < SurfaceStage::Coarse && budgets_.coarse_first())
        return early(Phase::Coarse);
    if (begun && stage_ < SurfaceStage::Refined && budgets_.refined_too())
        return early(Phase::Refined);
    const bool live = moving && time && playing_;
    const SurfacePass full{live ? Phase::Live : Phase::Final, 0, time, 0.0};
    if (stage_ < SurfaceStage::Full || (shown_->phase == Phase::Live && !live))
        return full;
    if (shown_->time.has_value() != time.has_value() || age(shown_->time) != age(time))
        return full;
    return std::nullopt;
}

/// Returns the pass that estimates the error between stored times of what is shown; empty where it is done or
/// another state is to come.
std::optional<SurfacePass> LiveSurface::checking_pass() const {
    const SharedUpdate newest = ring_->newest();
    if (stage_ != SurfaceStage::Full || !build_ || !newest || !newest->checks_due || next_pass())
        return std::nullopt;
    SurfacePass pass = *shown_;
    pass.checking = true;
    return pass;
}

PriorityClass LiveSurface::priority_of(const SurfacePass& pass) const {
    if (pass.checking)
        return PriorityClass::Long;
    return stage_ == SurfaceStage::Full ? budgets_.priority_of_moving_on()
                                        : budgets_.priority(pass.phase);
}

void LiveSurface::advance() {
    // The end of a running job leads here again.
    if (resting() || unseen())
        return;
    auto pass = next_pass();
    if (running()) {
        if (pass && !computing())
            stop_jobs(); // the error between stored times of what is replaced
        return;
    }
    if (!pass)
        pass = checking_pass();
    if (!pass)
        return;
    const PriorityClass at = priority_of(*pass);
    if (!running_[index(at)]) // else the end of a stopped job leads here
        start(at, *pass);
}

void LiveSurface::start(PriorityClass priority, const SurfacePass& pass) {
    if (!build_)
        build_ =
            std::make_shared<SurfaceBuild>(wanted_, services_.clock, services_.memory, next_seq_);
    Running& running = running_[index(priority)].emplace(
        Running{epoch_, pass, std::stop_source(), services_.clock.now(), pass_wanted_,
                std::make_shared<core::WorkDone>(), build_});
    if (!pass.checking)
        progress_.start(pass.phase, running.work, running.since);
    services_.pool.run(
        // Under a name of its own it delays no picture of the session.
        pass.checking ? session_ + "\nchecks" : session_, priority,
        [build = build_, pass, priority, stop = running.stop.get_token(), weak = weak_from_this(),
         services = services_, first = stage_ != SurfaceStage::Full, queued = running.since,
         wanted = running.wanted, work = running.work, wanted_job = wanted_] {
            const auto start = services.clock.now();
            build->renew_data(wanted_job);
            auto result =
                std::make_shared<core::Result<Update>>(build->run(pass, stop, work.get()));
            const std::chrono::duration<double> taken = services.clock.now() - start;
            if (*result)
                (*result)->took.queue = std::chrono::duration<double>(start - wanted).count();
            if (services.metrics != nullptr)
                count(*services.metrics, start - queued, *result, first);
            services.loop.post([weak, priority, result, seconds = taken.count()] {
                if (const auto self = weak.lock())
                    self->finished(priority, std::move(*result), seconds);
            });
        });
}

void LiveSurface::finished(PriorityClass priority, core::Result<Update> result, double seconds) {
    const Running job = *std::exchange(running_[index(priority)], std::nullopt);
    const bool of_now = job.epoch == epoch_ && job.build.lock() == build_ && build_;
    if (of_now && !job.pass.checking) {
        pass_wanted_ = services_.clock.now();
        progress_.end();
    }
    if (job.pass.checking) {
        if (of_now && stage_ == SurfaceStage::Full && result)
            publish(job.pass, std::move(*result));
        else if (of_now && !result && result.error().code != core::Error::Code::Cancelled)
            release_build(); // it would fail again
    } else if (!of_now || stage_ < SurfaceStage::Failed)
        budgets_.cut_short(job.pass.phase, seconds);
    else if (result)
        publish(job.pass, std::move(*result));
    else
        failed(job.pass, std::move(result.error()), seconds);
    advance();
}

double LiveSurface::finest() const {
    return wanted_.plan.parameters.separation;
}

void LiveSurface::publish(const SurfacePass& pass, Update update) {
    if (pass.checking) // the picture took as long as before
        update.took = ring_->newest()->took;
    else if (stage_ == SurfaceStage::Full)
        budgets_.moved_on(update.seconds);
    else
        budgets_.took(pass.phase, update.seconds, update.statistics, finest(),
                      wanted_.plan.parameters.max_quads);
    stage_ = std::max(stage_, stage_after(pass.phase));
    shown_ = pass;
    if (ranges_.add(update.ranges, is_early(pass)) && events_.ranges)
        events_.ranges({id_, epoch_, ranges_.announced()});
    const bool first = !ring_->newest();
    auto state = std::exchange(update.wire.state, nullptr);
    ring_->add(std::make_shared<const Update>(std::move(update)), std::move(state));
    if (first && services_.metrics != nullptr)
        services_.metrics->first_frame(seconds_since(began_));
    trim_ = services_.loop.after(limits::ring_age + std::chrono::milliseconds(100),
                                 [weak = std::weak_ptr(ring_)] {
                                     if (const auto ring = weak.lock())
                                         ring->trim();
                                 });
    if (pass.phase == Phase::Live) {
        progress_.arrive();
        waiters_->answer(epoch_, outcome());
        return;
    }
    const bool more = next_pass().has_value();
    if (!more && !checking_pass() && !core::moves(wanted_.plan.parameters))
        release_build(); // nothing will continue it
    if ((pass.phase != Phase::Final || !more) && !pass.checking)
        events_.progress({id_, epoch_, pass.phase, ring_->newest()->took});
    if (!more)
        conclude();
}

void LiveSurface::failed(const SurfacePass& pass, core::Error error, double seconds) {
    if (is_early(pass)) { // the final pass reports the error for all
        if (error.limit == pass.quads && budgets_.too_many(pass.phase, seconds))
            return;
        stage_ = std::max(stage_, stage_after(pass.phase));
    } else if (error.code == core::Error::Code::Cancelled) {
        budgets_.cut_short(pass.phase, seconds); // for another time of the clock
    } else {
        stage_ = SurfaceStage::Failed;
        error_ = std::move(error);
        conclude();
    }
}

/// Ends the epoch in its present state.
void LiveSurface::conclude() {
    if (!error_)
        progress_.arrive();
    if (error_)
        release_build();
    events_.done(outcome());
    if (error_)
        waiters_->answer(epoch_, tl::unexpected(*error_));
    else
        waiters_->answer(epoch_, outcome());
}

SurfaceOutcome LiveSurface::outcome() const {
    if (fallen_)
        return fallen_->outcome;
    SurfaceOutcome out;
    out.surface = id_;
    out.epoch = epoch_;
    out.error = error_;
    out.statistics.kind = wanted_.plan.parameters.kind;
    if (const SharedUpdate state = ring_->newest()) {
        const bool playing = shown_->phase == Phase::Live && playing_;
        out.complete = stage_ == SurfaceStage::Full && (playing || !next_pass());
        out.checks_pending = out.complete && checking_pass() && !unseen();
        out.state_sum = state->wire.state_sum;
        out.statistics = state->statistics;
        out.statistics.requested_separation = finest(); // an early pass has a lower request
        out.took = state->took;
    }
    return out;
}

BuildStatus LiveSurface::status() const {
    return progress_.status(services_.clock.now());
}

void LiveSurface::retire() {
    stop_jobs();
    stage_ = SurfaceStage::Refused;
    ++epoch_; // results of running jobs are dropped
    ring_->close();
    waiters_->answer(std::numeric_limits<std::uint32_t>::max(),
                     core::fail(core::Error::Code::NotFound, "surface " + id_ + " was deleted",
                                "`surface.list` lists them"));
}

std::uint64_t LiveSurface::wait(std::uint32_t epoch,
                                std::chrono::milliseconds patience,
                                Waiter waiter,
                                bool checked) {
    const SurfaceOutcome now = outcome();
    if (epoch <= epoch_ && (now.error || (now.complete && !(checked && now.checks_pending)))) {
        waiter(now.error ? core::Result<SurfaceOutcome>(tl::unexpected(*now.error))
                         : core::Result<SurfaceOutcome>(now));
        return 0;
    }
    begin_now();
    const std::uint64_t ticket = waiters_->add(
        epoch, patience,
        [weak = weak_from_this()] {
            const auto self = weak.lock();
            return self ? self->outcome() : SurfaceOutcome{};
        },
        std::move(waiter), checked);
    advance(); // it may be hidden
    return ticket;
}

void LiveSurface::forget(std::uint64_t ticket) {
    waiters_->forget(ticket);
}

/// Encodes a key for clients that have fallen behind or come late; once for all of them.
void LiveSurface::encode_key() {
    const SharedUpdate newest = ring_->newest();
    const auto job = [newest, state = ring_->state(), number = number_, weak = std::weak_ptr(ring_),
                      &loop = services_.loop, metrics = services_.metrics,
                      account = services_.memory.account] {
        // There is no state where the newest update is a key itself.
        SharedUpdate key = state ? keyframe_of(*newest, state, number, account) : nullptr;
        if (key && metrics != nullptr)
            metrics->keyframe();
        loop.post([weak, key = std::move(key)] {
            if (const auto ring = weak.lock())
                ring->add_key(key);
        });
    };
    if (!ring_->state())
        job();
    else if (newest->statistics.vertices < quick_key)
        services_.pool.run(session_, PriorityClass::Quick, job);
    else
        // Under a name of its own it does not wait behind the session's own work.
        services_.pool.run(session_ + "\nkeys", PriorityClass::Long, job);
}

} // namespace wakesurf::server
