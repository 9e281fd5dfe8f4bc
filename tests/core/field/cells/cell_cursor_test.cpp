#include "core/field/cells/cell_cursor.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>

namespace wakesurf::core::cell_cursor_test {

using namespace tests;

namespace {

constexpr auto always = [](std::uint32_t) { return true; };

Vec3 swirl(const Vec3& p) {
    return {std::sin(3.0 * p.y + p.z), std::cos(2.0 * p.x * p.z), p.x * p.y - 0.3};
}

struct Meshed {
    const char* name;
    CellMesh mesh;
};

std::vector<Meshed> meshes() {
    std::vector<Meshed> all;
    all.push_back({"ring", block({12, 24, 8}, round_cylinder, true)});
    all.push_back({"wavy", block({9, 8, 7}, wavy)});
    all.push_back({"graded", block({14, 14, 14}, [](const Vec3& u) {
                       return wavy(Vec3(std::pow(1e-6, 1.0 - u.x), u.y * u.y, u.z));
                   })});
    all.push_back({"refined", TwoToOne(
                                  8,
                                  [](const Vec3& c) {
                                      return glm::length(c - 0.5) < 0.3 ? TwoToOne::Kind::Fine
                                                                        : TwoToOne::Kind::Coarse;
                                  },
                                  wavy)
                                  .take()});
    return all;
}

} // namespace

TEST(CellCursor, AnswersAsIfItStartedAnewWhereverItComesFrom) {
    for (Meshed& each : meshes()) {
        const MeshedField field(std::move(each.mesh), swirl);
        const CellSampler anew = field.sampler();
        const auto cursor = anew.cursor();
        std::mt19937 random(3);
        int inside = 0;
        for (int i = 0; i < 10'000; ++i) {
            const Vec3 p = field.random_point(random);
            const PointStatus status = anew.status(p);
            ASSERT_EQ(cursor.status(p), status) << each.name << " " << i;
            if (status != PointStatus::Inside)
                continue;
            ++inside;
            ASSERT_LT(glm::length(cursor.velocity(p, 0.0) - anew.velocity(p, 0.0)), 1e-9)
                << each.name << " " << i;
        }
        EXPECT_GT(inside, 5000) << each.name;
    }
}

TEST(CellCursor, FindsByNeighboursWhatTheLocatorFinds) {
    for (Meshed& each : meshes()) {
        const MeshedField field(std::move(each.mesh), swirl);
        CellCursor cursor(field.domain);
        CellGeometry geometry;
        std::mt19937 random(5);
        std::normal_distribution<double> by(0.0, 1.0);
        Vec3 p = field.random_point(random);
        const Vec3 stride = 0.02 * field.domain.locator.bounds().extent();
        for (int i = 0; i < 10'000; ++i) {
            const double x = by(random), y = by(random), z = by(random);
            const auto found = field.domain.locator.find(p, geometry);
            const PointStatus status = cursor.locate(p, true, always);
            ASSERT_EQ(status == PointStatus::Inside, found.has_value()) << each.name << " " << i;
            if (found) {
                EXPECT_EQ(cursor.cell(), found->cell) << each.name << " " << i;
                EXPECT_LT(glm::length(cursor.geometry().position(cursor.local()) - p),
                          1e-11 * field.domain.locator.bounds().diagonal());
            }
            p = found ? p + stride * Vec3(x, y, z) : field.random_point(random);
        }
    }
}

TEST(CellCursor, OutsideStaysAtTheNearestPlaceInTheLastCell) {
    const MeshedField field(block({4, 4, 4}, [](const Vec3& u) { return u; }), swirl);
    CellCursor cursor(field.domain);
    EXPECT_EQ(cursor.locate({0.6, 0.6, 0.9}, true, always), PointStatus::Inside);
    EXPECT_EQ(cursor.locate({0.7, 0.7, 1.3}, true, always), PointStatus::OutsideDomain);
    EXPECT_LT(glm::length(cursor.geometry().position(cursor.local()) - Vec3(0.7, 0.7, 1.0)), 1e-12);
    EXPECT_EQ(cursor.locate({0.7, 0.7, 0.99}, true, always), PointStatus::Inside);
}

TEST(CellCursor, StaysInItsBlockWhereBlocksOverlapAndGoesOverAtItsEnd) {
    CellMesh mesh;
    add_block(mesh, {6, 3, 3}, [](const Vec3& u) { return Vec3(0.6 * u.x, u.y, u.z); });
    add_block(mesh, {5, 4, 4}, [](const Vec3& u) { return Vec3(0.43 + 0.57 * u.x, u.y, u.z); });
    connect_cells(mesh);
    const MeshedField field(std::move(mesh), swirl);
    constexpr std::uint32_t second = 6 * 3 * 3;
    CellCursor cursor(field.domain);
    for (double x = 0.005; x < 0.99; x += 0.01) {
        ASSERT_EQ(cursor.locate({x, 0.51, 0.52}, true, always), PointStatus::Inside) << x;
        EXPECT_EQ(cursor.cell() >= second, x > 0.6) << x;
    }
    for (double x = 0.985; x > 0.01; x -= 0.01) {
        ASSERT_EQ(cursor.locate({x, 0.51, 0.52}, true, always), PointStatus::Inside) << x;
        EXPECT_EQ(cursor.cell() >= second, x > 0.43) << x;
    }
}

TEST(CellCursor, AGapBetweenBlocksIsOutside) {
    CellMesh mesh;
    add_block(mesh, {3, 3, 3}, [](const Vec3& u) { return Vec3(0.45 * u.x, u.y, u.z); });
    add_block(mesh, {3, 3, 3}, [](const Vec3& u) { return Vec3(0.55 + 0.45 * u.x, u.y, u.z); });
    connect_cells(mesh);
    const MeshedField field(std::move(mesh), swirl);
    CellCursor cursor(field.domain);
    for (double x = 0.005; x < 1.0; x += 0.01)
        EXPECT_EQ(cursor.locate({x, 0.51, 0.52}, true, always) == PointStatus::Inside,
                  x < 0.45 || x > 0.55)
            << x;
}

TEST(CellCursor, PassesThroughCellsWithoutVolume) {
    CellMesh mesh = block({5, 3, 3}, [](const Vec3& u) { // the third layer has no thickness
        constexpr double x[] = {0.0, 0.25, 0.5, 0.5, 0.75, 1.0};
        return Vec3(x[std::lround(5.0 * u.x)], u.y, u.z);
    });
    add_cell(mesh, CellShape::Tetrahedron, {0, 1, 2, 1});            // an edge
    add_cell(mesh, CellShape::Pyramid, {0, 1, 2, 3, 2});             // a row of points
    add_cell(mesh, CellShape::Wedge, {5, 5, 5, 5, 5, 5});            // a point
    add_cell(mesh, CellShape::Hexahedron, {0, 1, 7, 6, 0, 1, 7, 6}); // a square
    connect_cells(mesh);
    const MeshedField field(std::move(mesh), swirl);
    std::mt19937 random(17);
    CellCursor cursor(field.domain);
    for (double x = 0.005; x < 1.0; x += 0.01) {
        ASSERT_EQ(cursor.locate({x, 0.51, 0.52}, true, always), PointStatus::Inside) << x;
        EXPECT_TRUE(finite(cursor.local()));
    }
    const CellSampler anew = field.sampler();
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = field.random_point(random);
        EXPECT_EQ(anew.status(p), PointStatus::Inside);
        EXPECT_TRUE(finite(anew.velocity(p, 0.0)));
    }
    EXPECT_EQ(anew.status({0.5, 0.4, 0.3}), PointStatus::Inside);
    EXPECT_TRUE(finite(anew.velocity({0.5, 0.4, 0.3}, 0.0)));
}

