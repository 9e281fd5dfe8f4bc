// One live surface, its jobs run by hand, looked at by a client that folds what it is sent.
#pragma once

#include "core/field/analytic_flow.hpp"
#include "protocol/wire/mesh_decoder.hpp"
#include "server/live/live_surface.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Every look at it takes `each`: jobs last as long as they look often.
class LookedAtClock final : public core::Clock {
  public:
    std::chrono::steady_clock::time_point now() const override { return time += each; }

    mutable std::chrono::steady_clock::time_point time{};
    std::chrono::microseconds each{0};
};

inline SurfaceJob job_of(core::SurfaceKind kind, double separation = 0.2) {
    SurfaceJob job;
    core::SurfaceParameters p;
    const core::Rake rake{core::Rake::Kind::Line, {{0, 0, 0}, {0, 2, 0}}, 9};
    p.kind = kind;
    p.to = 2.0;
    p.separation = separation;
    if (kind == core::SurfaceKind::Time)
        p.sweep = core::Vec3(1, 0, 0);
    job.plan = core::plan_surface(*core::make_analytic_flow("abc"), rake, p).value();
    job.lattice = protocol::lattice_over(core::describe_analytic_flow("abc")->bounds);
    return job;
}

class LiveSurfaceTest : public testing::Test {
  protected:
    /// Runs one job, if one waits, and what follows from it.
    bool turn() {
        const bool ran = pool.turn();
        loop.advance(std::chrono::milliseconds(0));
        return ran;
    }

    /// Runs all jobs and folds what a client that looks on is sent.
    void settle() {
        do
            look();
        while (turn());
    }

    void look() {
        while (const auto frame = viewer.next())
            if (const auto folded = decoder.fold(*frame); !folded)
                ADD_FAILURE() << folded.error().message;
            else if (*folded)
                seen.push_back({decoder.newest()->header, decoder.newest()->mesh->vertices()});
    }

    /// Cells of the surface built at once, on its own.
    std::size_t cells_at(core::SurfaceKind kind, double time) {
        SurfaceBuild build(job_of(kind), wall);
        return build.run({Phase::Final, 0, time}, {})->statistics.quads;
    }

    struct Seen {
        protocol::FrameHeader header;
        std::size_t vertices;
    };

    HandClock hand;
    LookedAtClock wall;
    HandLoop loop{hand};
    ComputePool pool{ComputePool::ByHand{}};
    std::vector<std::pair<std::uint32_t, Phase>> progress;
    std::vector<PassSeconds> took;
    std::vector<SurfaceOutcome> done;
    std::shared_ptr<LiveSurface> surface = std::make_shared<LiveSurface>(
        "s1",
        3,
        "main",
        LiveSurface::Services{loop, pool, wall, nullptr},
        LiveSurface::Events{[this](const SurfaceProgress& now) {
                                progress.emplace_back(now.epoch, now.phase);
                                took.push_back(now.took);
                            },
                            [this](const SurfaceOutcome& outcome) { done.push_back(outcome); }});
    FrameCursor viewer{surface->ring(), {}, [](bool) {}};
    protocol::MeshDecoder decoder;
    std::vector<Seen> seen;
};

} // namespace wakesurf::server
