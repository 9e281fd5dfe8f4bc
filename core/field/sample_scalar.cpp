#include "core/field/sample_scalar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

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
    TwoSteps(const StoreReader& store, std::size_t scalar, const std::stop_token& stop)
        : store_(store), scalar_(scalar), stop_(stop) {}

    Result<const float*> values(std::size_t step) {
        Held& held = held_[step % 2];
        if (!held.slab || held.step != step) {
            held.slab.reset(); // before the next is read: never three in memory
            auto loaded = store_.load_scalar(scalar_, step, stop_);
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
        std::optional<Slab> slab;
    };

    const StoreReader& store_;
    std::size_t scalar_;
    const std::stop_token& stop_;
    std::array<Held, 2> held_;
};

double weighed(const NodeShares& shares, const float* values) {
    double sum = 0.0;
    for (std::size_t i = 0; i < shares.count; ++i)
        sum += shares.share[i] * values[shares.node[i]];
    return sum;
}

} // namespace

std::size_t scalar_memory(const StoreReader& store) {
    if (store.layout().scalars.empty())
        return 0;
    return 2 * Slab::reservation(step_file_size(store.layout().grid.nodes(), 1, Precision::Single));
}

Result<std::size_t> find_scalar(const StoreLayout& layout, std::string_view name) {
    std::string all;
    for (std::size_t i = 0; i < layout.scalars.size(); ++i) {
        if (layout.scalars[i].name == name)
            return i;
        all += (all.empty() ? "" : ", ") + layout.scalars[i].name;
    }
    return fail(Error::Code::NotFound, "there is no scalar field " + std::string(name),
                all.empty() ? "the dataset holds no scalar fields" : "there is " + all);
}

Result<std::vector<float>> sample_scalar(const Flow& flow,
                                         const StoreReader& store,
                                         std::size_t scalar,
                                         std::span<const Vec3> positions,
                                         std::span<const double> times,
                                         const std::stop_token& stop) {
    std::vector<float> out(positions.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return times[a] < times[b]; });
    TwoSteps steps(store, scalar, stop);
    for (const std::uint32_t i : order) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "sampling was cancelled");
        const NodeShares shares = flow.shares(positions[i]);
        if (shares.count == 0)
            continue;
        const Moment moment = moment_of(store.times(), times[i]);
        const auto first = steps.values(moment.step);
        if (!first)
            return tl::unexpected(first.error());
        double value = weighed(shares, *first);
        if (moment.part > 0.0) {
            const auto second = steps.values(moment.step + 1);
            if (!second)
                return tl::unexpected(second.error());
            value += moment.part * (weighed(shares, *second) - value);
        }
        if (std::isfinite(value))
            out[i] = static_cast<float>(value);
    }
    return out;
}

} // namespace wakesurf::core
