#include "core/field/rectilinear_axes.hpp"

namespace wakesurf::core {

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
        dimensions_[axis] = static_cast<std::uint32_t>(x.size());
    }
}

std::size_t RectilinearAxes::bytes() const {
    std::size_t sum = 0;
    for (const Axis& axis : axes_)
        sum += axis.start.size() * sizeof(axis.start[0]);
    return sum;
}

} // namespace wakesurf::core
