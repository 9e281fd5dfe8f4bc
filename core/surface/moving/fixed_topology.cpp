#include "core/surface/moving/fixed_topology.hpp"

#include "core/surface/moving/refinement.hpp"
#include "core/surface/moving/split_criteria.hpp"

#include <array>

namespace wakesurf::core {

void leave_out_dead(MovingMesh& mesh) {
    bool any = false;
    for (CellIndex i = 0; i < mesh.quads.slots().size(); ++i)
        if (const LinkedCell& slot = mesh.quads[i]; slot.live && has_dead_vertex(mesh, slot.cell)) {
            mesh.quads.replace(std::array{i}, {}, 0);
            any = true;
        }
    if (any)
        remove_unused_vertices(mesh);
}

} // namespace wakesurf::core
