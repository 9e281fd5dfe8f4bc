#include "core/field/cells/cell_domain.hpp"

#include <algorithm>
#include <vector>

namespace wakesurf::core {

bool connected(const CellMesh& mesh) {
    if (mesh.cells.empty())
        return true;
    std::vector<bool> reached(mesh.cells.size());
    std::vector<std::uint32_t> open{0};
    reached[0] = true;
    std::size_t count = 1;
    while (!open.empty()) {
        const MeshCell& cell = mesh.cells[open.back()];
        open.pop_back();
        for (const std::uint32_t next : cell.beyond)
            if (next < mesh.cells.size() && !reached[next]) {
                reached[next] = true;
                open.push_back(next);
                ++count;
            }
    }
    return count == mesh.cells.size();
}

} // namespace wakesurf::core
