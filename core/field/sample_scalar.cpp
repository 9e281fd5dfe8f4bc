#include "core/field/sample_scalar.hpp"

#include "core/dataset/missing_bricks.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

namespace wakesurf::core {

namespace {

// The time-step at or before a time, and the part of the way to the next.
struct Moment {
    std::size_t step = 0;
    double part = 0.0;
};

Moment moment_of(const std::vector<double>& times, double time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin())
        return {};
    const auto step = static_cast<std::size_t>(after - times.begin() - 1);
    if (step + 1 == times.size())
        return {step, 0.0};
    return {step, (time - times[step]) / (times[step + 1] - times[step])};
}

// Keeps the two time-steps last asked for: in order of time that is all it takes.
class TwoSteps {
  public:
    TwoSteps(const ScalarSource& source, std::size_t scalar, const std::stop_token& stop)
        : source_(source), scalar_(scalar), stop_(stop) {}

    Result<const float*> values(std::size_t step) {
        Held& held = held_[step % 2];
        if (!held.slab || held.step != step) {
            held.slab.reset(); // before the next is read: never three in memory
            auto loaded = source_.scalar_values(scalar_, step, stop_);
            if (!loaded)
                return tl::unexpected(loaded.error());
            held.slab = std::move(*loaded);
            held.step = step;
        }
        return reinterpret_cast<const float*>(held.slab->bytes().data());
    }

  private:
    struct Held {
        std::size_t step = 0;
        std::shared_ptr<const Slab> slab;
    };

    const ScalarSource& source_;
    std::size_t scalar_;
    const std::stop_token& stop_;
    std::array<Held, 2> held_;
};

constexpr std::size_t most_at_once = std::size_t{1} << 16;

/// Calls `body` with ranges of the numbers from `begin` to `end`, until `stop` fires.
template <class Body>
void parallel(std::size_t begin, std::size_t end, const std::stop_token& stop, Body body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(begin, end, 1024), [&](const auto& range) {
        if (!stop.stop_requested())
            body(range.begin(), range.end());
    });
}

/// Points between two stored times, and what makes their values.
struct Points {
    std::span<const NodeShares> shares;
    std::span<const double> part; ///< of the way to the second time
};

/// Sets the value of the k-th point, whose i-th node has the values `first(i)` and `second(i)`.
template <class First, class Second>
double value_at(const Points& points, std::size_t k, const First& first, const Second& second) {
    const NodeShares& shares = points.shares[k];
    const double value = weighed_by(shares, first);
    const double part = points.part[k];
    return part > 0.0 ? value + part * (weighed_by(shares, second) - value) : value;
}

/// The values of the points at time-steps that are in one piece each. @param take  take(k, value), from any
/// thread
template <class Take>
Result<void> sample_whole(const Points& points,
                          TwoSteps& steps,
                          std::size_t step,
                          bool both,
                          const Take& take,
                          const std::stop_token& stop) {
    const auto first = steps.values(step);
    if (!first)
        return tl::unexpected(first.error());
    const auto second = both ? steps.values(step + 1) : first;
    if (!second)
        return tl::unexpected(second.error());
    parallel(0, points.shares.size(), stop, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k != end; ++k) {
            const auto& node = points.shares[k].node;
            take(k, value_at(
                        points, k, [&](std::size_t i) { return (*first)[node[i]]; },
                        [&](std::size_t i) { return (*second)[node[i]]; }));
        }
    });
    return {};
}

