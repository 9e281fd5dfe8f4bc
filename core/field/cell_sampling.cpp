#include "core/field/cell_sampling.hpp"

#include "core/field/advance_particles.hpp"
#include "core/field/cells/cell_geometry.hpp"
#include "core/field/cells/cell_steps.hpp"
#include "core/field/trace_curves.hpp"

namespace wakesurf::core {

namespace {

/// Returns whether a point is no farther than rounding from where it would be in the cell. What ends at the
/// border of the domain does so a little beyond it.
bool beside(const CellCursor& place, const Vec3& point) {
    const CellGeometry& cell = place.geometry();
    const Vec3 across =
        cell.position(clamp_to_cell(cell.shape(), Vec3(1.0))) - cell.position(Vec3(0.0));
    return glm::length(cell.position(place.local()) - point) <=
           rounding_share * glm::length(across);
}

} // namespace

NodeShares CellSampling::shares(const Vec3& position) const {
    CellCursor place(domain_);
    const Vec3 in_mesh = Meridian(domain_.mesh.axis).enter(position);
    const PointStatus status = place.locate(in_mesh, false, [](std::uint32_t) { return true; });
    const bool there = status == PointStatus::Inside ||
                       (status == PointStatus::OutsideDomain &&
                        place.cell() != CellCursor::nowhere && beside(place, in_mesh));
    return there ? shares_in_cell(domain_.mesh.cells[place.cell()], place.geometry(), place.local())
                 : NodeShares{status, 0, {}, {}};
}

bool CellSampling::advance(const Interval& interval,
                           const Particles& particles,
                           double to,
                           int sign,
                           const AdvanceOptions& options,
                           const std::stop_token& stop) const {
    return interval.linear()
               ? advance_particles(field(interval), particles, to, sign, options, stop)
               : advance_particles(between(interval), particles, to, sign, options, stop);
}

bool CellSampling::trace(const Interval& interval,
                         std::span<Curve> curves,
                         const TraceOptions& options,
                         double limit,
                         const std::stop_token& stop) const {
    return interval.linear() ? trace_curves(field(interval), curves, options, limit, stop)
                             : trace_curves(between(interval), curves, options, limit, stop);
}

BetweenSampler<CellSampler> CellSampling::between(const Interval& interval) const {
    return between_sampler(interval, box_, [&](const Interval& steps) { return field(steps); });
}

CellSampler CellSampling::field(const Interval& interval) const {
    CellSampler field{&domain_, nullptr, nullptr};
    if (interval.first) {
        field.velocity0 = interval.first->velocity().data();
        field.time0 = interval.first->time;
        field.gaps = interval.first->gaps;
    }
    if (interval.second) {
        field.velocity1 = interval.second->velocity().data();
        field.interval = interval.second->time - interval.first->time;
        field.gaps = field.gaps || interval.second->gaps;
    }
    return field;
}

} // namespace wakesurf::core
