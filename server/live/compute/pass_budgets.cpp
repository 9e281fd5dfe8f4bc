#include "server/live/compute/pass_budgets.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::server {

namespace {

/// A coarse pass within this shows an edit within 5 ms and outruns a 60 Hz drag, whose every edit cancels
/// it.
constexpr double coarse_budget = 0.0035;
constexpr double refined_budget = 0.08;
/// A final pass this fast needs no coarse one before it.
constexpr double fast_final = 0.005;
/// One slower than this is worth a refined one.
constexpr double slow_final = 0.2;
/// Where a coarse pass alone takes longer than the budget of a refined one, that may take so many times as
/// long.
constexpr double refined_after_coarse = 4.0;
/// A refined pass that takes a larger part of the time of the final one only delays it.
constexpr double worth_refining = 0.4;
/// Passes expected to end within this (s) run on the threads that clients wait for.
constexpr double quick = 0.015;
/// A pass that was slow by chance (others had the processor) must not make the next one large: quads grow
/// by steps of this.
constexpr double growth = 2.0;
/// A surface changes while it is edited: so many times the quads aimed at are no reason to begin again with
/// fewer.
constexpr double room = 1.5;
/// After this many refusals in a row the separation has grown 26-fold (1.5^8): a larger one does not help.
constexpr int most_refusals = 8;

} // namespace

PassBudgets::PassBudgets(bool at_once)
    : coarse_{coarse_budget, 100.0, 4000.0, 1000.0}, refined_{refined_budget, 2000.0, 200'000.0,
                                                              20'000.0},
      coarse_seconds_(at_once ? 0.0 : 1.0), power_(at_once ? 1.0 : 1.5) {}

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
        // Time-steps that were waited for once are there for the next pass.
        const double worked = std::max(1e-4, seconds - statistics.seconds.load);
        const double finer = std::pow(statistics.separation / separation, 2);
        const double most =
            static_cast<double>(max_quads) / std::max(1.0, static_cast<double>(statistics.quads));
        estimated_seconds_ = worked * std::pow(std::max(1.0, std::min(finer, most)), power_);
        early(phase).learn(seconds, &statistics);
        if (phase == Phase::Coarse)
            aim_refined(worked, statistics);
        else
            refined_known_ = true;
    } else {
        final_seconds_ = seconds;
    }
}

void PassBudgets::cut_short(Phase phase, double seconds) {
    // While edits come faster than coarse passes end, nothing would ever be shown.
    if (phase == Phase::Final)
        final_seconds_ = std::max(final_seconds_.value_or(seconds), seconds);
    else if (phase != Phase::Live && seconds > early(phase).budget)
        early(phase).learn(seconds, nullptr);
}

/// Allows the next pass more quads and makes it coarser: otherwise each edit would fail in the same way until
/// the surface becomes smaller by itself. learn() takes back what turns out to be too slow.
bool PassBudgets::too_many(Phase phase, double seconds) {
    Aim& aim = early(phase);
    if (++aim.refused > most_refusals)
        return false;
    aim.quads = std::min(aim.most, room * aim.quads);
    aim.separation *= room;
    return seconds < aim.budget;
}

/// The time a quad takes depends on the data and the surface, and differs by a thousand: a refined pass is
/// planned by the time of the coarse one, unless one was measured whose quads are near the aim.
void PassBudgets::aim_refined(double seconds, const core::SurfaceStatistics& had) {
    refined_.budget = std::max(refined_budget, refined_after_coarse * seconds);
    const double gave = std::max(static_cast<double>(had.quads), 1.0);
    const double more = std::pow(refined_.budget / seconds, 1.0 / power_);
    const double aim = std::clamp(gave * more, std::min(refined_.least, 2.0 * gave), refined_.most);
    if (refined_known_ && refined_.quads < growth * aim)
        return;
    refined_.quads = aim;
    refined_.refused = 0;
    refined_.separation = had.separation * std::sqrt(gave / refined_.quads);
}

/// The work goes with the quads, and they with the inverse square of the separation.
void PassBudgets::Aim::learn(double seconds, const core::SurfaceStatistics* had) {
    refused = 0;
    const double factor = std::min(growth, budget / std::max(seconds, 1e-4));
    if (had == nullptr) {
        quads = std::max(quads * factor, least);
        separation /= std::sqrt(std::min(factor, 1.0));
        return;
    }
    // One that needed fewer than it may have tells little of what it could have had.
    const double gave = std::max(static_cast<double>(had->quads), 1.0);
    quads = std::clamp(gave * factor, least, most);
    separation = had->separation * std::sqrt(gave / quads);
}

/// Pessimistic before the first pass.
double PassBudgets::expected_final() const {
    return final_seconds_.value_or(estimated_seconds_.value_or(1.0));
}

bool PassBudgets::coarse_first() const {
    return expected_final() > fast_final;
}

bool PassBudgets::refined_too() const {
    return expected_final() > slow_final && refined_.budget < worth_refining * expected_final();
}

std::uint64_t PassBudgets::quads(Phase phase) const {
    return static_cast<std::uint64_t>(room * early(phase).quads);
}

double PassBudgets::separation(Phase phase) const {
    return early(phase).separation;
}

PriorityClass PassBudgets::priority(Phase phase) const {
    const double expected = phase == Phase::Coarse    ? coarse_seconds_
                            : phase == Phase::Refined ? refined_.budget
                                                      : expected_final();
    return expected < (phase == Phase::Coarse ? 2.0 * quick : quick) ? PriorityClass::Quick
                                                                     : PriorityClass::Long;
}

PriorityClass PassBudgets::priority_of_moving_on() const {
    return step_seconds_ < quick ? PriorityClass::Quick : PriorityClass::Long;
}

} // namespace wakesurf::server