/// Samples values that come brick by brick.
template <class Take>
Result<void> sample_bricks(const Points& points,
                           const std::shared_ptr<BrickCache>& cache,
                           std::size_t field,
                           std::size_t step,
                           bool both,
                           const Take& take,
                           const std::stop_token& stop) {
    const std::size_t count = points.shares.size();
    const auto first = cache->table(step, field);
    const auto second = both ? cache->table(step + 1, field) : nullptr;
    MissingBricks missing(cache, both ? std::vector{step, step + 1} : std::vector{step}, field);
    std::vector<std::uint8_t> done(count);
    const auto sample_range = [&](std::size_t begin, std::size_t end) {
        const BrickMisses misses(&missing);
        std::array<std::size_t, 8> place{};
        for (std::size_t k = begin; k != end; ++k) {
            const NodeShares& shares = points.shares[k];
            if (done[k] != 0 || shares.count == 0)
                continue;
            const std::size_t brick = missing.layout().places_of(
                std::span(shares.node).first(shares.count), std::span(place).first(shares.count));
            const auto values_of = [&](const BrickTable& table) {
                const float* values = table.at(brick);
                if (values == nullptr)
                    return misses.note(brick);
                table.use(brick, misses.age());
                return values;
            };
            const float* const now = values_of(*first);
            const float* const then = points.part[k] > 0.0 ? values_of(*second) : now;
            if (misses.take())
                continue;
            take(k, value_at(
                        points, k, [&](std::size_t i) { return now[place[i]]; },
                        [&](std::size_t i) { return then[place[i]]; }));
            done[k] = 1;
        }
    };
    const bool all = MissingBricks::in_rounds(&missing, count, stop, MissingBricks::Again::Restart,
                                              [&](std::size_t begin, std::size_t end) {
                                                  parallel(begin, end, stop, sample_range);
                                                  return !stop.stop_requested();
                                              });
    if (all)
        return {};
    return missing.error() ? tl::unexpected(*missing.error())
                           : fail(Error::Code::Cancelled, "sampling was cancelled");
}

template <class Is>
bool any(std::size_t size, Is is) {
    for (std::size_t k = 0; k < size; ++k)
        if (is(k))
            return true;
    return false;
}

} // namespace

Result<std::vector<float>> sample_scalar(const Flow& flow,
                                         const ScalarSource& source,
                                         std::size_t scalar,
                                         std::span<const Vec3> positions,
                                         std::span<const double> times,
                                         const std::stop_token& stop) {
    std::vector<float> out(positions.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return times[a] < times[b]; });
    TwoSteps steps(source, scalar, stop);
    const auto field = source.brick_field(scalar);
    const auto bricks = field ? flow.bricks() : nullptr;
    std::vector<NodeShares> shares;
    std::vector<double> part;
    for (std::size_t begin = 0; begin < order.size();) {
        // A turn takes the points of one interval of time, but not too many: their shares are kept from one
        // end of it to the other.
        const std::size_t step = moment_of(source.times(), times[order[begin]]).step;
        part.clear();
        while (part.size() < most_at_once && begin + part.size() < order.size()) {
            const Moment moment = moment_of(source.times(), times[order[begin + part.size()]]);
            if (moment.step != step)
                break;
            part.push_back(moment.part);
        }
        const std::span<const std::uint32_t> points(order.data() + begin, part.size());
        begin += part.size();
        shares.resize(part.size());
        parallel(0, points.size(), stop, [&](std::size_t from, std::size_t to) {
            for (std::size_t k = from; k != to; ++k)
                shares[k] = flow.shares(positions[points[k]]);
        });
        const auto wanted = [&](std::size_t k) { return shares[k].count > 0; };
        const auto between = [&](std::size_t k) { return wanted(k) && part[k] > 0.0; };
        if (stop.stop_requested()) // unfinished places have no status
            return fail(Error::Code::Cancelled, "sampling was cancelled");
        if (!any(points.size(), wanted))
            continue;
        const Points all{shares, part};
        const bool both = any(points.size(), between);
        const auto take = [&](std::size_t k, double value) {
            if (std::isfinite(value))
                out[points[k]] = static_cast<float>(value);
        };
        const auto sampled = bricks ? sample_bricks(all, bricks, *field, step, both, take, stop)
                                    : sample_whole(all, steps, step, both, take, stop);
        if (!sampled)
            return tl::unexpected(sampled.error());
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "sampling was cancelled");
    }
    return out;
}

} // namespace wakesurf::core
