#include "core/surface/budget_search.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace wakesurf::core {

namespace {

// The first trial may take this part of the budget.
constexpr double first_trial = 1.0 / 24.0;
/// The most of the budget, until a surface is counted: before that the excess is unknown.
constexpr double most_at_first = 1.0 / 4.0;
constexpr double last_trial = 0.33;
constexpr double near_enough = 0.2; ///< for extrapolating from few counts
constexpr double aimed_at = 0.85;
constexpr double enough = 0.7;
/// A surface that was given up counts as so many times the quads at which it was.
constexpr double count_of_given_up = 1.15;

/// The power law's exponent is at least this: a smaller one measured is a jump of the count between two
/// trials.
constexpr double least_exponent = 1.0;
/// This exponent is assumed far from the budget: it lies between that of rows alone, 1, and that of rows and
/// columns, 2.
constexpr double most_likely = 1.6;
constexpr double most_growth = 6.0; ///< of quads, from one trial to the next
constexpr double closest = 1.01;    ///< ratio of two separations between which no third is tried
constexpr int most_trials = 12;

} // namespace

BudgetSearch::BudgetSearch(double requested, double coarsest, double estimate, std::uint64_t most)
    : requested_(requested), coarsest_(std::max(requested, coarsest)), estimate_(estimate),
      most_(most) {}

double BudgetSearch::exponent() const {
    if (!before_ || before_->quads <= 0.0)
        return 2.0;
    const double measured = std::log(finest_->quads / before_->quads) /
                            std::log(before_->separation / finest_->separation);
    return std::clamp(measured, least_exponent, 2.5);
}

double BudgetSearch::separation_of(double quads, double at_least) const {
    return finest_->separation *
           std::pow(std::max(finest_->quads, 1.0) / quads, 1.0 / std::max(exponent(), at_least));
}

bool BudgetSearch::near() const {
    return before_ && finest_->quads >= near_enough * static_cast<double>(most_);
}

std::optional<BudgetSearch::Trial> BudgetSearch::next() {
    const double budget = static_cast<double>(most_);
    const auto part = [&](double of) {
        return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(of * budget));
    };
    ++trials_;
    if (!finest_) {
        if (too_fine_ >= coarsest_)
            return std::nullopt;
        double separation = requested_;
        // The search stops at a quarter of them, where the count grows by the square; further each time.
        if (const double too_fine = std::max(too_fine_, too_fine_trial_); too_fine > 0.0)
            separation = std::pow(4.0, std::max(1, trials_ - 1)) * too_fine;
        else if (estimate_ > first_trial * budget)
            separation = requested_ * std::sqrt(estimate_ / (first_trial * budget));
        separation = std::min(separation, coarsest_);
        const bool whole = separation == requested_ || separation == coarsest_;
        return last_ = {separation, whole ? most_ : part(most_at_first)};
    }
    settled_ = trials_ > most_trials || finest_->separation <= too_fine_ * closest;
    if (settled_)
        return last_ = {finest_->separation, most_};
    const double aim =
        near() ? aimed_at * budget : std::min(most_growth * finest_->quads, last_trial * budget);
    double separation =
        separation_of(std::max(aim, 1.3 * finest_->quads), near() ? 0.0 : most_likely);
    // This is what the law says of the separation asked for, with room for what it does not know.
    const double there = finest_->quads * std::pow(finest_->separation / requested_, exponent());
    if (too_fine_ == 0.0 && (separation <= requested_ * 1.05 || there < 0.5 * budget))
        return last_ = {requested_, most_};
    if (too_fine_ >
        0.0) { // what was given up had more than the budget: the law is at least so steep
        const double steep = std::log(count_of_given_up * budget / std::max(finest_->quads, 1.0)) /
                             std::log(finest_->separation / too_fine_);
        separation = separation_of(aimed_at * budget, std::max(steep, most_likely));
    }
    separation = std::max(separation, requested_);
    if (separation >= finest_->separation / closest) // the law leads nowhere
        separation = std::sqrt(std::max(requested_, too_fine_) * finest_->separation);
    return last_ = {separation, most_};
}

bool BudgetSearch::built(std::uint64_t quads) {
    const double count = static_cast<double>(quads);
    if (settled_ || last_.separation == requested_ || count >= enough * static_cast<double>(most_))
        return true;
    before_ = finest_;
    finest_ = Count{last_.separation, count};
    return false;
}

void BudgetSearch::settle() {
    trials_ = most_trials;
}

void BudgetSearch::exceeded() {
    given_up_ += last_.most == most_;
    if (last_.most == most_)
        too_fine_ = std::max(too_fine_, last_.separation);
    else
        too_fine_trial_ = std::max(too_fine_trial_, last_.separation);
}

double coarsest_separation(const Box& domain) {
    const Vec3 extent = domain.extent();
    return 0.1 * std::max({extent.x, extent.y, extent.z});
}

tl::unexpected<Error> cannot_be_coarser(std::uint64_t max_quads, double separation) {
    std::ostringstream text;
    text << "the surface needs more than " << max_quads << " quads, even at a separation of "
         << separation;
    return over_limit(max_quads, text.str(), "raise `maxQuads`, or shorten the time or the rake");
}

} // namespace wakesurf::core
