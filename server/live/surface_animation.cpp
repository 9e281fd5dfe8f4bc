#include "server/live/surface_animation.hpp"

#include "core/surface/playback/evolution.hpp"
#include "protocol/wire/mesh_encoder.hpp"
#include "protocol/wire/mesh_stream.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

core::Result<SurfaceAnimation> animate(const SurfaceJob& job,
                                       std::span<const double> times,
                                       const core::Clock& clock,
                                       const std::stop_token& stop,
                                       const core::WorkPart& work) {
    auto evolution = core::Evolution::start(job.plan, clock, stop, work);
    if (!evolution)
        return tl::unexpected(evolution.error());
    protocol::MeshStream stream(job.number, job.epoch, job.lattice);
    const bool unrelated = job.plan.parameters.kind == core::SurfaceKind::Level;
    SurfaceAnimation out;
    AnnouncedRanges ranges;
    for (std::size_t k = 0; k < times.size(); ++k) {
        auto state = evolution->at(times[k], stop, work);
        if (!state)
            return tl::unexpected(state.error());
        auto fields = sample_fields(
            job.fields, *job.plan.flow, job.scalars.get(), state->mesh.mesh,
            [&] { return state->times; }, stop);
        if (!fields)
            return tl::unexpected(fields.error());
        state->mesh.time = times[k];
        ranges.add(ranges_of(job, state->mesh.mesh, *fields, times[k]), false);
        auto update =
            stream.next(state->mesh, {Phase::Live, protocol::live_tolerance, unrelated}, *fields);
        if (!update)
            return tl::unexpected(update.error());
        protocol::append_with_lengths(out.frames, update->frames);
        // Of a level set nothing is kept from one time to the next.
        if (auto room = unrelated ? work.holds(out.frames.size()) : work.takes(update->bytes);
            !room)
            return tl::unexpected(room.error());
        const std::size_t vertices = state->mesh.mesh.vertices();
        out.most_vertices = std::max(out.most_vertices, vertices);
        out.all_vertices += vertices;
        if (k + 1 == times.size())
            out.last = {std::move(state->mesh.mesh), std::move(state->statistics), {}};
    }
    out.times.assign(times.begin(), times.end());
    out.ranges = ranges.announced();
    return out;
}

} // namespace wakesurf::server
