#include "core/surface/columns/sheet.hpp"

#include "core/surface/columns/sheet_bends.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

namespace wakesurf::core {

namespace {

constexpr double spacing_of_separation =
    0.75; // square cells on average: fronts are between 1/2 and 1 separation
constexpr double tear_width = 1.0 / 16.0; // of the separation
constexpr double least_interval = 1e-6;   // of the rake
constexpr int most_rounds = 128;
constexpr double bend_width =
    1.0 / 8.0; // of the separation: no strip becomes narrower because the sheet bends
constexpr int most_bend_rounds = 32;
// A quad takes its cell in a vector that grows by doubling, its columns' vertices, its part of the tree. With
// 160 bytes a large sheet was seen to hold a quarter more than it had reported.
constexpr std::size_t strip_bytes = 200;

/// Up to so many quads may become one where seeds are close.
constexpr std::size_t most_joined = 16;

/// Returns how much a column may turn from one vertex to the next. A quad's side may take two segments, and
/// cells meet at the turn of a whole side.
double most_turn(double angle) {
    return angle < 180.0 ? 0.5 * angle * std::numbers::pi / 180.0 : std::numbers::pi;
}

double elapsed(const Clock& clock, std::chrono::steady_clock::time_point since) {
    return std::chrono::duration<double>(clock.now() - since).count();
}

} // namespace

Sheet::Sheet(const Flow& flow, SeedingCurve seeding, SheetOptions options)
    : flow_(flow), seeding_(std::move(seeding)),
      options_(options), limits_{
                             {&flow, options.separation, flow.obstacle()},
                             {spacing_of_separation * options.separation, most_turn(options.angle)},
                             tear_width * options.separation,
                             least_interval} {}

Result<void>
Sheet::trace(const std::set<double>& parameters, const Clock& clock, const std::stop_token& stop) {
    const auto start = clock.now();
    std::vector<double> missing;
    std::vector<Curve> batch;
    for (const double s : parameters) {
        if (curve_at_.contains(s))
            continue;
        missing.push_back(s);
        Curve curve;
        curve.seed = seeding_.at(s);
        curve.seed_tangent = seeding_.tangent(s);
        curve.release = options_.release;
        curve.duration = options_.duration;
        batch.push_back(std::move(curve));
    }
    const auto traced = flow_.trace(batch, options_.trace, stop);
    if (!traced)
        return tl::unexpected(traced.error());
    for (std::size_t i = 0; i < batch.size(); ++i)
        curve_at_[missing[i]] =
            &curves_.emplace_back(SeededCurve{missing[i], std::move(batch[i]), {}});
    seconds_.load += traced->load;
    seconds_.advect += elapsed(clock, start) - traced->load;
    return {};
}

/// Counts the memory of so many quads of strips. @param counted  quads until now
Result<void> Sheet::hold(std::size_t quads, std::size_t& counted, const WorkPart& work) const {
    const std::size_t more = quads - std::min(quads, counted);
    counted += more;
    return work.takes(more * strip_bytes);
}

Strip Sheet::strip_between(double left, double right_s) const {
    return Strip(*curve_at_.at(left), *curve_at_.at(right_s == 1.0 && closed() ? 0.0 : right_s),
                 right_s);
}

/// The columns that strips end at, each made once for the strips on either side.
void Sheet::make_end_columns(const std::stop_token& stop) {
    std::vector<SeededCurve*> ends;
    for (const double s : seeds_)
        if (SeededCurve* end = curve_at_.at(s); end->column.position.empty())
            ends.push_back(end);
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t{0}, ends.size(), [&](std::size_t i) {
            if (!stop.stop_requested())
                ends[i]->column = make_column(ends[i]->s, ends[i]->curve, 0.0, limits_.spacing);
        });
    });
}

/// Returns the quads that there are then. Error: Cancelled.
Result<std::size_t>
Sheet::zip(const std::vector<std::size_t>& dirty, const Clock& clock, const std::stop_token& stop) {
    const auto start = clock.now();
    make_end_columns(stop);
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(std::size_t{0}, dirty.size(), [&](std::size_t i) {
            if (!stop.stop_requested())
                strips_[dirty[i]].zip(limits_);
        });
    });
    if (stop.stop_requested())
        return fail(Error::Code::Cancelled, "the surface was cancelled");
    seconds_.refine += elapsed(clock, start);
    return quads();
}

std::uint64_t Sheet::quads() const {
    std::uint64_t sum = 0;
    for (const Strip& strip : strips_)
        sum += strip.quads();
    return sum;
}

/// Replaces each strip that holds a new seed by two.
void Sheet::cut_at(const std::vector<double>& new_seeds) {
    std::vector<Strip> strips;
    std::size_t next = 0;
    for (Strip& strip : strips_) {
        if (next < new_seeds.size() && new_seeds[next] > strip.left_s() &&
            new_seeds[next] < strip.right_s()) {
            strips.push_back(strip_between(strip.left_s(), new_seeds[next]));
            strips.push_back(strip_between(new_seeds[next], strip.right_s()));
            ++next;
        } else {
            strips.push_back(std::move(strip));
        }
    }
    strips_ = std::move(strips);
}

