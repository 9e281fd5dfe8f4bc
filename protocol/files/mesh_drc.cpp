#include "protocol/files/mesh_drc.hpp"

#include "protocol/files/draco_mesh.hpp"

namespace wakesurf::protocol {

core::Result<std::string>
mesh_drc(const core::QuadComplex& mesh, const MeshMetadata& metadata, const MeshScalars& scalars) {
    return encode_triangles(mesh, triangles_of(mesh), mesh_attributes(mesh, scalars), &metadata)
        .map([](DracoMesh&& made) { return std::move(made.bytes); });
}

} // namespace wakesurf::protocol
