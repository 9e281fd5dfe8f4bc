#include "server/session/live_surface.hpp"

#include "server/limits.hpp"

#include <algorithm>

namespace wakesurf::server {

namespace {

/// A coarse pass within this shows an edit within 20 ms and outruns a 60 Hz drag, whose every edit cancels it.
constexpr double coarse_budget = 0.006;
/// A final pass this fast needs no coarse one before it.
constexpr double fast_final = 0.010;

} // namespace

LiveSurface::LiveSurface(
    std::string id, std::uint32_t number, Loop& loop, ComputePool& pool, Events events)
    : id_(std::move(id)), number_(number), loop_(loop), pool_(pool), events_(std::move(events)) {}

LiveSurface::~LiveSurface() {
    stop_.request_stop();
}

std::uint32_t LiveSurface::rebuild(SurfaceJob wanted) {
    stop_.request_stop();
    wanted_ = std::move(wanted);
    wanted_.number = number_;
    wanted_.epoch = ++epoch_;
    state_.reset();
    error_.reset();
    started_ = false;
    for (FrameSink* sink : sinks_)
        sink->superseded(number_, epoch_);
    if (!running_)
        start();
    return epoch_;
}

std::uint32_t LiveSurface::refuse(core::SurfaceKind kind, core::Error error) {
    stop_.request_stop();
    wanted_.parameters.kind = kind;
    state_.reset();
    error_ = std::move(error);
    started_ = true;
    ++epoch_;
    for (FrameSink* sink : sinks_)
        sink->superseded(number_, epoch_);
    loop_.post([weak = weak_from_this(), epoch = epoch_] {
        const auto self = weak.lock();
        if (!self || self->epoch_ != epoch)
            return;
        self->events_.done(self->outcome());
        self->settle();
    });
    return epoch_;
}

void LiveSurface::start() {
    started_ = true;
    running_ = true;
    stop_ = std::stop_source();
    SurfaceJob job = wanted_;
    job.coarse_quads = final_seconds_ < fast_final ? 0 : static_cast<std::uint64_t>(coarse_quads_);
    const PublishState publish = [weak = weak_from_this(), &loop = loop_,
                                  epoch = job.epoch](core::Result<SurfaceState> result) {
        auto shared = std::make_shared<core::Result<SurfaceState>>(std::move(result));
        loop.post([weak, epoch, shared] {
            if (const auto self = weak.lock())
                self->published(epoch, std::move(*shared));
        });
    };
    pool_.run([job = std::move(job), stop = stop_.get_token(), publish, weak = weak_from_this(),
               &loop = loop_] {
        const double cut_short = run_surface_job(job, stop, publish);
        loop.post([weak, cut_short] {
            if (const auto self = weak.lock())
                self->finished(cut_short);
        });
    });
}

void LiveSurface::published(std::uint32_t epoch, core::Result<SurfaceState> result) {
    if (epoch != epoch_)
        return;
    if (!result) {
        error_ = std::move(result.error());
    } else {
        learn(*result);
        state_ = std::make_shared<const SurfaceState>(std::move(*result));
        events_.progress(epoch_, state_->final);
        for (FrameSink* sink : sinks_)
            sink->frames(number_, state_);
    }
    if (error_ || state_->final) {
        events_.done(outcome());
        settle();
    }
}

void LiveSurface::finished(double cut_short) {
    // While edits come faster than coarse passes end, nothing would ever be shown.
    if (cut_short > coarse_budget)
        aim(cut_short);
    running_ = false;
    if (!started_)
        start();
}

void LiveSurface::learn(const SurfaceState& state) {
    if (state.final)
        final_seconds_ = state.seconds;
    else
        aim(state.seconds);
}

void LiveSurface::aim(double coarse_seconds) {
    coarse_quads_ = std::clamp(coarse_quads_ * coarse_budget / coarse_seconds, 100.0, 4000.0);
}

SurfaceOutcome LiveSurface::outcome() const {
    SurfaceOutcome out;
    out.surface = id_;
    out.epoch = epoch_;
    out.error = error_;
    out.statistics.kind = wanted_.parameters.kind;
    if (state_) {
        out.complete = state_->final && !error_;
        out.crc = state_->crc;
        out.statistics = state_->statistics;
    }
    return out;
}

void LiveSurface::retire() {
    stop_.request_stop();
    started_ = true;
    ++epoch_; // what the running job still publishes is nobody's
    for (FrameSink* sink : sinks_)
        sink->superseded(number_, epoch_);
    sinks_.clear();
    for (Waiting& each : std::exchange(waiting_, {}))
        each.answer(core::fail(core::Error::Code::NotFound, "surface " + id_ + " was deleted",
                               "list the surfaces with surface.list"));
}

void LiveSurface::subscribe(FrameSink& sink) {
    if (!subscribed(sink))
        sinks_.push_back(&sink);
}

void LiveSurface::unsubscribe(FrameSink& sink) {
    std::erase(sinks_, &sink);
}

bool LiveSurface::subscribed(const FrameSink& sink) const {
    return std::find(sinks_.begin(), sinks_.end(), &sink) != sinks_.end();
}

std::uint64_t
LiveSurface::wait(std::uint32_t epoch, std::chrono::milliseconds patience, Waiter waiter) {
    const std::uint64_t id = next_waiter_++;
    if (waiting_.size() >= limits::waiters) {
        waiter(core::fail(core::Error::Code::OverLimit,
                          "too many surface.wait calls are open for surface " + id_,
                          "let some of them finish first"));
        return id;
    }
    waiting_.push_back({id, epoch, std::move(waiter), nullptr});
    settle();
    if (waiting_.empty() || waiting_.back().id != id)
        return id;
    waiting_.back().timer = loop_.after(patience, [weak = weak_from_this(), id] {
        if (const auto self = weak.lock())
            self->give_up(id);
    });
    return id;
}

void LiveSurface::forget(std::uint64_t ticket) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const Waiting& each) { return each.id == ticket; });
    if (found == waiting_.end())
        return;
    const Waiting ended = std::move(*found); // destroyed last: it may look at this surface
    waiting_.erase(found);
}

void LiveSurface::settle() {
    if (!error_ && !(state_ && state_->final))
        return;
    const auto ready = [this](const Waiting& each) { return each.epoch <= epoch_; };
    std::vector<Waiter> answers;
    for (Waiting& each : waiting_)
        if (ready(each))
            answers.push_back(std::move(each.answer));
    std::erase_if(waiting_, ready);
    for (Waiter& answer : answers) {
        if (error_)
            answer(tl::unexpected(*error_));
        else
            answer(outcome());
    }
}

void LiveSurface::give_up(std::uint64_t waiter) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [&](const Waiting& each) { return each.id == waiter; });
    if (found == waiting_.end())
        return;
    const Waiter answer = std::move(found->answer);
    waiting_.erase(found);
    SurfaceOutcome so_far = outcome();
    so_far.complete = false; // the epoch asked for is not there
    answer(std::move(so_far));
}

} // namespace wakesurf::server
