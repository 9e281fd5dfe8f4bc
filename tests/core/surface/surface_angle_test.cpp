// SurfaceParameters::angle on stream and path surfaces: cells that meet at more are refined, along the columns and across.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "tests/support/mesh_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace wakesurf::core::surface_angle_test {

using namespace tests;

namespace {

Surface built(const char* flow, const Rake& rake, double to, double separation, double angle) {
    SurfaceParameters p{.to = to, .separation = separation, .angle = angle};
    auto surface = build_surface(**make_analytic_flow(flow), rake, p);
    EXPECT_TRUE(surface) << flow;
    return std::move(*surface);
}

Vec3 normal(const QuadComplex& mesh, const Cell& cell) {
    const Vec3 n = glm::cross(mesh.position[cell.corner[2]] - mesh.position[cell.corner[0]],
                              mesh.position[cell.corner[3]] - mesh.position[cell.corner[1]]);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : Vec3(0.0);
}

/// Length of a cell along its columns, or its width square to them.
double extent(const QuadComplex& mesh, const Cell& cell, bool along) {
    const Vec3 a = mesh.position[cell.corner[0]], b = mesh.position[cell.corner[1]];
    const Vec3 c = mesh.position[cell.corner[2]], d = mesh.position[cell.corner[3]];
    if (along)
        return std::max(glm::length(c - b), glm::length(d - a));
    return glm::length(glm::cross(c - a, d - b)) / glm::length(c - b + d - a);
}

struct Bend {
    double degrees;
    bool along;    ///< between cells that follow one another along the columns
    double extent; ///< the larger of the two cells' in the direction of the bend
    Vec3 middle;   ///< of the edge
};

/// One entry for every two cells that share an edge.
std::vector<Bend> bends(const QuadComplex& mesh) {
    struct Use {
        std::uint32_t cell;
        bool front;
    };

    std::map<std::pair<VertexId, VertexId>, std::vector<Use>> uses;
    for (std::uint32_t i = 0; i < mesh.cells.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            const Cell& cell = mesh.cells[i];
            const VertexId a = cell.corner[k], b = cell.corner[(k + 1) % 4], m = cell.mid[k];
            const auto use = [&](VertexId x, VertexId y) {
                uses[{std::min(x, y), std::max(x, y)}].push_back({i, k % 2 == 0});
            };
            if (m == no_vertex) {
                use(a, b);
            } else {
                use(a, m);
                use(m, b);
            }
        }
    std::vector<Bend> all;
    for (const auto& [edge, by] : uses)
        if (by.size() == 2) {
            const Cell& a = mesh.cells[by[0].cell];
            const Cell& b = mesh.cells[by[1].cell];
            const double cosine = glm::dot(normal(mesh, a), normal(mesh, b));
            all.push_back({std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi,
                           by[0].front,
                           std::max(extent(mesh, a, by[0].front), extent(mesh, b, by[0].front)),
                           0.5 * (mesh.position[edge.first] + mesh.position[edge.second])});
        }
    return all;
}

/// Degrees of the largest bend at which at least one cell could still be made smaller.
double largest_turn(const Surface& surface, bool along) {
    // Strips and the segments of columns are halved down to an eighth of the separation and of the spacing: a cell below
    // twice that, whose side may have two segments, cannot be.
    const double floor = (along ? 0.75 : 1.0) * 2.0 * surface.statistics.separation / 8.0;
    double largest = 0.0;
    for (const Bend& bend : bends(surface.mesh))
        if (bend.along == along && bend.extent > floor * 1.001)
            largest = std::max(largest, bend.degrees);
    return largest;
}

Rake line(Vec3 a, Vec3 b) {
    return {Rake::Kind::Line, {a, b}, 16};
}

struct Case {
    const char* flow;
    Rake rake;
    double to, separation;
};

/// Sheets that roll up around a vortex, wind into a helix, climb over an obstacle, fold in chaotic flow.
const std::vector<Case>& bent() {
    static const std::vector<Case> all = {
        {"lamb-oseen", line({0.05, 0, -5}, {1, 0, -5}), 3, 0.05},
        {"lamb-oseen", line({0.05, 0, -5}, {1, 0, -5}), 6, 0.1},
        {"lamb-oseen", line({-0.5, 0.1, -5}, {0.5, 0.1, -5}), 6, 0.1},
        {"abc", {Rake::Kind::Circle, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 24}, 5, 0.2},
        {"tornado", line({0.3, 0.5, 0.1}, {0.7, 0.5, 0.6}), 5, 0.04},
        {"sphere", line({-4, 0.01, -2}, {-4, 0.02, 2}), 9, 0.1},
    };
    return all;
}

Surface built(const Case& c, double angle) {
    return built(c.flow, c.rake, c.to, c.separation, angle);
}

} // namespace

TEST(SurfaceAngle, CellsBesideOneAnotherMeetAtMostAtTheAngleUnlessAsNarrowAsMayBe) {
    for (const Case& c : bent()) {
        EXPECT_GT(largest_turn(built(c, 180.0), false), 30.0) << c.flow << " " << c.separation;
        for (const double angle : {20.0, 30.0})
            EXPECT_LE(largest_turn(built(c, angle), false), angle + 1e-3)
                << c.flow << " " << c.separation;
    }
}

