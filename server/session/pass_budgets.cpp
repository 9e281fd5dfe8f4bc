#include "server/session/pass_budgets.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

namespace {

/// A coarse pass within this shows an edit within 5 ms and outruns a 60 Hz drag, whose every edit cancels it.
constexpr double coarse_budget = 0.0035;
constexpr double refined_budget = 0.08;
/// A final pass this fast needs no coarse one before it.
constexpr double fast_final = 0.005;
/// One slower than this is worth a refined one.
constexpr double slow_final = 0.2;
/// What may run on the threads that others wait for.
constexpr double quick = 0.015;

} // namespace

void PassBudgets::forget() {
    final_seconds_.reset();
    estimated_seconds_.reset();
    step_seconds_ = 1.0;
}

void PassBudgets::took(Phase phase,
                       double seconds,
                       const core::SurfaceStatistics& statistics,
                       double separation,
                       std::uint64_t max_quads) {
    if (phase == Phase::Coarse)
        coarse_seconds_ = seconds;
    if (phase == Phase::Coarse || phase == Phase::Refined) {
        const double finer = std::pow(statistics.separation / separation, 2);
        const double most =
            static_cast<double>(max_quads) / std::max(1.0, static_cast<double>(statistics.quads));
        estimated_seconds_ = seconds * std::min(finer, most);
        aim(phase, seconds);
    } else {
        final_seconds_ = seconds;
    }
}

void PassBudgets::cut_short(Phase phase, double seconds) {
    // While edits come faster than coarse passes end, nothing would ever be shown.
    if (phase == Phase::Coarse && seconds > coarse_budget)
        aim(phase, seconds);
    else if (phase == Phase::Refined && seconds > refined_budget)
        aim(phase, seconds);
    else if (phase == Phase::Final)
        final_seconds_ = std::max(final_seconds_.value_or(seconds), seconds);
}

void PassBudgets::aim(Phase phase, double seconds) {
    const double taken = std::max(seconds, 1e-4);
    if (phase == Phase::Coarse)
        coarse_quads_ = std::clamp(coarse_quads_ * coarse_budget / taken, 100.0, 4000.0);
    else
        refined_quads_ = std::clamp(refined_quads_ * refined_budget / taken, 2000.0, 200'000.0);
}

/// Pessimistic before the first pass.
double PassBudgets::expected_final() const {
    return final_seconds_.value_or(estimated_seconds_.value_or(1.0));
}

bool PassBudgets::coarse_first() const {
    return expected_final() > fast_final;
}

bool PassBudgets::refined_too() const {
    return expected_final() > slow_final;
}

std::uint64_t PassBudgets::quads(Phase phase) const {
    return static_cast<std::uint64_t>(phase == Phase::Coarse ? coarse_quads_ : refined_quads_);
}

Pace PassBudgets::pace(Phase phase) const {
    const double expected = phase == Phase::Coarse    ? coarse_seconds_
                            : phase == Phase::Refined ? refined_budget
                                                      : expected_final();
    return expected < (phase == Phase::Coarse ? 2.0 * quick : quick) ? Pace::Quick : Pace::Long;
}

Pace PassBudgets::pace_of_moving_on() const {
    return step_seconds_ < quick ? Pace::Quick : Pace::Long;
}

} // namespace wakesurf::server
