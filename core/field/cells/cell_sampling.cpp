#include "core/field/cells/cell_sampling.hpp"

#include "core/field/advance_particles.hpp"
#include "core/field/cells/cell_steps.hpp"
#include "core/field/trace_curves.hpp"

namespace wakesurf::core {

NodeShares CellSampling::shares(const Vec3& position) const {
    CellCursor place(domain_);
    NodeShares shares;
    shares.status = place.locate(position, false, [](std::uint32_t) { return true; });
    if (shares.status != PointStatus::Inside)
        return shares;
    const MeshCell& cell = domain_.mesh.cells[place.cell()];
    shares.count = node_count(cell.shape);
    for (std::size_t i = 0; i < shares.count; ++i) {
        // What the node's value is multiplied by is what a field returns that is one there and zero at the others.
        CellPolynomial one_here;
        one_here.fit(cell.shape, [&](std::size_t node) {
            Components value;
            value.z[0] = node == i ? 1.0 : 0.0;
            return value;
        });
        shares.node[i] = cell.node[i];
        shares.share[i] = one_here.at(place.geometry().pyramid(), place.local()).z[0];
    }
    return shares;
}

bool CellSampling::advance(const Interval& interval,
                           const Particles& particles,
                           double to,
                           int sign,
                           const AdvanceOptions& options,
                           const std::stop_token& stop) const {
    return advance_particles(field(interval), particles, to, sign, options, stop);
}

bool CellSampling::trace(const Interval& interval,
                         std::span<Curve> curves,
                         const TraceOptions& options,
                         double limit,
                         const std::stop_token& stop) const {
    return trace_curves(field(interval), curves, options, limit, stop);
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
