#include "server/live/build_progress.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

namespace {

using protocol::Phase;

// The part of the way that is done after a coarse pass, and after a refined one.
constexpr double coarse_part = 0.05, early_part = 0.2;

} // namespace

void BuildProgress::begin(Time now) {
    *this = {};
    began_ = now;
}

void BuildProgress::start(Phase phase, std::shared_ptr<const core::WorkDone> work, Time now) {
    if (there_)
        begin(now);
    from_ = fraction();
    to_ = std::max(from_, phase == Phase::Coarse    ? coarse_part
                          : phase == Phase::Refined ? early_part
                                                    : 1.0);
    work_ = std::move(work);
    if (phase != Phase::Coarse && phase != Phase::Refined)
        full_ = work_;
}

void BuildProgress::end() {
    from_ = fraction();
    work_.reset();
}

void BuildProgress::arrive() {
    there_ = true;
}

double BuildProgress::fraction() const {
    return work_ ? from_ + (to_ - from_) * work_->fraction() : from_;
}

BuildStatus BuildProgress::status(Time now) const {
    BuildStatus out;
    out.fraction = there_ ? 1.0 : fraction();
    out.seconds = std::chrono::duration<double>(now - began_).count();
    if (full_) {
        out.time = full_->time();
        out.quads = full_->quads();
    }
    return out;
}

} // namespace wakesurf::server
