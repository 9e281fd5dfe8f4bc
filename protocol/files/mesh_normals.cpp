#include "protocol/files/mesh_normals.hpp"

#include <glm/geometric.hpp>

#include <cmath>

namespace wakesurf::protocol {

std::vector<core::Vec3f> vertex_normals(const core::QuadComplex& mesh,
                                        const std::vector<Triangle>& triangles) {
    std::vector<core::Vec3> sums(mesh.vertices(), core::Vec3(0.0));
    for (const Triangle& each : triangles) {
        const core::Vec3& a = mesh.position[each[0]];
        const core::Vec3 twice_the_area =
            glm::cross(mesh.position[each[1]] - a, mesh.position[each[2]] - a);
        for (const std::uint32_t v : each)
            sums[v] += twice_the_area;
    }
    std::vector<core::Vec3f> normals;
    normals.reserve(sums.size());
    for (const core::Vec3& sum : sums) {
        const double length = glm::length(sum);
        const bool usable = length > 0.0 && std::isfinite(length);
        normals.emplace_back(usable ? sum / length : core::Vec3(0.0, 0.0, 1.0));
    }
    for (std::size_t v = 0; v < mesh.normal.size(); ++v)
        if (mesh.normal[v] != core::Vec3f(0.0F))
            normals[v] = mesh.normal[v];
    return normals;
}

} // namespace wakesurf::protocol
