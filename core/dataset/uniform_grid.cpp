#include "core/dataset/uniform_grid.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

bool is_even(std::span<const double> nodes, bool single_precision) {
    const double spacing = (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
    if (!std::isfinite(spacing))
        return false;
    const double furthest = std::max(std::abs(nodes.front()), std::abs(nodes.back()));
    const double slack = std::max(1e-6 * spacing, single_precision ? furthest * 0x1p-23 : 0.0);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (std::abs(nodes[i] - (nodes.front() + static_cast<double>(i) * spacing)) > slack)
            return false;
    return true;
}

} // namespace wakesurf::core
