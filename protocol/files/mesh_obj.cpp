#include "protocol/files/mesh_obj.hpp"

#include "protocol/files/mesh_comments.hpp"
#include "protocol/files/mesh_triangles.hpp"
#include "protocol/files/number_text.hpp"

#include <cstdint>
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

} // namespace

std::string mesh_obj(const core::QuadComplex& mesh, const MeshMetadata& metadata) {
    std::string out;
    out.reserve(mesh.vertices() * 90 + mesh.cells.size() * 60);
    for (const std::string& line : mesh_comments(metadata))
        out += "# " + line + "\n";
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

} // namespace wakesurf::protocol
