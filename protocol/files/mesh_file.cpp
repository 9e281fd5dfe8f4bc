#include "protocol/files/mesh_file.hpp"

#include "protocol/files/mesh_drc.hpp"
#include "protocol/files/mesh_obj.hpp"
#include "protocol/files/mesh_vtp.hpp"

namespace wakesurf::protocol {

std::string_view extension(MeshFormat format) {
    switch (format) {
    case MeshFormat::Glb:
        return "glb";
    case MeshFormat::Ply:
        return "ply";
    case MeshFormat::Obj:
        return "obj";
    case MeshFormat::Drc:
        return "drc";
    case MeshFormat::Vtp:
        break;
    }
    return "vtp";
}

std::string_view content_type(MeshFormat format) {
    switch (format) {
    case MeshFormat::Vtp:
        return "application/vnd.vtk.polydata+xml"; // not registered
    case MeshFormat::Glb:
        return "model/gltf-binary";
    case MeshFormat::Ply:
        return "application/x-ply";
    case MeshFormat::Obj:
        return "model/obj";
    case MeshFormat::Drc:
        break;
    }
    return "application/octet-stream";
}

std::optional<MeshFormat> mesh_format(std::string_view wanted) {
    for (const MeshFormat each : mesh_formats)
        if (extension(each) == wanted)
            return each;
    return std::nullopt;
}

std::string mesh_extensions() {
    std::string out;
    for (const MeshFormat each : mesh_formats) {
        if (!out.empty())
            out += each == mesh_formats.back() ? " or " : ", ";
        (out += '.') += extension(each);
    }
    return out;
}

core::Result<std::string> mesh_file(MeshFormat format,
                                    const core::QuadComplex& mesh,
                                    const MeshMetadata& metadata,
                                    const MeshScalars& scalars,
                                    GlbCoding glb,
                                    PlyElements ply) {
    switch (format) {
    case MeshFormat::Glb:
        return mesh_glb(mesh, metadata, scalars, glb);
    case MeshFormat::Ply:
        return mesh_ply(mesh, metadata, scalars, ply);
    case MeshFormat::Obj:
        return mesh_obj(mesh, metadata);
    case MeshFormat::Drc:
        return mesh_drc(mesh, metadata, scalars);
    case MeshFormat::Vtp:
        break;
    }
    return mesh_vtp(mesh, metadata, scalars);
}

} // namespace wakesurf::protocol
