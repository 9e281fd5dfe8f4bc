// Random surfaces: from a rake at random in the middle of a closed form's domain.
#pragma once

#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"

#include <array>
#include <memory>
#include <random>
#include <string>
#include <utility>

namespace wakesurf::tests {

constexpr std::array<std::pair<core::SurfaceKind, const char*>, 4> every_kind{
    {{core::SurfaceKind::Stream, "stream"},
     {core::SurfaceKind::Path, "path"},
     {core::SurfaceKind::Streak, "streak"},
     {core::SurfaceKind::Time, "time"}}};

struct AskedSurface {
    std::unique_ptr<core::Flow> flow;
    core::Rake rake;
    core::SurfaceParameters parameters;

    core::Result<core::Surface> built() const {
        return core::build_surface(*flow, rake, parameters);
    }
};

/// Returns the same for the same state of `random`, on every machine. @param separation  of the rake's length
inline AskedSurface surface_anywhere(const core::AnalyticEntry& entry,
                                     core::SurfaceKind kind,
                                     double separation,
                                     std::mt19937& random) {
    const auto within = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / std::mt19937::max();
    };
    const auto vector = [&](double reach) {
        const double x = within(-reach, reach);
        const double y = within(-reach, reach);
        return core::Vec3(x, y, within(-reach, reach)) * entry.box.extent();
    };
    const core::Vec3 a = entry.box.lo + 0.5 * entry.box.extent() + vector(0.2);
    const core::Vec3 along = vector(0.15);
    AskedSurface asked{*core::make_analytic_flow(std::string(entry.name)),
                       {core::Rake::Kind::Line, {a, a + along}, 12},
                       {}};
    asked.parameters.kind = kind;
    asked.parameters.to = within(1.0, 6.0);
    asked.parameters.separation = separation * glm::length(along);
    if (kind == core::SurfaceKind::Time)
        asked.parameters.sweep = vector(0.1);
    return asked;
}

} // namespace wakesurf::tests
