#include "core/field/cells/cell_locator.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace wakesurf::core::cell_locator_test {

using namespace tests;

TEST(CellLocator, FindsTheCellThatLookingAtAllOfThemFinds) {
    const CellMesh mesh = block({7, 9, 6}, round_cylinder, true);
    const CellLocator locator(mesh);
    CellGeometry geometry;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    int inside = 0;
    for (int i = 0; i < 1000; ++i) {
        const double x = part(random), y = part(random), z = part(random);
        const Vec3 p = locator.bounds().lo + locator.bounds().extent() * Vec3(x, y, z);
        std::optional<std::uint32_t> first;
        for (std::uint32_t cell = 0; cell < mesh.cells.size() && !first; ++cell) {
            geometry.enter(mesh, cell);
            if (Vec3 local; contains(geometry, p, local))
                first = cell;
        }
        const auto found = locator.find(p, geometry);
        ASSERT_EQ(found.has_value(), first.has_value());
        if (found) {
            EXPECT_EQ(found->cell, *first);
        }
        inside += found.has_value();
    }
    EXPECT_GT(inside, 500);
}

TEST(CellLocator, EveryCellOfAMeshGradedOverNineDecadesIsFoundAtItsCentre) {
    const CellMesh mesh = block({40, 6, 6}, [](const Vec3& u) {
        return Vec3(std::pow(10.0, -9.0 * (1.0 - u.x)), u.y + 0.1 * u.x, u.z);
    });
    const CellLocator locator(mesh);
    CellGeometry geometry;
    for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell) {
        geometry.enter(mesh, cell);
        const auto found = locator.find(geometry.position(Vec3(0.5)), geometry);
        ASSERT_TRUE(found);
        EXPECT_EQ(found->cell, cell);
    }
}

TEST(CellLocator, OnFacesAndNodesTheCellOfLowestNumberIsFound) {
    const CellMesh mesh = block({4, 4, 4}, [](const Vec3& u) { return u; });
    const CellLocator locator(mesh);
    CellGeometry geometry;
    EXPECT_EQ(locator.find({0.5, 0.5, 0.5}, geometry)->cell, 1u + 4 + 16);
    EXPECT_EQ(locator.find({0.5, 0.6, 0.6}, geometry)->cell, 1u + 2 * 4 + 2 * 16);
    EXPECT_EQ(locator.find({0, 0, 0}, geometry)->cell, 0u);
    EXPECT_EQ(locator.find({1, 1, 1}, geometry)->cell, 63u);
    EXPECT_FALSE(locator.find({1.0001, 0.5, 0.5}, geometry));
}

TEST(CellLocator, IsTheSameOnAnyNumberOfThreads) {
    const CellMesh mesh = block({40, 40, 20}, round_cylinder, true);
    std::vector<std::optional<std::uint32_t>> expected;
    for (const std::size_t threads : {1u, 2u, 3u}) {
        tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const CellLocator locator(mesh);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> part(-8.0, 8.0);
        std::vector<std::optional<std::uint32_t>> found;
        for (int i = 0; i < 1000; ++i) {
            const double x = part(random), y = part(random), z = part(random);
            found.push_back(locator.near({x, y, z})); // shows the order of equals, too
        }
        if (expected.empty())
            expected = found;
        EXPECT_EQ(found, expected);
    }
}

TEST(CellLocator, AMeshWithoutCellsContainsNothing) {
    const CellMesh mesh;
    const CellDomain domain(mesh);
    CellGeometry geometry;
    EXPECT_FALSE(domain.locator.find({0, 0, 0}, geometry));
    const CellSampler sampler{&domain, nullptr, nullptr};
    EXPECT_EQ(sampler.status({0, 0, 0}), PointStatus::OutsideDomain);
    EXPECT_EQ(sampler.velocity({0, 0, 0}, 0.0), Vec3(0.0));
}

TEST(CellLocator, APointOfATwistedCellIsFoundThoughNotFromItsCentre) {
    const CellMesh cube = block({1, 1, 1}, [](const Vec3& u) { return u; });
    CellGeometry geometry;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.0, 1.0), shift(-0.6, 0.6);
    int found = 0;
    for (int i = 0; i < 200'000; ++i) {
        CellMesh mesh = cube;
        for (Vec3& point : mesh.points)
            for (int axis = 0; axis < 3; ++axis)
                point[axis] += shift(random);
        geometry.enter(mesh, 0);
        if (geometry.flat())
            continue;
        Vec3 u, local(0.5);
        for (int axis = 0; axis < 3; ++axis)
            u[axis] = part(random);
        const Vec3 p = geometry.position(u);
        if (geometry.surely_outside(p) || geometry.invert(p, local))
            continue;
        bool inside = false;
        for (int k = 0; k < 8 && !inside; ++k) {
            local = {k & 1 ? 0.9 : 0.1, k & 2 ? 0.9 : 0.1, k & 4 ? 0.9 : 0.1};
            inside = geometry.invert(p, local) && inside_cell(CellShape::Hexahedron, local);
        }
        geometry.enter(mesh, 0);
        EXPECT_EQ(contains(geometry, p, local), inside) << i;
        found += inside;
    }
    EXPECT_GT(found, 20);
}

TEST(CellGeometry, VolumesOfARefinedMeshSumToTheDomains) {
    const CellMesh mesh =
        TwoToOne(
            5,
            [](const Vec3& c) { return c.x < 0.5 ? TwoToOne::Kind::Fine : TwoToOne::Kind::Coarse; },
            wavy)
            .take();
    // The Jacobian of each shape is of so low a degree that Gauss points integrate it exactly.
    const double a = 0.5 - 0.5 * std::sqrt(0.6), b = 0.5 + 0.5 * std::sqrt(0.6);
    const double at[3] = {a, 0.5, b};
    const double weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    double sum = 0.0;
    for (std::uint32_t i = 0; i < mesh.cells.size(); ++i) {
        CellGeometry geometry;
        geometry.enter(mesh, i);
        for (std::size_t k = 0; k < node_count(geometry.shape()); ++k)
            EXPECT_LT(glm::length(geometry.position(node_local(geometry.shape(), k)) -
                                  mesh.points[mesh.cells[i].node[k]]),
                      1e-15);
        for (int k = 0; k < 27; ++k) {
            Vec3 u(at[k % 3], at[k / 3 % 3], at[k / 9]);
            double part = weight[k % 3] * weight[k / 3 % 3] * weight[k / 9];
            if (geometry.shape() == CellShape::Pyramid ||
                geometry.shape() == CellShape::Tetrahedron) {
                const double scale = 1.0 - u.z;
                part *= scale * scale;
                u.x *= scale;
                u.y *= scale;
            }
            if (geometry.shape() == CellShape::Tetrahedron) {
                part *= 1.0 - u.x / (1.0 - u.z);
                u.y *= 1.0 - u.x / (1.0 - u.z);
            }
            const auto slope = geometry.polynomial().slopes(geometry.pyramid(), u);
            sum += part * std::abs(glm::dot(slope[0].vector(),
                                            glm::cross(slope[1].vector(), slope[2].vector())));
        }
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
}

} // namespace wakesurf::core::cell_locator_test
