#include "core/field/cell_mask.hpp"

namespace wakesurf::core {

CellMask::CellMask(const std::array<std::uint32_t, 3>& dimensions, const SolidMask& mask) {
    if (mask.empty())
        return;
    const std::size_t row = dimensions[0];
    const std::size_t slice = row * dimensions[1];
    state_.assign(slice * dimensions[2], Fluid);
    for (std::uint32_t z = 0; z + 1 < dimensions[2]; ++z)
        for (std::uint32_t y = 0; y + 1 < dimensions[1]; ++y)
            for (std::uint32_t x = 0; x + 1 < dimensions[0]; ++x) {
                const std::size_t node = z * slice + y * row + x;
                int fluid = 0;
                for (const std::size_t corner :
                     {node, node + row, node + slice, node + slice + row})
                    fluid += (mask.fluid[corner] != 0) + (mask.fluid[corner + 1] != 0);
                state_[node] = fluid == 8 ? Fluid : fluid == 0 ? Solid : Mixed;
            }
}

} // namespace wakesurf::core
