// A flow whose boundary has patches by name: a part of a body, an inlet and a wall in a side of the domain.
#pragma once

#include "core/field/flow.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>

namespace wakesurf::tests {

/// A uniform flow whose boundary has patches: a hull about z = 0, an inlet at x = -1 and a floor at z = -1.
class PatchedFlow final : public core::Flow {
  public:
    core::Box domain() const override { return {core::Vec3(-1.0), core::Vec3(1.0)}; }

    std::optional<std::array<double, 2>> time_range() const override { return std::nullopt; }

    double finest_spacing() const override { return 0.1; }

    core::PointStatus status(const core::Vec3&) const override { return core::PointStatus::Inside; }

    core::Result<core::TraceCost>
    trace(std::span<core::Curve>, const core::TraceOptions&, std::stop_token) const override {
        return core::TraceCost{};
    }

    core::Result<core::TraceCost> advance(const core::Particles&,
                                          double,
                                          const core::AdvanceOptions&,
                                          std::stop_token) const override {
        return core::TraceCost{};
    }

    bool few_data(double, double) const override { return true; }

    bool obstacle() const override { return true; }

    core::Result<void> sample(std::span<const core::Vec3>,
                              std::span<const double>,
                              std::span<core::Vec3> velocities,
                              std::stop_token,
                              bool) const override {
        std::ranges::fill(velocities, core::Vec3(3.0, 4.0, 0.0));
        return {};
    }

    core::WallGeometry walls() const override {
        core::WallGeometry out;
        out.points = {{-0.2F, -0.2F, 0}, {0.2F, -0.2F, 0}, {0.2F, 0.2F, 0}, {-0.2F, 0.2F, 0},
                      {-1, 0, 0},        {-1, 1, 0},       {-1, 0, 1},      {0, 0, -1},
                      {1, 0, -1},        {0, 1, -1},       {1, 1, -1}};
        out.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {7, 8, 9}, {8, 10, 9}};
        out.patches = {{"hull", core::BoundaryPatch::Kind::Wall, 2},
                       {"inlet", core::BoundaryPatch::Kind::Other, 1},
                       {"floor", core::BoundaryPatch::Kind::Side, 2}};
        return out;
    }
};

} // namespace wakesurf::tests
