// A time-step source that samples a formula on a mesh of cells: stored data without files.
#pragma once

#include "core/field/stored_flow.hpp"
#include "tests/support/cell_meshes.hpp"

#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace wakesurf::tests {

/// Samples a formula on the nodes of a cell mesh at given times.
class MeshedSource final : public core::TimeStepSource {
  public:
    using Velocity = std::function<Vec3(const Vec3&, double)>;

    MeshedSource(CellMesh mesh, std::vector<double> times, Velocity velocity)
        : grid_(std::move(mesh)), times_(std::move(times)), velocity_(std::move(velocity)) {}

    const core::Grid& grid() const override { return grid_; }

    const core::SolidMask& mask() const override { return mask_; }

    const std::vector<double>& times() const override { return times_; }

    bool ready(std::size_t) const override { return true; }

    std::size_t bytes_per_step() const override { return core::node_count(grid_) * 12; }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token) const override {
        auto step = std::make_shared<core::TimeStep>();
        step->index = index;
        step->time = times_[index];
        step->slab = core::Slab(bytes_per_step());
        const std::vector<float> values = at_nodes(
            std::get<CellMesh>(grid_), [&](const Vec3& p) { return velocity_(p, times_[index]); });
        std::memcpy(step->slab.bytes().data(), values.data(), bytes_per_step());
        for (const float value : values)
            step->gaps = step->gaps || !std::isfinite(value);
        return std::shared_ptr<const core::TimeStep>(std::move(step));
    }

  private:
    core::Grid grid_;
    core::SolidMask mask_;
    std::vector<double> times_;
    Velocity velocity_;
};

inline std::unique_ptr<core::Flow>
meshed_flow(CellMesh mesh, std::vector<double> times, MeshedSource::Velocity velocity) {
    auto source =
        std::make_shared<MeshedSource>(std::move(mesh), std::move(times), std::move(velocity));
    return core::make_stored_flow(
        std::make_shared<core::TimeStepCache>(source, core::TimeStepCache::Options{}));
}

} // namespace wakesurf::tests