/// Returns the part of the rake that lies before the strips that are not done.
double Sheet::part_without(const std::vector<std::size_t>& dirty) const {
    double rest = 0.0;
    for (const std::size_t i : dirty)
        rest += strips_[i].right_s() - strips_[i].left_s();
    return 1.0 - rest;
}

Result<bool> Sheet::build(const std::set<double>& seeds,
                          const Clock& clock,
                          std::stop_token stop,
                          WorkPart work) {
    seeds_ = seeds;
    if (auto traced = trace(seeds_, clock, stop); !traced)
        return tl::unexpected(traced.error());
    double arc = 0.0;
    for (const SeededCurve& curve : curves_)
        arc += curve.curve.last.arc;
    const auto expected = static_cast<std::size_t>(arc / limits_.spacing.longest);
    if (expected / most_joined > options_.max_quads)
        return false;
    std::size_t counted = 0;
    if (auto held = hold(expected, counted, work); !held)
        return tl::unexpected(held.error());

    strips_.clear();
    for (auto left = seeds_.begin(); left != seeds_.end(); ++left)
        if (const auto right = std::next(left); right != seeds_.end())
            strips_.push_back(strip_between(*left, *right));
        else if (closed())
            strips_.push_back(strip_between(*left, 1.0));
    std::vector<std::size_t> dirty(strips_.size());
    std::iota(dirty.begin(), dirty.end(), std::size_t{0});
    int round = 0;
    for (int bend_round = 0;;) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        std::vector<StripDemand> demands;
        if (dirty.empty()) {
            if (bend_round++ < most_bend_rounds)
                demands = bend_demands(clock);
            if (demands.empty())
                break;
            round = 0;
        } else {
            const auto quads = zip(dirty, clock, stop);
            if (!quads)
                return tl::unexpected(quads.error());
            if (*quads > options_.max_quads)
                return false;
            if (auto held = hold(*quads, counted, work); !held)
                return tl::unexpected(held.error());
            work.has(*quads);
            for (const std::size_t i : dirty)
                if (round >= most_rounds)
                    strips_[i].tear_rest();
                else
                    demands.push_back({i, strips_[i].refine(limits_)});
            ++round;
        }
        auto again = meet(demands, clock, stop);
        if (!again)
            return tl::unexpected(again.error());
        dirty = std::move(*again);
        work.reached(part_without(dirty));
    }
    return true;
}

/// Returns what the strips want where the sheet bends, only for strips that want something.
std::vector<Sheet::StripDemand> Sheet::bend_demands(const Clock& clock) {
    std::vector<StripDemand> demands;
    if (options_.angle >= 180.0)
        return demands;
    const auto start = clock.now();
    const double cosine = std::cos(options_.angle * std::numbers::pi / 180.0);
    const auto rows = find_bends(strips_, closed(), cosine, 2.0 * bend_width * options_.separation);
    for (std::size_t i = 0; i < strips_.size(); ++i)
        if (!rows[i].empty())
            if (auto demand = strips_[i].split_bends(limits_, rows[i]); demand.changed)
                demands.push_back({i, std::move(demand)});
    seconds_.refine += elapsed(clock, start);
    return demands;
}

/// Hands strips the curves and seeds they want. Returns the strips to zip again.
Result<std::vector<std::size_t>> Sheet::meet(const std::vector<StripDemand>& demands,
                                             const Clock& clock,
                                             const std::stop_token& stop) {
    std::set<double> wanted;
    std::vector<double> new_seeds;
    std::vector<std::size_t> again;
    for (const auto& [i, demand] : demands) {
        if (demand.new_seed) {
            wanted.insert(*demand.new_seed);
            new_seeds.push_back(*demand.new_seed);
        } else {
            wanted.insert(demand.middles.begin(), demand.middles.end());
        }
        if (demand.changed)
            again.push_back(i);
    }
    if (auto traced = trace(wanted, clock, stop); !traced)
        return tl::unexpected(traced.error());
    for (const std::size_t i : again)
        for (auto s = wanted.upper_bound(strips_[i].left_s());
             s != wanted.end() && *s < strips_[i].right_s(); ++s)
            strips_[i].supply(*curve_at_.at(*s));
    if (!new_seeds.empty()) {
        seeds_.insert(new_seeds.begin(), new_seeds.end());
        std::vector<double> marks;
        for (const std::size_t i : again)
            marks.push_back(strips_[i].left_s());
        marks.insert(marks.end(), new_seeds.begin(), new_seeds.end());
        std::sort(marks.begin(), marks.end());
        cut_at(new_seeds);
        again.clear();
        for (std::size_t i = 0; i < strips_.size(); ++i)
            if (std::binary_search(marks.begin(), marks.end(), strips_[i].left_s()))
                again.push_back(i);
    }
    return again;
}

std::vector<const SeededCurve*> Sheet::columns() const {
    std::vector<const SeededCurve*> all;
    for (const double s : seeds_)
        all.push_back(curve_at_.at(s));
    for (const Strip& strip : strips_)
        for (std::size_t c = 2; c < strip.columns().size(); ++c)
            all.push_back(strip.columns()[c].curve);
    return all;
}

} // namespace wakesurf::core
