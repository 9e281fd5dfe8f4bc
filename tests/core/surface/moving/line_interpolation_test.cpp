#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/line_interpolation.hpp"
#include "core/surface/moving/local_operations.hpp"
#include "tests/support/flat_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::line_interpolation_test {

namespace {

using namespace tests;

/// 5 x 5 cells of a patch of the parameters, each vertex where `shape` takes it.
template <class Shape>
MovingMesh shaped(Shape shape, double spacing = 0.2) {
    MovingMesh mesh = flat_patch(5, 5);
    for (VertexId v = 0; v < mesh.vertices.slots(); ++v) {
        mesh.vertices.s[v] *= 5.0 * spacing;
        mesh.vertices.t[v] *= 5.0 * spacing;
        mesh.vertices.position[v] = shape(mesh.vertices.s[v], mesh.vertices.t[v]);
    }
    return mesh;
}

constexpr CellIndex inner = 12; ///< in the middle of the patch
constexpr CellIndex first = 0;  ///< in its corner

/// Distance of the middle of a side from where `shape` takes the middle of its parameters.
template <class Shape>
double error(const MovingMesh& mesh, CellIndex cell, std::size_t side, Shape shape) {
    const Midpoint mid = middle_of_side(mesh, cell, side, InsertionPolicy::Line);
    return glm::length(mid.point.carried.position - shape(mid.point.s, mid.point.t));
}

Vec3 wave(double s, double t) {
    return {s + 0.1 * std::sin(t), t, std::sin(s + 0.3) * std::cos(t + 0.2)};
}

} // namespace

TEST(LineInterpolation, IsExactOnCubicsInsideAndOnParabolasAtTheEdge) {
    const auto cubic = [](double s, double t) {
        return Vec3(s - s * s * s, t + 2.0 * t * t * t, s * s - t * t + s * t);
    };
    const auto parabola = [](double s, double t) {
        return Vec3(s + s * s, t, 2.0 * s * s - t * t + s * t);
    };
    for (std::size_t side = 0; side < 4; ++side) {
        EXPECT_LT(error(shaped(cubic), inner, side, cubic), 1e-15);
        EXPECT_LT(error(shaped(parabola), first, side, parabola), 1e-15);
        EXPECT_GT(error(shaped(cubic), first, side, cubic), 1e-4);
    }
}

TEST(LineInterpolation, IsOfFourthOrderInsideAndOfThirdAtTheEdge) {
    for (std::size_t side = 0; side < 4; ++side) {
        const auto order = [&](CellIndex cell) {
            return std::log2(error(shaped(wave, 0.1), cell, side, wave) /
                             error(shaped(wave, 0.05), cell, side, wave));
        };
        EXPECT_GT(order(inner), 3.8) << side;
        EXPECT_GT(order(first), 2.8) << side;
    }
}

TEST(LineInterpolation, GoesOnThroughCellsThatAreCutAndThroughWiderOnes) {
    const auto parabola = [](double s, double t) { return Vec3(s, t, 2.0 * s * s + t * t); };
    for (const Axis axis : {Axis::S, Axis::T})
        for (const CellIndex cut : {7u, 11u, 12u, 13u, 17u}) {
            MovingMesh mesh = shaped(parabola);
            LocalOperations operations(mesh, [&](CellIndex index, std::size_t side) {
                const Midpoint mid = middle_of_side(mesh, index, side, InsertionPolicy::Line);
                return mesh.vertices.add(mid.point, VertexRole::Free, 0.0);
            });
            ASSERT_TRUE(operations.split(cut, axis));
            for (CellIndex cell = 0; cell < mesh.quads.slots().size(); ++cell)
                for (std::size_t side = 0; side < 4; ++side)
                    if (mesh.quads[cell].live && mesh.quads[cell].cell.mid[side] == no_vertex)
                        // Beside a wider cell the line goes on half-way between two others, on a chord whose sagitta of
                        // 2 (0.2 / 2)^2 counts for an eighth at most.
                        EXPECT_LT(error(mesh, cell, side, parabola), 0.02 / 8.0 + 1e-12)
                            << cell << " side " << side;
        }
}

TEST(LineInterpolation, StaysOnTheChordWhereTheLineEndsOrIsUnevenOrBendsTooMuch) {
    MovingMesh dead = shaped(wave);
    for (const VertexId v : {dead.quads[inner].cell.corner[0], dead.quads[inner].cell.corner[2]})
        dead.vertices.end[v] = CurveEnd::Domain;
    EXPECT_EQ(bulge_of_line(dead, inner, 0).offset, Vec3(0.0));
    EXPECT_EQ(bulge_of_line(dead, inner, 0).share, 0.0);

    MovingMesh uneven = shaped(wave);
    for (VertexId v = 0; v < uneven.vertices.slots(); ++v)
        if (uneven.vertices.s[v] < 0.3 || uneven.vertices.s[v] > 0.7)
            uneven.vertices.position[v] += Vec3(uneven.vertices.s[v] < 0.3 ? -1.0 : 1.0, 0.0, 0.0);
    EXPECT_EQ(bulge_of_line(uneven, inner, 0).offset, Vec3(0.0));

    const MovingMesh bent =
        shaped([](double s, double) { return Vec3(0.5 * s, 0.0, 4.0 * (s - 0.5) * (s - 0.5)); });
    EXPECT_EQ(bulge_of_line(bent, inner, 0).offset, Vec3(0.0));
    EXPECT_GT(bulge_of_line(bent, inner, 0).share, 0.25);
}

TEST(LineInterpolation, BothCellsOfASideFindTheSameMiddle) {
    const MovingMesh mesh = shaped(wave);
    const auto middle = [&](CellIndex cell, std::size_t side) {
        return middle_of_side(mesh, cell, side, InsertionPolicy::Line).point.carried.position;
    };
    EXPECT_LT(glm::length(middle(inner, 1) - middle(inner + 1, 3)), 1e-15);
    EXPECT_LT(glm::length(middle(inner, 2) - middle(inner + 5, 0)), 1e-15);
}

} // namespace wakesurf::core::line_interpolation_test
