#include "tests/bench/support/draco_mesh.hpp"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

namespace wakesurf::bench {

namespace {

int add_attribute(draco::Mesh& mesh,
                  draco::GeometryAttribute::Type type,
                  int components,
                  const std::vector<float>& values) {
    draco::GeometryAttribute description;
    description.Init(type, nullptr, static_cast<std::uint8_t>(components), draco::DT_FLOAT32, false,
                     components * static_cast<int>(sizeof(float)), 0);
    const int id = mesh.AddAttribute(description, true, mesh.num_points());
    mesh.attribute(id)->buffer()->Write(0, values.data(), values.size() * sizeof(float));
    return id;
}

void add_triangles(draco::Mesh& mesh, const core::QuadComplex& surface) {
    for (const core::Cell& cell : surface.cells) {
        const core::CellPolygon outline = core::polygon(cell);
        for (std::uint32_t i = 1; i + 1 < outline.count; ++i)
            mesh.AddFace({draco::PointIndex(outline.vertex[0]),
                          draco::PointIndex(outline.vertex[i]),
                          draco::PointIndex(outline.vertex[i + 1])});
    }
}

} // namespace

std::size_t
draco_mesh_bytes(const core::QuadComplex& surface, const protocol::Lattice& lattice, int speed) {
    draco::Mesh mesh;
    mesh.set_num_points(static_cast<std::uint32_t>(surface.vertices()));
    std::vector<float> positions, speeds;
    for (std::size_t v = 0; v < surface.vertices(); ++v) {
        for (int axis = 0; axis < 3; ++axis)
            positions.push_back(static_cast<float>(surface.position[v][axis]));
        speeds.push_back(static_cast<float>(surface.speed(static_cast<core::VertexId>(v))));
    }
    const int position = add_attribute(mesh, draco::GeometryAttribute::POSITION, 3, positions);
    const int scalar = add_attribute(mesh, draco::GeometryAttribute::GENERIC, 1, speeds);
    add_triangles(mesh, surface);
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    encoder.SetSpeedOptions(speed, speed);
    const std::array<float, 3> origin{static_cast<float>(lattice.origin.x),
                                      static_cast<float>(lattice.origin.y),
                                      static_cast<float>(lattice.origin.z)};
    encoder.SetAttributeExplicitQuantization(position, 14, 3, origin.data(),
                                             static_cast<float>(lattice.step * lattice.last()));
    const float nothing = 0.0f;
    encoder.SetAttributeExplicitQuantization(scalar, 8, 1, &nothing,
                                             *std::ranges::max_element(speeds));
    draco::EncoderBuffer out;
    if (const draco::Status status = encoder.EncodeToBuffer(&out); !status.ok())
        throw std::runtime_error(status.error_msg());
    return out.size();
}

} // namespace wakesurf::bench
