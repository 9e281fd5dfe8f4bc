// A time-step source that samples a formula on a uniform or rectilinear grid: stored data without files.
#pragma once

#include "core/dataset/time_step_source.hpp"

#include <atomic>
#include <cstring>
#include <functional>
#include <utility>

namespace wakesurf::tests {

class SampledSource final : public core::TimeStepSource {
  public:
    using Velocity = std::function<core::Vec3(const core::Vec3&, double)>;

    SampledSource(core::Grid grid,
                  std::vector<double> times,
                  Velocity velocity,
                  core::SolidMask mask = {})
        : grid_(std::move(grid)), times_(std::move(times)), velocity_(std::move(velocity)),
          mask_(std::move(mask)) {}

    const core::Grid& grid() const override { return grid_; }

    const core::SolidMask& mask() const override { return mask_; }

    const std::vector<double>& times() const override { return times_; }

    core::PeriodicAxes periodic() const override { return periodic_axes; }

    bool ready(std::size_t) const override { return true; }

    std::size_t bytes_per_step() const override { return core::node_count(grid_) * 12; }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token) const override {
        ++loads;
        if (index == broken)
            return core::fail(core::Error::Code::Corrupt,
                              "time-step " + std::to_string(index) + " is damaged");
        auto step = std::make_shared<core::TimeStep>();
        step->index = index;
        step->time = times_[index];
        step->slab = core::Slab(bytes_per_step());
        auto* out = reinterpret_cast<float*>(step->slab.bytes().data());
        for (std::size_t node = 0; node < core::node_count(grid_); ++node) {
            const bool solid = !mask_.empty() && mask_.fluid[node] == 0;
            const core::Vec3 v = solid ? core::Vec3(0.0) : velocity_(position(node), times_[index]);
            for (int axis = 0; axis < 3; ++axis)
                *out++ = static_cast<float>(v[axis]);
            step->gaps = step->gaps || !core::finite(v);
        }
        return step;
    }

    /// Returns the position of a node, x fastest.
    core::Vec3 position(std::size_t node) const {
        if (const auto* mesh = std::get_if<core::CellMesh>(&grid_))
            return mesh->points[node];
        if (const auto* rectilinear = std::get_if<core::RectilinearGrid>(&grid_)) {
            const auto& [x, y, z] = rectilinear->coordinates;
            return {x[node % x.size()], y[node / x.size() % y.size()],
                    z[node / (x.size() * y.size())]};
        }
        const auto& uniform = std::get<core::UniformGrid>(grid_);
        const std::size_t nx = uniform.dimensions[0];
        const std::size_t ny = uniform.dimensions[1];
        return uniform.origin +
               uniform.spacing * core::Vec3(node % nx, node / nx % ny, node / (nx * ny));
    }

    mutable std::atomic<int> loads{0};
    core::PeriodicAxes periodic_axes{};
    std::atomic<std::size_t> broken{~std::size_t{0}}; ///< the time-step that cannot be read

  private:
    core::Grid grid_;
    std::vector<double> times_;
    Velocity velocity_;
    core::SolidMask mask_;
};

} // namespace wakesurf::tests
