#include "protocol/files/mesh_file.hpp"

#include "core/surface/quad_complex.hpp"
#include "protocol/files/draco_mesh.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/mesh_triangles.hpp"
#include "protocol/files/mesh_vtp.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace wakesurf::protocol {

namespace {

void face(std::string& out, const std::uint32_t* vertices, std::size_t corners) {
    out += 'f';
    for (std::size_t i = 0; i < corners; ++i) {
        const std::string number = number_text(vertices[i] + 1); // .obj counts from 1
        ((((out += ' ') += number) += '/') += number);
    }
    out += '\n';
}

// Writes a Wavefront .obj file: `v x y z` as computed, `vt s t`, and faces as in mesh_ply. The format cannot hold further arrays.
// Metadata in comments.
std::string mesh_obj(const core::QuadComplex& mesh, const MeshMetadata& metadata) {
    std::string out = mesh_comments(metadata, "# ");
    out.reserve(out.size() + mesh.vertices() * 90 + mesh.cells.size() * 60);
    out += "# v x y z; vt s t\no surface\n";
    for (const core::Vec3& p : mesh.position)
        out += "v " + number_text(p.x) + " " + number_text(p.y) + " " + number_text(p.z) + "\n";
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
        out += "vt " + number_text(mesh.s[v]) + " " + number_text(mesh.t[v]) + "\n";
    std::vector<Triangle> cut;
    for (const core::Cell& cell : mesh.cells) {
        const core::CellPolygon outline = core::polygon(cell);
        if (outline.count == 4) {
            face(out, outline.vertex.data(), 4);
            continue;
        }
        cut.clear();
        append_triangles(mesh, cell, cut);
        for (const Triangle& each : cut)
            face(out, each.data(), 3);
    }
    return out;
}

} // namespace

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