TEST(CellCursor, CrossesTheAxisOfAMeshWhoseCellsCollapseThere) {
    const MeshedField field(block(
                                {5, 12, 4},
                                [](const Vec3& u) {
                                    const double angle = 6.283185307179586 * u.y;
                                    return Vec3(u.x * std::cos(angle), u.x * std::sin(angle), u.z);
                                },
                                true),
                            [](const Vec3& p) { return Vec3(p.x, p.y, 1.0); });
    const auto cursor = field.sampler().cursor();
    for (double x = -0.9; x < 0.9; x += 0.05) {
        const Vec3 p(x, 0.001, 0.4);
        EXPECT_EQ(cursor.status(p), PointStatus::Inside) << x;
        EXPECT_LT(glm::length(cursor.velocity(p, 0.0) - Vec3(p.x, p.y, 1.0)), 1e-6) << x;
    }
    for (double z = 0.05; z < 1.0; z += 0.1) { // on the axis itself
        EXPECT_EQ(field.sampler().status({0, 0, z}), PointStatus::Inside) << z;
        EXPECT_LT(glm::length(field.sampler().velocity({0, 0, z}, 0.0) - Vec3(0, 0, 1)), 1e-6) << z;
    }
}

} // namespace wakesurf::core::cell_cursor_test
