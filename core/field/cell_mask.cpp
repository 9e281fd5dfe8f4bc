#include "core/field/cell_mask.hpp"

#include <algorithm>

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

CellMask CellMask::round_cells(const std::array<std::uint32_t, 3>& dimensions,
                               const SolidMask& mask) {
    CellMask round;
    if (mask.empty())
        return round;
    round.state_.resize(mask.fluid.size());
    std::transform(mask.fluid.begin(), mask.fluid.end(), round.state_.begin(),
                   [](std::uint8_t fluid) { return fluid != 0 ? Fluid : Mixed; });
    std::size_t stride = 1;
    std::vector<std::uint8_t> line;
    for (const std::uint32_t nodes :
         dimensions) { // axis by axis: from one node before to two after
        line.resize(nodes);
        for (std::size_t first = 0; first < round.state_.size(); ++first) {
            if (first / stride % nodes != 0)
                continue;
            for (std::size_t i = 0; i < nodes; ++i)
                line[i] = round.state_[first + i * stride];
            for (std::size_t i = 0; i < nodes; ++i)
                for (std::size_t k = i - std::min<std::size_t>(i, 1);
                     k <= std::min<std::size_t>(i + 2, nodes - 1); ++k)
                    round.state_[first + i * stride] =
                        std::max(round.state_[first + i * stride], line[k]);
        }
        stride *= nodes;
    }
    return round;
}

} // namespace wakesurf::core