TEST(SurfaceAngle, TheSheetOfAVortexTurnsByTheAngleFromCellToCellAtMost) {
    const Surface surface = built(bent().front(), 20.0);
    EXPECT_GT(largest_turn(built(bent().front(), 180.0), true), 30.0);
    EXPECT_LE(largest_turn(surface, true), 20.0);
    EXPECT_LE(largest_turn(surface, false), 20.0);
}

TEST(SurfaceAngle, AlongTheFlowFewCellsThatCouldBeShorterTurnByMore) {
    for (const Case& c : bent()) {
        const auto share = [&](double angle) {
            std::size_t all = 0, over = 0;
            for (const Bend& bend : bends(built(c, angle).mesh)) {
                all += bend.along;
                over += bend.along && bend.degrees > 20.0;
            }
            return static_cast<double>(over) / static_cast<double>(all);
        };
        EXPECT_LE(share(20.0), std::max(0.25 * share(180.0), 0.0005))
            << c.flow << " " << c.separation;
    }
}

/// The streamline on the axis is straight, and the sheet twists about it.
TEST(SurfaceAngle, OnTheAxisOfAVortexFewNeighboursMeetAtMoreThanTheAngle) {
    for (const double beside : {0.01, 0.1}) {
        const Surface surface = built("lamb-oseen?rc=0.5,w=0.5,gamma=5",
                                      line({-0.9, beside, 0}, {0.9, beside, 0}), 3, 0.2, 20.0);
        double all = 0, along = 0, across = 0;
        for (const Bend& bend : bends(surface.mesh))
            if (std::hypot(bend.middle.x, bend.middle.y) < 0.2) {
                ++all;
                (bend.along ? along : across) += bend.degrees > 20.0;
            }
        EXPECT_GT(all, 500.0);
        EXPECT_LE(along, 0.005 * all) << beside << " beside it";
        EXPECT_LE(across, 0.015 * all) << beside << " beside it: those as narrow as may be";
    }
}

TEST(SurfaceAngle, SmallerAnglesTakeMoreCellsAndStayWatertight) {
    for (const Case& c : bent()) {
        std::size_t before = 0;
        const Surface plain = built(c, 180.0);
        for (const double angle : {180.0, 20.0, 8.0}) {
            const Surface surface = built(c, angle);
            EXPECT_GT(surface.mesh.cells.size(), before) << c.flow << " " << angle;
            before = surface.mesh.cells.size();
            EXPECT_EQ(surface.mesh.validate(), "") << c.flow << " " << angle;
            EXPECT_LE(surface.statistics.max_edge, c.separation * (1.0 + 1e-6)) << c.flow;
            EXPECT_EQ(euler_characteristic(surface.mesh), euler_characteristic(plain.mesh))
                << c.flow << " " << angle;
            EXPECT_EQ(boundary_loops(surface.mesh), boundary_loops(plain.mesh))
                << c.flow << " " << angle;
        }
    }
}

TEST(SurfaceAngle, WhereNothingBendsNothingChanges) {
    for (const Case& c : {Case{"uniform", line({-9, 0, -3}, {-9, 0, 3}), 10, 0.2},
                          {"shear", line({-10, 0, -0.5}, {-10, 0, 2}), 6, 0.1},
                          {"strain", line({-1, 4, 0}, {1, 4, 0}), 3, 0.1},
                          {"abc", line({0, 0, 0}, {3, 0, 0}), 6, 0.1}}) {
        const Surface plain = built(c, 180.0);
        const Surface refined = built(c, 20.0);
        EXPECT_EQ(plain.mesh.position, refined.mesh.position) << c.flow;
        EXPECT_EQ(plain.mesh.cells, refined.mesh.cells) << c.flow;
    }
}

TEST(SurfaceAngle, ARakeWithACornerIsRefinedBesideItOnly) {
    const Rake corner{Rake::Kind::Polyline, {{-9, 0, 0}, {-9, 1, 0}, {-9, 1, 1}}, 2};
    const Surface plain = built("uniform", corner, 5, 0.1, 180.0);
    const Surface refined = built("uniform", corner, 5, 0.1, 20.0);
    EXPECT_EQ(refined.mesh.validate(), "");
    EXPECT_LE(refined.mesh.cells.size(), 2 * plain.mesh.cells.size());
}

TEST(SurfaceAngle, TheBudgetHoldsHoweverSmallTheAngle) {
    const Case& c = bent()[2];
    SurfaceParameters p{.to = c.to, .separation = c.separation, .angle = 2.0, .max_quads = 5000};
    const auto surface = build_surface(**make_analytic_flow(c.flow), c.rake, p);
    ASSERT_TRUE(surface);
    EXPECT_LE(surface->mesh.cells.size(), 5000u);
    EXPECT_GT(surface->statistics.separation, c.separation);
}

} // namespace wakesurf::core::surface_angle_test
