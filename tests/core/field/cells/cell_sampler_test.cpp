#include "core/field/cells/cell_sampler.hpp"
#include "tests/support/meshed_field.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace wakesurf::core::cell_sampler_test {

using namespace tests;

namespace {

/// Small integers times multiples of 1/64 are floats: the nodes' velocities are exact.
Vec3 linear(const Vec3& p) {
    return {1.0 + 2.0 * p.x - 3.0 * p.y + p.z, -2.0 + p.x + 4.0 * p.z, 3.0 * p.y - 2.0 * p.z};
}

Vec3 linear_change(const Vec3& w) {
    return linear(w) - linear(Vec3(0.0));
}

double largest(const Vec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

std::vector<Vec3> inner_points(const CellMesh& mesh, int count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    CellGeometry geometry;
    geometry.enter(mesh, 0);
    std::vector<Vec3> points;
    while (static_cast<int>(points.size()) < count) {
        const double u = part(random), v = part(random), w = part(random);
        if (inside_cell(geometry.shape(), {u, v, w}))
            points.push_back(geometry.position({u, v, w}));
    }
    return points;
}

} // namespace

TEST(CellSampler, ReproducesALinearVelocityExactlyInEveryShape) {
    for (CellMesh& mesh : single_cells()) {
        const MeshedField field(std::move(mesh), linear);
        const CellSampler sampler = field.sampler();
        for (const Vec3& p : inner_points(*field.mesh, 1000)) {
            ASSERT_EQ(sampler.status(p), PointStatus::Inside);
            EXPECT_LT(largest(sampler.velocity(p, 0.0) - linear(p)), 2e-11);
            const Vec3 w(0.3, -0.5, 0.7);
            EXPECT_LT(largest(sampler.derivative(p, 0.0, w) - linear_change(w)), 1e-9);
        }
    }
}

TEST(CellSampler, DerivativeIsTheDifferenceQuotientInsideBentCells) {
    const auto swirl = [](const Vec3& p) {
        return Vec3(std::sin(2.0 * p.y + p.z), std::cos(p.x * p.z), p.x * p.y);
    };
    for (CellMesh& mesh : single_cells()) {
        const MeshedField field(std::move(mesh), swirl, linear);
        CellSampler sampler = field.sampler();
        sampler.interval = 2.0;
        constexpr double h = 1e-5;
        for (const Vec3& p : inner_points(*field.mesh, 200)) {
            const Vec3 w(0.3, -0.5, 0.7);
            if (sampler.status(p + h * w) != PointStatus::Inside ||
                sampler.status(p - h * w) != PointStatus::Inside)
                continue;
            const Vec3 quotient =
                (sampler.velocity(p + h * w, 0.6) - sampler.velocity(p - h * w, 0.6)) / (2.0 * h);
            EXPECT_LT(largest(sampler.derivative(p, 0.6, w) - quotient),
                      3e-7 * (1.0 + largest(quotient)));
        }
    }
}

TEST(CellSampler, IsLinearBetweenTimeSteps) {
    const MeshedField field(
        block({3, 3, 3}, wavy), [](const Vec3&) { return Vec3(1, 2, 3); },
        [](const Vec3&) { return Vec3(5, 2, -1); });
    CellSampler sampler = field.sampler();
    sampler.time0 = 10.0;
    sampler.interval = 4.0;
    EXPECT_LT(largest(sampler.velocity(Vec3(0.4), 11.0) - Vec3(2, 2, 2)), 1e-12);
    EXPECT_LT(largest(sampler.velocity(Vec3(0.4), 14.0) - Vec3(5, 2, -1)), 1e-12);
}

TEST(CellSampler, GivesTheNodesVelocitiesAtNodesApexesIncluded) {
    const auto flow = [](const Vec3& p) { return Vec3(p.x * p.y, p.z - p.x, 1.0 + p.z * p.z); };
    for (CellMesh& mesh : single_cells()) {
        const MeshedField field(std::move(mesh), flow);
        for (std::size_t i = 0; i < field.mesh->points.size(); ++i) {
            const Vec3 p = field.mesh->points[i];
            EXPECT_EQ(field.sampler().status(p), PointStatus::Inside);
            EXPECT_LT(largest(field.sampler().velocity(p, 0.0) - flow(p)), 1e-6); // float nodes
        }
    }
}

TEST(CellSampler, ContinuesConstantlyOutsideAndIsNeverNotANumber) {
    const MeshedField field(block({3, 3, 3}, wavy), linear);
    const CellSampler sampler = field.sampler();
    EXPECT_EQ(sampler.status(Vec3(0.5, 0.5, 1.2)), PointStatus::OutsideDomain);
    EXPECT_LT(largest(sampler.velocity(Vec3(0.5, 0.5, 1.01), 0.0) - linear(Vec3(0.5, 0.5, 1.0))),
              0.1);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const auto cursor = sampler.cursor();
    for (const Vec3& p : {Vec3(nan, 0, 0), Vec3(0, infinite, 0), Vec3(1e200), Vec3(-7, 3, 0.5),
                          Vec3(0.5), Vec3(nan)}) {
        EXPECT_TRUE(finite(sampler.velocity(p, 0.0)));
        EXPECT_TRUE(finite(cursor.velocity(p, 0.0)));
        EXPECT_TRUE(finite(cursor.derivative(p, 0.0, Vec3(1.0))));
        if (p != Vec3(0.5)) {
            EXPECT_EQ(cursor.status(p), PointStatus::OutsideDomain);
        }
    }
}

TEST(CellSampler, WhereAVelocityIsNotANumberTheDomainEnds) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const MeshedField field(
        block({10, 2, 2}, [](const Vec3& u) { return u; }),
        [](const Vec3&) { return Vec3(1, 0, 0); },
        [&](const Vec3& p) { return p.x > 0.55 ? Vec3(nan) : Vec3(1, 0, 0); });
    CellSampler sampler = field.sampler();
    sampler.gaps = true;
    const auto cursor = sampler.cursor();
    EXPECT_EQ(cursor.status({0.45, 0.5, 0.5}), PointStatus::Inside);
    for (const double x : {0.55, 0.75, 0.95}) {
        EXPECT_EQ(sampler.status({x, 0.5, 0.5}), PointStatus::OutsideDomain);
        EXPECT_EQ(cursor.status({x, 0.5, 0.5}), PointStatus::OutsideDomain);
        EXPECT_EQ(cursor.velocity({x, 0.5, 0.5}, 0.5), Vec3(1, 0, 0));
        EXPECT_TRUE(finite(sampler.velocity({x, 0.5, 0.5}, 0.5)));
    }
    EXPECT_EQ(cursor.status({0.49, 0.5, 0.5}), PointStatus::Inside);
}

} // namespace wakesurf::core::cell_sampler_test
