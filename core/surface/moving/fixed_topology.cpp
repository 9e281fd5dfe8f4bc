#include "core/surface/moving/fixed_topology.hpp"

#include "core/surface/moving/refinement.hpp"
#include "core/surface/moving/triangle_shape.hpp"

namespace wakesurf::core {

void leave_out_dead(MovingMesh& mesh) {
    for (TriangleId t = 0; t < mesh.triangles.slots().size(); ++t)
        if (mesh.triangles[t].live && has_dead_vertex(mesh, t)) {
            const TriangleId other = mesh.triangles[t].across[mesh.triangles[t].mate];
            mesh.triangles.remove(t);
            mesh.triangles.remove(other);
        }
    mesh.triangles.touched().clear();
    mesh.triangles.loose().clear();
    remove_unused_vertices(mesh);
}

} // namespace wakesurf::core
