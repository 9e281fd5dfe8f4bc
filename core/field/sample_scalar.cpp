#include "core/field/sample_scalar.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
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

// The two time-steps last asked for: in order of time that is all it takes.
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

/// Calls `each` with the numbers below `size`, until `stop` fires.
template <class Each>
void parallel(std::size_t size, const std::stop_token& stop, Each each) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, size, 1024), [&](const auto& range) {
        if (!stop.stop_requested())
            for (std::size_t k = range.begin(); k != range.end(); ++k)
                each(k);
    });
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
    std::vector<NodeShares> shares;
    std::vector<double> part;
    for (std::size_t begin = 0; begin < order.size();) {
        // The points of one interval of time, but not too many: their shares are kept from one end of it to the other.
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
        parallel(points.size(), stop,
                 [&](std::size_t k) { shares[k] = flow.shares(positions[points[k]]); });
        const auto wanted = [&](std::size_t k) { return shares[k].count > 0; };
        const auto between = [&](std::size_t k) { return wanted(k) && part[k] > 0.0; };
        if (!any(points.size(), wanted))
            continue;
        const auto first = steps.values(step);
        if (!first)
            return tl::unexpected(first.error());
        const auto second = any(points.size(), between) ? steps.values(step + 1) : first;
        if (!second)
            return tl::unexpected(second.error());
        parallel(points.size(), stop, [&](std::size_t k) {
            if (!wanted(k))
                return;
            const auto at = [&](const float* values) {
                return weighed(shares[k], [values](std::size_t node) { return values[node]; });
            };
            double value = at(*first);
            if (part[k] > 0.0)
                value += part[k] * (at(*second) - value);
            if (std::isfinite(value))
                out[points[k]] = static_cast<float>(value);
        });
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "sampling was cancelled");
    }
    return out;
}

} // namespace wakesurf::core
