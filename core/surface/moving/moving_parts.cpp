#include "core/surface/moving/moving_parts.hpp"

#include "core/surface/surface_request.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

Result<std::vector<MovingPart>> moving_parts(const Flow& flow,
                                             const SurfaceParameters& parameters) {
    SurfaceParameters p = parameters;
    if (!(p.separation > 0.0))
        p.separation = flow.finest_spacing();
    if (parameters.direction == Direction::Both)
        p.max_quads = std::max<std::uint64_t>(p.max_quads / 2, 1);
    std::vector<MovingPart> parts;
    for (const Direction direction : {Direction::Forward, Direction::Backward}) {
        if (parameters.direction != Direction::Both && parameters.direction != direction)
            continue;
        const double sign = direction == Direction::Backward ? -1.0 : 1.0;
        p.direction = direction;
        if (auto in_time = check_times(flow, p, sign * std::abs(p.to - p.from)); !in_time)
            return tl::unexpected(in_time.error());
        parts.push_back({p, sign});
    }
    return parts;
}

} // namespace wakesurf::core
