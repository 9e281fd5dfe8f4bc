// A streak surface played frame by frame, and its rake moved: what changes from frame to frame goes over a wire as updates, and a viewer at the
// other end folds them. Vertices and cells keep their ids from frame to frame, so an update is small.
#include <wakesurf/core/field/analytic_flow.hpp>
#include <wakesurf/core/surface/playback/played_surface.hpp>
#include <wakesurf/protocol/wire/mesh_decoder.hpp>
#include <wakesurf/protocol/wire/mesh_stream.hpp>

#include <cmath>
#include <cstdio>
#include <memory>

namespace ws = wakesurf::core;
namespace wire = wakesurf::protocol;

// The farthest that what the viewer has is from a circle round the vortex: no particle changes its distance from the axis.
double off_circles(const wire::WireMesh& seen, const wire::Lattice& lattice, double inner) {
    double worst = 0.0;
    for (std::size_t v = 0; v < seen.vertices(); ++v) {
        const auto& n = seen.position[v];
        const double s = seen.ranges[1].value(seen.codes[1][v]); // speed, s, t
        const double radius = std::hypot(lattice.origin.x + lattice.step * n[0],
                                         lattice.origin.y + lattice.step * n[1]);
        worst = std::fmax(worst, std::fabs(radius - (inner + s)));
    }
    return worst;
}

int main() {
    const std::shared_ptr<const ws::Flow> flow =
        ws::make_analytic_flow("lamb-oseen?rc=0.2,w=0.5").value();
    const wire::Lattice lattice = wire::lattice_over(flow->domain());
    const ws::SteadyClock clock;
    const wire::UpdateOptions playing{
        wire::Phase::Live, wire::live_tolerance}; // an error that no one sees, for fewer bytes
    wire::MeshDecoder viewer;                     // in another process, usually
    std::uint32_t epoch = 0;
    for (const double inner : {0.2, 0.3, 0.5}) { // where the rake begins: each move is an epoch
        ws::SurfaceParameters asked;
        asked.kind = ws::SurfaceKind::Streak;
        asked.to = 2.0;
        asked.separation = 0.05;
        const auto plan = ws::plan_surface(
            flow, {ws::Rake::Kind::Line, {{inner, 0, 0}, {1.0 + inner, 0, 0}}, 17}, asked);
        if (!plan)
            return 1;
        auto surface = ws::PlayedSurface::start(*plan, std::size_t{64} << 20, clock, {});
        wire::MeshStream stream(1, ++epoch, lattice);
        std::size_t first = 0, others = 0, frames = 0;
        for (double age = 1.0; surface && age < 1.2; age += 0.02) {
            const auto shown = surface->at(age, {});
            const auto update =
                shown ? stream.next(shown->mesh, playing) : tl::unexpected(shown.error());
            if (!update)
                return 1;
            for (const auto& frame : update->frames)
                if (!viewer.fold(*frame))
                    return 1;
            (frames++ == 0 ? first : others) += update->bytes;
        }
        const auto& seen = *viewer.newest();
        std::printf("rake at %.1f: %zu vertices, off by %.1e, a whole one %zu bytes, others %zu\n",
                    inner, seen.mesh->vertices(), off_circles(*seen.mesh, lattice, inner), first,
                    others / (frames - 1));
    }
}
