// What an animation holds is the surface at each of its times, within the tolerance that it states.
#include "core/base/clock.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/surface/playback/evolution.hpp"
#include "protocol/wire/mesh_decoder.hpp"
#include "server/live/surface_animation.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace wakesurf::server::surface_animation_test {

namespace {

SurfaceJob job_of(core::SurfaceKind kind) {
    std::shared_ptr<const core::Flow> flow = core::make_analytic_flow("double-gyre").value();
    const core::Rake rake{core::Rake::Kind::Line, {{0.5, 0.2, 0}, {0.5, 0.8, 0}}, 9};
    core::SurfaceParameters p;
    p.kind = kind;
    p.to = 2.0;
    p.separation = 0.05;
    if (kind == core::SurfaceKind::Time)
        p.sweep = core::Vec3(0.2, 0, 0);
    SurfaceJob job;
    job.plan = value_of(core::plan_surface(flow, rake, p));
    job.lattice = protocol::lattice_over(flow->domain());
    return job;
}

/// Returns the greatest distance from a vertex of the state to the place that it was computed at. Vertices
/// have another order on the wire, so the nearest one counts.
double farthest(const protocol::WireMesh& state,
                const core::QuadComplex& mesh,
                const protocol::Lattice& lattice) {
    double most = 0.0;
    for (const auto& node : state.position) {
        const core::Vec3 there =
            lattice.origin + lattice.step * core::Vec3(node[0], node[1], node[2]);
        double least = INFINITY;
        for (const core::Vec3& p : mesh.position)
            least = std::min(least, glm::length(p - there));
        most = std::max(most, least);
    }
    return most;
}

} // namespace

class SurfaceAnimation : public testing::TestWithParam<core::SurfaceKind> {};

TEST_P(SurfaceAnimation, HoldsTheSurfaceAtEachTimeWithinTheToleranceOfTheWire) {
    const SurfaceJob job = job_of(GetParam());
    const std::vector<double> times{0.0, 0.5, 0.75, 1.5, 2.0};
    core::SteadyClock clock;
    const auto made = value_of(animate(job, times, clock, {}));
    auto evolution = value_of(core::Evolution::start(job.plan, clock, {}));
    protocol::MeshDecoder decoder;
    std::size_t step = 0;
    for (std::size_t at = 0; at < made.frames.size();) {
        std::uint32_t size = 0;
        std::memcpy(&size, made.frames.data() + at, sizeof(size));
        const auto frame = std::as_bytes(std::span(made.frames)).subspan(at + sizeof(size), size);
        at += sizeof(size) + size;
        if (!value_of(decoder.fold(frame)))
            continue;
        ASSERT_LT(step, times.size());
        const auto then = value_of(evolution.at(times[step], {}));
        const auto& shown = *decoder.newest()->mesh;
        const std::size_t cells = then.mesh.mesh.cells.size();
        EXPECT_EQ(shown.cells().size(), cells) << times[step];
        EXPECT_EQ(shown.time, times[step]);
        if (cells > 0) {
            EXPECT_EQ(shown.vertices(), then.mesh.mesh.vertices());
            const double off = std::sqrt(3.0) * 2.5 * job.lattice.step;
            EXPECT_LE(farthest(shown, then.mesh.mesh, job.lattice), off) << times[step];
        }
        ++step;
    }
    EXPECT_EQ(step, times.size());
    EXPECT_GT(made.last.mesh.cells.size(), 50u);
}

INSTANTIATE_TEST_SUITE_P(EveryKind,
                         SurfaceAnimation,
                         testing::Values(core::SurfaceKind::Stream,
                                         core::SurfaceKind::Path,
                                         core::SurfaceKind::Streak,
                                         core::SurfaceKind::Time));

} // namespace wakesurf::server::surface_animation_test
