#include "core/field/rectilinear_axes.hpp"

#include <limits>

namespace wakesurf::core {

namespace {

std::vector<CellReach> reaches(const std::vector<double>& x) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const std::size_t last = x.size() - 2;
    const auto length = [&](std::size_t from, std::size_t to) {
        return static_cast<float>(x[to] - x[from]);
    };
    const auto per_width = [&](std::size_t cell) {
        return static_cast<float>(1.0 / (x[cell + 1] - x[cell]));
    };
    std::vector<CellReach> reach(last + 1);
    for (std::size_t i = 0; i <= last; ++i) {
        const std::size_t before = i == 0 ? 0 : i - 1;
        const std::size_t after = i == last ? last : i + 1;
        CellReach& r = reach[i];
        r.lowest = -length(before, i);
        r.below = before == 0 ? -infinite : r.lowest;
        r.above = after == last ? infinite : length(i, after + 1);
        r.begin = i == 0 ? -infinite : 0.0f;
        r.end = i == last ? infinite : length(i, i + 1);
        r.per_width_before = per_width(before);
        r.per_width = per_width(i);
        r.per_width_after = per_width(after);
    }
    return reach;
}

} // namespace

RectilinearAxes::RectilinearAxes(const RectilinearGrid& grid) : bounds_(grid.bounds()) {
    constexpr std::size_t buckets_a_node = 2;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<double>& x = grid.coordinates[axis];
        Axis& a = axes_[axis];
        a.coordinate = x.data();
        a.last = x.size() - 2;
        const std::size_t buckets = buckets_a_node * x.size();
        a.per_bucket = static_cast<double>(buckets) / (x.back() - x.front());
        a.start.resize(buckets + 1);
        std::size_t cell = 0;
        for (std::size_t bucket = 0; bucket <= buckets; ++bucket) {
            const double edge = x.front() + static_cast<double>(bucket) / a.per_bucket;
            while (cell < a.last && x[cell + 1] <= edge)
                ++cell;
            a.start[bucket] = static_cast<std::uint32_t>(cell);
        }
        a.reach = reaches(x);
        tables_[axis] = {a.coordinate,
                         a.start.data(),
                         a.per_bucket,
                         static_cast<double>(buckets),
                         static_cast<std::uint32_t>(a.last),
                         a.reach.data()};
        dimensions_[axis] = static_cast<std::uint32_t>(x.size());
    }
}

std::size_t RectilinearAxes::bytes() const {
    std::size_t sum = 0;
    for (const Axis& axis : axes_)
        sum +=
            axis.start.size() * sizeof(axis.start[0]) + axis.reach.size() * sizeof(axis.reach[0]);
    return sum;
}

} // namespace wakesurf::core
