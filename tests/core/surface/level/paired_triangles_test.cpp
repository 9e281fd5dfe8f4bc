#include "core/surface/level/paired_triangles.hpp"
#include "tests/support/mesh_borders.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace wakesurf::core::paired_triangles_test {
namespace {

using Corners = std::array<std::uint32_t, 3>;

struct Soup {
    std::vector<Vec3> points;
    std::vector<Corners> triangles;
};

/// An octahedron whose triangles are parted into four, so often.
Soup ball(int times) {
    Soup soup{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int i = 0; i < times; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] =
                middles.try_emplace(std::minmax(a, b), std::uint32_t(soup.points.size()));
            if (is_new)
                soup.points.push_back(glm::normalize(soup.points[a] + soup.points[b]));
            return found->second;
        };
        std::vector<Corners> finer;
        for (const auto& [a, b, c] : soup.triangles) {
            const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        soup.triangles = std::move(finer);
    }
    return soup;
}

QuadComplex quads_of(Soup soup) {
    QuadComplex mesh;
    mesh.position = std::move(soup.points);
    mesh.cells = paired_triangles(mesh.position, soup.triangles);
    return mesh;
}

/// Sides cut at what hangs on them; each once in every direction, or the mesh is none.
std::size_t edges_of(const QuadComplex& mesh) {
    const tests::DirectedEdges edges(mesh);
    std::size_t both = 0;
    for (std::size_t i = 0; i < edges.all().size(); ++i) {
        const auto& edge = edges.all()[i];
        EXPECT_FALSE(i > 0 && edges.all()[i - 1].from == edge.from &&
                     edges.all()[i - 1].to == edge.to)
            << "an edge is used twice";
        both += edges.border(edge) ? 2 : 1;
    }
    return both / 2;
}

double area_of(const QuadComplex& mesh) {
    double area = 0.0;
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        Vec3 twice(0.0);
        for (std::uint32_t i = 1; i + 1 < outline.count; ++i)
            twice +=
                glm::cross(mesh.position[outline.vertex[i]] - mesh.position[outline.vertex[0]],
                           mesh.position[outline.vertex[i + 1]] - mesh.position[outline.vertex[0]]);
        area += 0.5 * glm::length(twice);
    }
    return area;
}

TEST(PairedTriangles, KeepAClosedSurfaceClosed) {
    for (int times = 0; times < 6; ++times) {
        const Soup soup = ball(times);
        const QuadComplex mesh = quads_of(soup);
        EXPECT_TRUE(tests::border_edges(mesh).empty()) << times;
        const auto euler = static_cast<long>(mesh.vertices()) - static_cast<long>(edges_of(mesh)) +
                           static_cast<long>(mesh.cells.size());
        EXPECT_EQ(euler, 2) << times;
        if (times > 2) {
            EXPECT_LT(mesh.cells.size(), 0.62 * static_cast<double>(soup.triangles.size()))
                << "most are pairs";
        }
    }
    EXPECT_NEAR(area_of(quads_of(ball(5))), 4.0 * std::numbers::pi, 0.05);
}

TEST(PairedTriangles, KeepTheDirectionThatTheyFace) {
    const QuadComplex mesh = quads_of(ball(3));
    for (const Cell& cell : mesh.cells) {
        const auto& p = mesh.position;
        const auto& [a, b, c, d] = cell.corner;
        EXPECT_GT(glm::dot(glm::cross(p[c] - p[a], p[d] - p[b]), p[a] + p[b] + p[c] + p[d]), 0.0);
    }
}

TEST(PairedTriangles, OfOneTriangleAreAQuadWithAFlatCorner) {
    const QuadComplex mesh = quads_of({{{0, 0, 0}, {4, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    ASSERT_EQ(mesh.cells.size(), 1u);
    ASSERT_EQ(mesh.vertices(), 4u);
    EXPECT_EQ(mesh.position[3], Vec3(2, 0.5, 0)) << "in the middle of the longest side";
    EXPECT_NEAR(area_of(mesh), 2.0, 1e-15);
}

TEST(PairedTriangles, AcrossAFoldStayApartWithoutACrack) {
    const QuadComplex mesh =
        quads_of({{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 1}}, {{0, 1, 2}, {1, 0, 3}}});
    ASSERT_EQ(mesh.cells.size(), 2u);
    EXPECT_EQ(mesh.vertices(), 5u) << "both share the middle of the fold";
    EXPECT_EQ(tests::border_edges(mesh).size(), 4u);
}

TEST(PairedTriangles, OfNothingAreNothing) {
    EXPECT_TRUE(quads_of({}).cells.empty());
}

TEST(PairedTriangles, WithoutAreaKeepTheSurfaceClosed) {
    Soup soup = ball(2);
    for (const std::uint32_t each : {7u, 9u, 20u})
        soup.points[each] = soup.points[0]; // as where a node has exactly the level
    const QuadComplex mesh = quads_of(soup);
    EXPECT_TRUE(tests::border_edges(mesh).empty());
    for (const Vec3& point : mesh.position)
        EXPECT_TRUE(finite(point));
}

} // namespace
} // namespace wakesurf::core::paired_triangles_test
