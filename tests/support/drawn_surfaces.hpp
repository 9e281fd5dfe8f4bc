// Surfaces of all kinds through closed forms, and the distance of their drawn cells, flat or tessellated,
// from the exact ones.
#pragma once

#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/patches/tessellation.hpp"
#include "core/surface/surface.hpp"
#include "tests/support/exact_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::tests {

struct DrawnCase {
    std::string name;
    std::string flow;
    core::Rake rake;
    core::SurfaceParameters parameters;
};

inline std::vector<DrawnCase> drawn_cases() {
    using core::Rake;
    using core::Vec3;
    using Kind = core::SurfaceKind;
    const Rake radial{Rake::Kind::Line, {{0.2, 0, 0}, {1.4, 0, 0}}, 4};
    const Rake line{Rake::Kind::Line, {{0.4, 0.1, 0.3}, {0.5, 0.9, 1.5}}, 4};
    const Rake upright{Rake::Kind::Line, {{0.6, 0.2, 0}, {0.8, 0.3, 1}}, 4};
    const Rake low{Rake::Kind::Line, {{0.4, 0.25, -0.4}, {0.45, 0.25, 0.4}}, 4};
    const Rake circle{Rake::Kind::Circle, {{0, 0, 0}, {1, 0, 0.3}, {0, 1, 0}}, 6};
    const core::SurfaceParameters stream{.kind = Kind::Stream, .to = 2.0};
    const core::SurfaceParameters path{.kind = Kind::Path, .to = 2.0};
    const core::SurfaceParameters streak{.kind = Kind::Streak, .to = 1.0};
    const core::SurfaceParameters time{.kind = Kind::Time, .to = 1.5, .sweep = Vec3(0.1, 0.2, 1.0)};
    return {{"stream/helicoid", "rotation", radial, stream},
            {"stream/lamb-oseen", "lamb-oseen?rc=0.5", radial, stream},
            {"stream/abc", "abc", line, stream},
            {"stream/abc/circle", "abc", circle, stream},
            {"path/rotating-strain", "rotating-strain?w=0.3", upright, path},
            {"path/double-gyre", "double-gyre", low, {.kind = Kind::Path, .to = 3.0}},
            {"streak/oscillating", "oscillating", upright, {.kind = Kind::Streak, .to = 2.0}},
            {"streak/abc", "abc", line, streak},
            {"time/double-gyre",
             "double-gyre",
             low,
             {.kind = Kind::Time, .to = 1.5, .sweep = Vec3(0.8, 0.2, 0.1)}},
            {"time/abc", "abc", line, time}};
}

/// A surface whose vertices are exact; a case is refined by its separation alone.
struct DrawnSurface {
    std::shared_ptr<const core::Flow> flow;
    core::SurfacePlan plan;
    core::Surface surface;

    DrawnSurface(std::shared_ptr<const core::Flow> through,
                 const core::Rake& rake,
                 core::SurfaceParameters p)
        : flow(std::move(through)) {
        p.accuracy = core::Accuracy::Exact;
        p.tangents = true;
        plan = *core::plan_surface(flow, rake, p);
        surface = *core::build_surface(plan);
    }

    DrawnSurface(const DrawnCase& c, double separation)
        : DrawnSurface(*core::make_analytic_flow(c.flow), c.rake, by_separation(c, separation)) {}

    static core::SurfaceParameters by_separation(const DrawnCase& c, double separation) {
        core::SurfaceParameters p = c.parameters;
        p.separation = separation;
        p.angle = 180.0;
        p.merge = 0.0;
        return p;
    }

    core::Tessellation cut(std::uint32_t pieces) const {
        auto times = core::vertex_times(surface, plan.parameters);
        return *core::tessellate(plan, surface.mesh, times, pieces, {});
    }

    /// Cuts with the same vertices, those between on straight sides and in flat cells.
    core::Tessellation cut_flat(std::uint32_t pieces) const {
        core::QuadComplex bare = surface.mesh;
        for (core::SurfaceTangents& each : bare.tangents)
            each = {core::Vec3(0.0), core::Vec3(0.0)};
        auto times = core::vertex_times(surface, plan.parameters);
        return *core::tessellate(plan, bare, times, pieces, {});
    }
};

/// The root of the mean square and the largest distance from the exact surface.
struct DrawnError {
    double rms = 0.0, most = 0.0;
};

/// Measures some points of a mesh, from vertex `first` on.
inline DrawnError drawn_error(const DrawnSurface& of,
                              const core::QuadComplex& mesh,
                              std::size_t first,
                              std::size_t looked_at) {
    std::size_t step = std::max<std::size_t>(1, (mesh.vertices() - first) / looked_at);
    while (step % 2 == 0 || step % 3 == 0) // not always the same place in a cell
        ++step;
    std::vector<core::VertexId> some;
    for (std::size_t v = first; v < mesh.vertices(); v += step)
        some.push_back(static_cast<core::VertexId>(v));
    DrawnError error;
    double found = 0.0;
    for (const auto& distance :
         ExactSheet(*of.flow, of.plan.rake, of.plan.parameters).distances(mesh, some))
        if (distance) {
            error.rms += distance->across * distance->across;
            error.most = std::max(error.most, distance->across);
            ++found;
        }
    error.rms = std::sqrt(error.rms / found);
    return error;
}

} // namespace wakesurf::tests
