#include "core/field/flow.hpp"

#include <algorithm>
#include <vector>

namespace wakesurf::core {

Result<void> Flow::sample_at(std::span<const Vec3> positions,
                             double time,
                             std::span<Vec3f> velocities,
                             std::stop_token stop,
                             bool smooth,
                             std::span<std::uint32_t>) const {
    const std::vector<double> times(positions.size(), time);
    std::vector<Vec3> exact(positions.size());
    return sample(positions, times, exact, std::move(stop), smooth).map([&] {
        std::transform(exact.begin(), exact.end(), velocities.begin(),
                       [](const Vec3& v) { return Vec3f(v); });
    });
}

} // namespace wakesurf::core
