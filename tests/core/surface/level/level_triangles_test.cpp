// Level sets in cells of all shapes: closed forms to second order, random values without cracks, and what values and levels at the edge of sense give.
#include "core/surface/level/level_triangles.hpp"
#include "tests/support/cell_meshes.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <vector>

namespace wakesurf::core::level_triangles_test {
namespace {

using Formula = std::function<double(const Vec3&)>;
using Triangle = std::array<std::uint32_t, 3>;

/// A block of n^3 cubes in [0, 1]^3, bent, each cut into cells of one shape: six tetrahedra, six pyramids round its centre, or two wedges; all cubes in the
/// same way, so that they meet. Mixed: next to each other, of a cube the hexahedron or pyramids.
enum class Cut { Tetrahedra, Pyramids, Wedges, Hexahedra, Mixed };

constexpr std::array all_cuts{Cut::Tetrahedra, Cut::Pyramids, Cut::Wedges, Cut::Hexahedra,
                              Cut::Mixed};

void add_cube(CellMesh& mesh, Cut cut, const std::array<std::uint32_t, 8>& c) {
    const auto add = [&](CellShape shape, std::initializer_list<std::size_t> nodes) {
        std::vector<std::uint32_t> out;
        for (const std::size_t k : nodes)
            out.push_back(k < 8 ? c[k] : static_cast<std::uint32_t>(mesh.points.size() - 1));
        tests::add_cell(mesh, shape, out);
    };
    switch (cut) {
    case Cut::Tetrahedra: // round the diagonal from 0 to 6
        for (const auto& [a, b] : {std::pair{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
            add(CellShape::Tetrahedron, {0, std::size_t(a), std::size_t(b), 6});
        break;
    case Cut::Pyramids: {
        Vec3 centre(0.0);
        for (const std::uint32_t node : c)
            centre += 0.125 * mesh.points[node];
        mesh.points.push_back(centre);
        for (std::size_t f = 0; f < 6; ++f) {
            const CellFace side = face(CellShape::Hexahedron, f);
            add(CellShape::Pyramid, {side.node[0], side.node[3], side.node[2], side.node[1], 8});
        }
        break;
    }
    case Cut::Wedges: // VTK's first triangle is seen clockwise from outside, or not: face() says
        if (face(CellShape::Wedge, 0).node[1] == 1) {
            add(CellShape::Wedge, {0, 2, 1, 4, 6, 5});
            add(CellShape::Wedge, {0, 3, 2, 4, 7, 6});
        } else {
            add(CellShape::Wedge, {0, 1, 2, 4, 5, 6});
            add(CellShape::Wedge, {0, 2, 3, 4, 6, 7});
        }
        break;
    case Cut::Hexahedra:
    case Cut::Mixed:
        add(CellShape::Hexahedron, {0, 1, 2, 3, 4, 5, 6, 7});
        break;
    }
}

CellMesh cut_block(std::uint32_t n, Cut cut, const tests::Bend& bend) {
    CellMesh cubes;
    tests::add_block(cubes, {n, n, n}, bend);
    CellMesh mesh;
    mesh.points = cubes.points;
    for (std::uint32_t i = 0; i < cubes.cells.size(); ++i) {
        const bool other = (i + i / n + i / n / n) % 2 == 0;
        add_cube(mesh, cut == Cut::Mixed && other ? Cut::Pyramids : cut, cubes.cells[i].node);
    }
    return mesh;
}

std::vector<float> values_of(const Grid& grid, const Formula& formula) {
    std::vector<float> out(node_count(grid));
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = static_cast<float>(formula(node_position(grid, i)));
    return out;
}

LevelTriangles extracted(const Grid& grid, const std::vector<float>& values, double level) {
    auto found = level_triangles(grid, values, level, 1U << 30, {}, {});
    EXPECT_TRUE(found);
    EXPECT_GE(found->needed, found->triangles.size());
    return *std::move(found);
}

/// Each directed edge is used once, and has its reverse unless both of its ends are `on_border`.
void expect_watertight(const LevelTriangles& found,
                       const std::function<bool(const Vec3&)>& on_border) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::vector<bool> used(found.points.size(), false);
    for (const Triangle& t : found.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_LT(t[k], found.points.size());
            ASSERT_NE(t[k], t[(k + 1) % 3]);
            used[t[k]] = true;
            edges.emplace_back(t[k], t[(k + 1) % 3]);
        }
    EXPECT_EQ(std::ranges::count(used, false), 0) << "points of no triangle";
    std::ranges::sort(edges);
    ASSERT_EQ(std::ranges::adjacent_find(edges), edges.end()) << "an edge is used twice";
    for (const auto& [from, to] : edges)
        if (!std::ranges::binary_search(edges, std::pair(to, from))) {
            ASSERT_TRUE(on_border(found.points[from]) && on_border(found.points[to])) << "a crack";
        }
}

bool on_cube(const Vec3& p) {
    for (int k = 0; k < 3; ++k)
        if (std::abs(p[k]) < 1e-9 || std::abs(p[k] - 1.0) < 1e-9)
            return true;
    return false;
}

bool nowhere(const Vec3&) {
    return false;
}

double sphere(const Vec3& p) {
    return glm::length(p - Vec3(0.51, 0.49, 0.5));
}

/// The distance from a circle of radius 0.28, to which a torus has the same distance everywhere.
double torus(const Vec3& p) {
    const Vec3 at = p - Vec3(0.5, 0.51, 0.49);
    return std::hypot(std::hypot(at.x, at.y) - 0.28, at.z);
}

double gyroid(const Vec3& p) {
    const Vec3 u = 7.0 * p + Vec3(0.3);
    return std::sin(u.x) * std::cos(u.y) + std::sin(u.y) * std::cos(u.z) +
           std::sin(u.z) * std::cos(u.x);
}

/// The distance from the level to first order.
double off(const Formula& formula, double level, const Vec3& p) {
    constexpr double h = 1e-5;
    Vec3 gradient;
    for (int k = 0; k < 3; ++k) {
        Vec3 step(0.0);
        step[k] = h;
        gradient[k] = (formula(p + step) - formula(p - step)) / (2.0 * h);
    }
    return std::abs(formula(p) - level) / glm::length(gradient);
}

double farthest(const LevelTriangles& found, const Formula& formula, double level) {
    double most = 0.0;
    for (const Vec3& p : found.points)
        most = std::max(most, off(formula, level, p));
    return most;
}

long euler(const LevelTriangles& found) {
    return static_cast<long>(found.points.size()) - static_cast<long>(found.triangles.size()) / 2;
}

constexpr std::array<std::uint32_t, 3> finer{10, 20, 40}; ///< cells along a side

/// @param closed  the Euler characteristic; empty: the surface has a border
void expect_second_order(const std::vector<Grid>& grids,
                         const Formula& formula,
                         double level,
                         std::optional<long> closed) {
    double before = 0.0;
    for (std::size_t i = 0; i < finer.size(); ++i) {
        const auto found = extracted(grids[i], values_of(grids[i], formula), level);
        ASSERT_GT(found.triangles.size(), 100U);
        expect_watertight(found, closed ? nowhere : on_cube);
        if (closed) {
            EXPECT_EQ(euler(found), *closed);
        }
        const double now = farthest(found, formula, level);
        EXPECT_LT(now, 8.0 / (finer[i] * finer[i]));
        if (before > 0.0) {
            EXPECT_GT(std::log2(before / now), 1.6) << finer[i];
        }
        before = now;
    }
}

void expect_closed_forms(const std::function<Grid(std::uint32_t)>& grid) {
    std::vector<Grid> grids;
    for (const std::uint32_t n : finer)
        grids.push_back(grid(n));
    expect_second_order(grids, sphere, 0.37, 2);
    expect_second_order(grids, torus, 0.15, 0);
    expect_second_order(grids, gyroid, 0.1, std::nullopt);
}

TEST(LevelTriangles, OfClosedFormsLieOnThemToSecondOrderInEachShape) {
    for (const Cut cut : all_cuts) {
        SCOPED_TRACE(static_cast<int>(cut));
        expect_closed_forms([&](std::uint32_t n) { return cut_block(n, cut, tests::wavy); });
    }
}

UniformGrid unit_cube(std::uint32_t n) {
    return {Vec3(0.0), Vec3(1.0 / n), {n + 1, n + 1, n + 1}};
}

TEST(LevelTriangles, OfClosedFormsLieOnThemToSecondOrderInGrids) {
    expect_closed_forms(unit_cube);
    expect_closed_forms([](std::uint32_t n) {
        RectilinearGrid grid;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::uint32_t i = 0; i <= n; ++i) {
                const double at = static_cast<double>(i) / n;
                grid.coordinates[k].push_back(at + 0.2 * double(k) * at * (1.0 - at));
            }
        return grid;
    });
}

TEST(LevelTriangles, FaceLowerValues) {
    for (const Cut cut : all_cuts) {
        const Grid grid(cut_block(12, cut, tests::wavy));
        double volume = 0.0;
        const auto found = extracted(grid, values_of(grid, sphere), 0.37);
        for (const auto& [a, b, c] : found.triangles)
            volume -= glm::dot(found.points[a], glm::cross(found.points[b], found.points[c])) / 6.0;
        EXPECT_NEAR(volume, 4.0 / 3.0 * 3.14159265 * std::pow(0.37, 3), 0.01);
    }
}

/// Random values, of few different ones so that every case occurs, ambiguous ones and nodes at the level among them.
std::vector<float> random_values(std::size_t nodes, std::mt19937& random, int kinds) {
    std::uniform_int_distribution<int> any(0, kinds);
    std::vector<float> out(nodes);
    for (float& each : out)
        each = static_cast<float>(any(random)) / static_cast<float>(kinds);
    return out;
}

TEST(LevelTriangles, OfRandomValuesHaveNoCracksInAnyShape) {
    std::mt19937 random(1);
    for (const Cut cut : all_cuts) {
        SCOPED_TRACE(static_cast<int>(cut));
        const Grid grid(cut_block(9, cut, tests::wavy));
        for (const int kinds : {1, 2, 5, 1'000'000})
            for (int i = 0; i < 4; ++i)
                expect_watertight(
                    extracted(grid, random_values(node_count(grid), random, kinds), 0.5), on_cube);
    }
}

TEST(LevelTriangles, OfRandomValuesHaveNoCracksInAGridAndWhereShapesMeet) {
    std::mt19937 random(2);
    const Grid grid(unit_cube(12));
    using Kind = tests::TwoToOne::Kind;
    std::bernoulli_distribution fine(0.4);
    tests::TwoToOne refined(
        5, [&](const Vec3&) { return fine(random) ? Kind::Fine : Kind::Coarse; },
        [](const Vec3& u) { return u; });
    const Grid mixed(refined.take());
    for (const Grid& each : {grid, mixed})
        for (const int kinds : {1, 2, 1'000'000})
            for (int i = 0; i < 8; ++i)
                expect_watertight(
                    extracted(each, random_values(node_count(each), random, kinds), 0.5), on_cube);
}

TEST(LevelTriangles, OfAGridAreThoseOfTheSameHexahedra) {
    std::mt19937 random(3);
    const Grid grid(unit_cube(7));
    const Grid mesh(tests::block({7, 7, 7}, [](const Vec3& u) { return u; }));
    const auto values = random_values(node_count(grid), random, 1000);
    const auto of_grid = extracted(grid, values, 0.4);
    const auto of_mesh = extracted(mesh, values, 0.4);
    EXPECT_EQ(of_grid.triangles, of_mesh.triangles);
    ASSERT_EQ(of_grid.points.size(), of_mesh.points.size());
    for (std::size_t i = 0; i < of_grid.points.size(); ++i)
        EXPECT_LT(glm::length(of_grid.points[i] - of_mesh.points[i]), 1e-12);
}

TEST(LevelTriangles, AreTheSameOnAnyNumberOfThreads) {
    const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 4);
    std::mt19937 random(4);
    for (const Grid& grid : {Grid(unit_cube(40)), Grid(cut_block(24, Cut::Mixed, tests::wavy))}) {
        const auto values = random_values(node_count(grid), random, 1000);
        const auto on = [&](int threads) {
            tbb::task_arena arena(threads);
            return arena.execute([&] { return extracted(grid, values, 0.5); });
        };
        const auto one = on(1), four = on(4);
        EXPECT_EQ(one.triangles, four.triangles);
        EXPECT_EQ(one.points, four.points);
    }
}

TEST(LevelTriangles, OfCellsWithANodeWithoutAValueAreLeftOut) {
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const auto hole = [](const Vec3& p) { return glm::length(p - Vec3(0.9, 0.5, 0.5)) < 0.2; };
    for (const float gap : {none, infinite, -infinite})
        for (const Grid& grid :
             {Grid(unit_cube(20)), Grid(cut_block(14, Cut::Mixed, tests::wavy))}) {
            auto values = values_of(grid, sphere);
            const std::size_t all = extracted(grid, values, 0.37).triangles.size();
            for (std::size_t i = 0; i < values.size(); ++i)
                if (hole(node_position(grid, i)))
                    values[i] = gap;
            const auto found = extracted(grid, values, 0.37);
            EXPECT_LT(found.triangles.size(), all);
            EXPECT_GT(found.triangles.size(), all / 2);
            for (const Vec3& p : found.points)
                EXPECT_NEAR(sphere(p), 0.37, 0.02) << "no spikes";
            expect_watertight(found, [](const Vec3& p) { return p.x > 0.6; });
        }
}

TEST(LevelTriangles, ThroughNodesThatHaveTheLevelStayClosedAndAreThere) {
    const auto diamond = [](const Vec3& p) {
        return 8.0 * (std::abs(p.x - 0.5) + std::abs(p.y - 0.5) + std::abs(p.z - 0.5));
    };
    for (const Grid& grid :
         {Grid(unit_cube(8)),
          Grid(cut_block(8, Cut::Tetrahedra, [](const Vec3& u) { return u; }))}) {
        const auto found = extracted(grid, values_of(grid, diamond), 2.0);
        expect_watertight(found, nowhere);
        EXPECT_EQ(euler(found), 2);
        for (const Vec3& p : found.points)
            EXPECT_NEAR(diamond(p), 2.0, 1e-12);
    }
}

TEST(LevelTriangles, OfAPlaneOfNodesAtTheLevelLieInIt) {
    const Grid grid(unit_cube(8));
    const auto found = extracted(grid, values_of(grid, [](const Vec3& p) { return p.z; }), 0.5);
    EXPECT_EQ(found.triangles.size(), 128U);
    expect_watertight(found, on_cube);
    for (const Vec3& p : found.points)
        EXPECT_EQ(p.z, 0.5);
}

TEST(LevelTriangles, AreNoneWhereNothingCrossesTheLevel) {
    const Grid grid(unit_cube(6));
    const auto constant = values_of(grid, [](const Vec3&) { return 0.5; });
    for (const double level : {0.0, 0.5, 1.0})
        EXPECT_TRUE(extracted(grid, constant, level).triangles.empty());
    const auto heights = values_of(grid, [](const Vec3& p) { return p.z; });
    for (const double level : {-1.0, 0.0, 1.0001, 1e300, -1e300})
        EXPECT_TRUE(extracted(grid, heights, level).triangles.empty()) << level;
    const std::vector<float> none(heights.size(), std::numeric_limits<float>::quiet_NaN());
    EXPECT_TRUE(extracted(grid, none, 0.5).triangles.empty());
    EXPECT_TRUE(extracted(Grid(CellMesh{}), {}, 0.5).triangles.empty());
    const Grid flat(UniformGrid{Vec3(0.0), Vec3(1.0), {4, 4, 1}});
    EXPECT_TRUE(extracted(flat, std::vector<float>(16), 0.0).triangles.empty());
}

TEST(LevelTriangles, OfALevelBetweenNeighbouringFloatsSeparateThem) {
    const Grid grid(unit_cube(1));
    const float low = 0.1F;
    const float high = std::nextafter(low, 1.0F);
    const auto values = values_of(grid, [&](const Vec3& p) { return p.x > 0.5 ? high : low; });
    const double between = 0.5 * (double{low} + double{high});
    for (const double level : {between, std::nextafter(double{low}, 1.0), double{high}})
        EXPECT_EQ(extracted(grid, values, level).triangles.size(), 2U);
    EXPECT_TRUE(extracted(grid, values, low).triangles.empty());
}

TEST(LevelTriangles, OfACellWithARepeatedNodeRepeatNoPoint) {
    CellMesh mesh; // a hexahedron collapsed to a wedge, beside one
    mesh.points = {{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {1, 1, 1},
                   {1, 0, 1}, {2, 0, 0}, {2, 1, 0}, {2, 1, 1}, {2, 0, 1}};
    tests::add_cell(mesh, CellShape::Hexahedron, {0, 3, 2, 1, 0, 5, 4, 1});
    tests::add_cell(mesh, CellShape::Hexahedron, {3, 6, 7, 2, 5, 9, 8, 4});
    const Grid grid(mesh);
    const auto found = extracted(grid, values_of(grid, [](const Vec3& p) { return p.y; }), 0.5);
    EXPECT_EQ(found.triangles.size(), 3U);
    EXPECT_EQ(found.points.size(), 5U);
    expect_watertight(found, [](const Vec3&) { return true; });
}

TEST(LevelTriangles, AreNotMadeWhereTheyAreTooMany) {
    const Grid grid(unit_cube(16));
    const auto values = values_of(grid, sphere);
    const std::size_t all = extracted(grid, values, 0.37).triangles.size();
    const auto found = level_triangles(grid, values, 0.37, all - 1, {}, {});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->needed, all);
    EXPECT_TRUE(found->triangles.empty());
    EXPECT_EQ(level_triangles(grid, values, 0.37, all, {}, {})->triangles.size(), all);
}

TEST(LevelTriangles, EndWithTheStopTokenAndWithoutMemory) {
    const Grid grid(unit_cube(48));
    const auto values = values_of(grid, gyroid);
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = level_triangles(grid, values, 0.1, 1U << 30, stop.get_token(), {});
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().code, Error::Code::Cancelled);

    const auto with = [&](std::size_t budget, const auto& judge) {
        const MemoryAccount account(budget);
        WorkMemory memory(account, {}, std::chrono::milliseconds(0));
        WorkDone done;
        judge(level_triangles(grid, values, 0.1, 1U << 30, {}, WorkPart(&done, &memory)), memory);
    };
    with(64 << 20, [](const Result<LevelTriangles>& found, const WorkMemory& memory) {
        ASSERT_TRUE(found);
        EXPECT_EQ(memory.bytes(),
                  found->points.size() * sizeof(Vec3) + found->triangles.size() * sizeof(Triangle));
    });
    with(256 << 10, [](const Result<LevelTriangles>& found, const WorkMemory&) {
        ASSERT_FALSE(found);
        EXPECT_EQ(found.error().code, Error::Code::OverLimit);
    });
}

} // namespace
} // namespace wakesurf::core::level_triangles_test
