// Made by protocol/api/generate from surface.schema.json: do not edit.
#include "core/surface/request/surface_values.hpp"

#include "core/surface/time_direction.hpp"

#include <string>

namespace wakesurf::core {

namespace {

tl::unexpected<Error> wrong(const std::string& message, const std::string& hint) {
    return fail(Error::Code::InvalidArgument, message, hint);
}

} // namespace

Result<void> check_kind(const SurfaceParameters& p) {
    if (p.rake2 && p.kind != SurfaceKind::Time)
        return wrong("`rake2` belongs to time surfaces", "leave it out");
    if (p.release_until && p.kind != SurfaceKind::Streak)
        return wrong("`releaseUntil` belongs to streak surfaces", "leave it out");
    if (p.life && p.kind != SurfaceKind::Path && p.kind != SurfaceKind::Streak &&
        p.kind != SurfaceKind::Time)
        return wrong("`life` belongs to path, streak or time surfaces", "leave it out");
    if (p.sweep && p.kind != SurfaceKind::Time)
        return wrong("`sweep` belongs to time surfaces", "leave it out");
    if (p.field && p.kind != SurfaceKind::Level)
        return wrong("`field` belongs to level surfaces", "leave it out");
    if (p.level && p.kind != SurfaceKind::Level)
        return wrong("`level` belongs to level surfaces", "leave it out");
    if (p.kind == SurfaceKind::Level && !p.field)
        return wrong("a level surface needs `field`",
                     "scalar field of the dataset, or derived from its velocity, of which the "
                     "surface is a level set: its magnitude by the velocity's name, `vorticity`, "
                     "`q_criterion`, `velocity_x` and the like");
    if (p.kind == SurfaceKind::Level && !p.level)
        return wrong("a level surface needs `level`", "value that the field has on the surface");
    if (p.kind == SurfaceKind::Time && p.rake2.has_value() == p.sweep.has_value())
        return wrong("a time surface takes one of `rake2` and `sweep`",
                     "the patch lies between two rakes, or is one swept along a vector");
    if (p.sweep && !(finite(*p.sweep) && glm::length(*p.sweep) > 0.0))
        return wrong("`sweep` has no length", "give a finite vector that is not zero");
    return {};
}

Result<void> check_values(const SurfaceParameters& p) {
    if (auto fits = check_kind(p); !fits)
        return fits;
    if (p.release_until && !between(*p.release_until, p.from, p.to))
        return wrong("`releaseUntil` " + time_text(*p.release_until) +
                         " does not lie between `from` " + time_text(p.from) + " and `to` " +
                         time_text(p.to),
                     "leave it out, or choose a time between them");
    if (p.life && !(*p.life > 0.0))
        return wrong("`life` must be a number greater than 0", "leave it out, or correct it");
    if (!(p.merge >= 0.0 && p.merge <= 0.5))
        return wrong("`merge` must be a number between 0 and 0.5", "leave it out for the default");
    if (!(p.angle > 0.0 && p.angle <= 180.0))
        return wrong("`angle` must be a number greater than 0 and at most 180",
                     "leave it out for the default");
    if (!(p.stagnation_speed >= 0.0 && p.stagnation_speed <= 0.1))
        return wrong("`stagnationSpeed` must be a number between 0 and 0.1",
                     "leave it out for the default");
    if (!(p.max_quads >= 1))
        return wrong("`maxQuads` must be at least 1", "leave it out for the default");
    return {};
}

} // namespace wakesurf::core
