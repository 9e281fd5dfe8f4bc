// A store of any grid with scalars that are formulas, for tests and benchmarks of what reads them.
#pragma once

#include "core/field/stored_flow.hpp"
#include "store/store_grid.hpp"
#include "tests/support/small_store.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace wakesurf::tests {

using ScalarFormula = std::function<double(const core::Vec3& place, double time)>;

inline std::vector<core::Vec3> nodes_of(const core::Grid& grid) {
    if (const auto* mesh = std::get_if<core::CellMesh>(&grid))
        return mesh->points;
    core::RectilinearGrid along;
    if (const auto* uniform = std::get_if<core::UniformGrid>(&grid)) {
        for (std::size_t k = 0; k < 3; ++k)
            for (std::uint32_t i = 0; i < uniform->dimensions[k]; ++i)
                along.coordinates[k].push_back(uniform->origin[static_cast<int>(k)] +
                                               uniform->spacing[static_cast<int>(k)] * i);
    } else {
        along = std::get<core::RectilinearGrid>(grid);
    }
    std::vector<core::Vec3> nodes;
    for (const double z : along.coordinates[2])
        for (const double y : along.coordinates[1])
            for (const double x : along.coordinates[0])
                nodes.emplace_back(x, y, z);
    return nodes;
}

/// A store with the velocity (1, 0, 0). @param solid  nodes of an obstacle; none of a mesh of cells
class ScalarStore {
  public:
    ScalarStore(const core::Grid& grid,
                std::vector<double> times,
                const std::vector<std::pair<std::string, ScalarFormula>>& scalars,
                const std::function<bool(const core::Vec3&)>& solid = {}) {
        store::StoreLayout layout;
        layout.folder = folder_.path();
        layout.grid = store::stored_grid(grid);
        layout.times = std::move(times);
        for (const store::GridFile& file : store::grid_files(grid))
            put_fixed(layout, file.name,
                      {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
        const auto nodes = nodes_of(grid);
        if (solid) {
            std::vector<std::uint8_t> fluid;
            for (const core::Vec3& node : nodes)
                fluid.push_back(solid(node) ? 0 : 1);
            layout.mask = true;
            put_fixed(layout, std::string(store::mask_file_name), bytes_of(fluid));
        }
        for (const auto& [name, formula] : scalars)
            layout.scalars.push_back({name, name});
        std::vector<float> velocity;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            velocity.insert(velocity.end(), {1.0F, 0.0F, 0.0F});
        for (std::size_t step = 0; step < layout.times.size(); ++step) {
            std::vector<std::uint32_t> sums{
                put_values(layout, store::velocity_stem, step, velocity)};
            for (const auto& [name, formula] : scalars) {
                std::vector<float> values;
                for (const core::Vec3& node : nodes)
                    values.push_back(static_cast<float>(formula(node, layout.times[step])));
                sums.push_back(put_values(layout, name, step, values));
            }
            append_checksums(layout, sums);
        }
        reader_ = open_layout(layout).value();
        flow_ = core::make_stored_flow(
            std::make_shared<core::TimeStepCache>(reader_, core::TimeStepCache::Options{}));
    }

    const std::shared_ptr<const store::StoreReader>& reader() const { return reader_; }

    const std::shared_ptr<const core::Flow>& flow() const { return flow_; }

  private:
    TemporaryFolder folder_;
    std::shared_ptr<const store::StoreReader> reader_;
    std::shared_ptr<const core::Flow> flow_;
};

} // namespace wakesurf::tests
