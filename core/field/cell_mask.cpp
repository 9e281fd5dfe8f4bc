#include "core/field/grid_sampler.hpp"

namespace wakesurf::core {

CellMask::CellMask(const UniformGrid& grid, const SolidMask& mask) {
    if (mask.empty())
        return;
    state_.assign(grid.nodes(), Fluid);
    for (std::uint32_t z = 0; z + 1 < grid.dimensions[2]; ++z)
        for (std::uint32_t y = 0; y + 1 < grid.dimensions[1]; ++y)
            for (std::uint32_t x = 0; x + 1 < grid.dimensions[0]; ++x) {
                const std::size_t node =
                    (std::size_t{z} * grid.dimensions[1] + y) * grid.dimensions[0] + x;
                int fluid = 0;
                for (const std::size_t corner : corners(grid, {node, Vec3(0.0)}).node)
                    fluid += mask.fluid[corner] != 0;
                state_[node] = fluid == 8 ? Fluid : fluid == 0 ? Solid : Mixed;
            }
}

} // namespace wakesurf::core
