#include "server/sessions/records/older_surface.hpp"

#include "core/surface/time_direction.hpp"

namespace wakesurf::server {

core::SurfaceParameters from_older(core::SurfaceParameters p) {
    p.direction = core::direction_of(p);
    if (p.direction != core::Direction::Backward || !(p.to > p.from))
        return p;
    p.to = 2.0 * p.from - p.to;
    if (p.release_until && *p.release_until > p.from)
        p.release_until = 2.0 * p.from - *p.release_until;
    return p;
}

} // namespace wakesurf::server
