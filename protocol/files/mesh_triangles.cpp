#include "protocol/files/mesh_triangles.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
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

namespace {

/// Returns 0 for a flat triangle, 1 / (4 sqrt 3) for an equilateral one; 0 for coordinates that are not
/// finite.
double fatness(const core::Vec3& a, const core::Vec3& b, const core::Vec3& c) {
    const core::Vec3 ab = b - a;
    const core::Vec3 bc = c - b;
    const core::Vec3 ca = a - c;
    const double sides = glm::dot(ab, ab) + glm::dot(bc, bc) + glm::dot(ca, ca);
    const double value = 0.5 * glm::length(glm::cross(ab, bc)) / sides;
    return value > 0.0 ? value : 0.0;
}

/// Holds the best way to cut the outline from vertex i to vertex k, closed by the edge between the two:
/// dynamic programming over intervals (Klincsek, Minimal triangulations of polygonal domains, 1980).
struct Cuts {
    static constexpr std::size_t most = 8;
    std::array<std::array<double, most>, most> worst{};
    std::array<std::array<std::uint8_t, most>, most> apex{};
};

Cuts best_cuts(const core::QuadComplex& mesh, const core::CellPolygon& outline) {
    Cuts cuts;
    const auto at = [&](std::size_t i) { return mesh.position[outline.vertex[i]]; };
    for (auto& row : cuts.worst)
        row.fill(1.0); // an edge alone cuts nothing off
    for (std::size_t span = 2; span < outline.count; ++span)
        for (std::size_t i = 0; i + span < outline.count; ++i) {
            const std::size_t k = i + span;
            double best = -1.0;
            for (std::size_t j = i + 1; j < k; ++j) {
                const double worst =
                    std::min({fatness(at(i), at(j), at(k)), cuts.worst[i][j], cuts.worst[j][k]});
                if (worst > best) {
                    best = worst;
                    cuts.apex[i][k] = static_cast<std::uint8_t>(j);
                }
            }
            cuts.worst[i][k] = best;
        }
    return cuts;
}

void collect(const core::CellPolygon& outline,
             const Cuts& cuts,
             std::size_t i,
             std::size_t k,
             std::vector<Triangle>& out) {
    if (k - i < 2)
        return;
    const std::size_t j = cuts.apex[i][k];
    out.push_back({outline.vertex[i], outline.vertex[j], outline.vertex[k]});
    collect(outline, cuts, i, j, out);
    collect(outline, cuts, j, k, out);
}

} // namespace

void append_triangles(const core::QuadComplex& mesh,
                      const core::Cell& cell,
                      std::vector<Triangle>& out) {
    const core::CellPolygon outline = core::polygon(cell);
    collect(outline, best_cuts(mesh, outline), 0, outline.count - 1, out);
}

std::vector<Triangle> triangles_of(const core::QuadComplex& mesh) {
    std::vector<Triangle> out;
    out.reserve(mesh.cells.size() * 2);
    for (const core::Cell& cell : mesh.cells)
        append_triangles(mesh, cell, out);
    return out;
}

} // namespace wakesurf::protocol
