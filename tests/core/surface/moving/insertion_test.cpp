#include "core/surface/moving/insertion.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace wakesurf::core::insertion_test {

namespace {

Vec3 wave(double s, double t) {
    return {s, t, std::sin(s) * std::cos(t)};
}

MaterialPoint on_wave(double s, double t) {
    MaterialPoint point;
    point.carried = {
        wave(s, t), {1.0, 0.0, std::cos(s) * std::cos(t)}, {0.0, 1.0, -std::sin(s) * std::sin(t)}};
    point.s = s;
    point.t = t;
    return point;
}

/// Two vertices.
MovingMesh edge(const MaterialPoint& a, const MaterialPoint& b) {
    MovingMesh mesh;
    mesh.vertices.add(a, VertexRole::Free, 0.0);
    mesh.vertices.add(b, VertexRole::Free, 0.0);
    return mesh;
}

struct Direction {
    double s, t;
};

constexpr std::array directions{Direction{1.0, 0.0}, Direction{0.0, 1.0}, Direction{0.6, -0.8}};

/// Distance of the inserted point from the surface's, for an edge of this length about (0.7, 0.4).
double error(InsertionPolicy policy, Direction d, double length) {
    const double s = 0.5 * length * d.s;
    const double t = 0.5 * length * d.t;
    const MovingMesh mesh = edge(on_wave(0.7 - s, 0.4 - t), on_wave(0.7 + s, 0.4 + t));
    return glm::length(midpoint(mesh, 0, 1, policy).point.carried.position - wave(0.7, 0.4));
}

double order(InsertionPolicy policy, Direction d) {
    return std::log2(error(policy, d, 0.2) / error(policy, d, 0.1));
}

} // namespace

TEST(Insertion, HermiteIsOfFourthOrderInTheEdgesLength) {
    for (const Direction d : directions) {
        EXPECT_GT(order(InsertionPolicy::Hermite, d), 3.9);
        EXPECT_LT(error(InsertionPolicy::Hermite, d, 0.1), 1e-6);
    }
}

TEST(Insertion, AnEdgeAloneWithoutTangentsHasItsChordOfSecondOrder) {
    for (const Direction d : directions) {
        EXPECT_NEAR(order(InsertionPolicy::Line, d), 2.0, 0.1);
        EXPECT_GT(error(InsertionPolicy::Line, d, 0.1), 1e-4);
    }
}

TEST(Insertion, TangentsInTheMiddleAreThoseOfTheCubicAlongTheEdge) {
    for (const Direction d : directions)
        for (const double length : {0.2, 0.1}) {
            const double s = 0.5 * length * d.s;
            const double t = 0.5 * length * d.t;
            const MovingMesh mesh = edge(on_wave(0.7 - s, 0.4 - t), on_wave(0.7 + s, 0.4 + t));
            const Carried mid = midpoint(mesh, 0, 1, InsertionPolicy::Hermite).point.carried;
            const Carried exact = on_wave(0.7, 0.4).carried;
            const Vec3 along = d.s * mid.along_s + d.t * mid.along_t;
            const Vec3 wanted = d.s * exact.along_s + d.t * exact.along_t;
            EXPECT_LT(glm::length(along - wanted), std::pow(length, 4.0)) << length;
        }
}

TEST(Insertion, TheMiddleIsThatOfTheParametersAndThePlaces) {
    MaterialPoint a = on_wave(0.25, 1.0);
    MaterialPoint b = on_wave(0.5, 2.0);
    a.place = {1.0, 3.0};
    b.place = {2.0, 2.5};
    a.birth_area = 1.0f;
    b.birth_area = 3.0f;
    const MaterialPoint mid = midpoint(edge(a, b), 0, 1, InsertionPolicy::Hermite).point;
    EXPECT_EQ(mid.s, 0.375);
    EXPECT_EQ(mid.t, 1.5);
    EXPECT_EQ(mid.place.column, 1.5);
    EXPECT_EQ(mid.place.row, 2.75);
    EXPECT_EQ(mid.birth_area, 2.0f);
    EXPECT_TRUE(mid.approximated);
}

TEST(Insertion, TheEdgesDirectionDoesNotMatter) {
    const MovingMesh mesh = edge(on_wave(0.6, 0.3), on_wave(0.8, 0.5));
    const Vec3 there = midpoint(mesh, 0, 1, InsertionPolicy::Hermite).point.carried.position;
    const Vec3 back = midpoint(mesh, 1, 0, InsertionPolicy::Hermite).point.carried.position;
    EXPECT_LT(glm::length(there - back), 1e-15);
}

TEST(Insertion, TangentsThatCannotBeTrustedLeaveThePointOnTheChord) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double wild : {30.0, 1e200, infinite, nan}) {
        MaterialPoint a = on_wave(0.6, 0.4);
        MaterialPoint b = on_wave(0.8, 0.4);
        a.carried.along_s.z = wild;
        const MovingMesh mesh = edge(a, b);
        const Midpoint mid = midpoint(mesh, 0, 1, InsertionPolicy::Hermite);
        EXPECT_EQ(mid.point.carried.position, 0.5 * (a.carried.position + b.carried.position))
            << wild;
        EXPECT_GT(mid.bulge, 0.25) << wild;
    }
}

TEST(Insertion, TheBulgeIsTheCubicsSagittaOverTheChord) {
    // A circle's arc of angle 2x with exact tangents: sagitta/chord = tan(x / 2) / 2, up to the cubic's own error.
    for (const double x : {0.2, 0.1}) {
        const auto on_circle = [](double s) {
            MaterialPoint point;
            point.carried.position = {std::cos(s), std::sin(s), 0.0};
            point.carried.along_s = {-std::sin(s), std::cos(s), 0.0};
            point.s = s;
            return point;
        };
        const MovingMesh mesh = edge(on_circle(1.0 - x), on_circle(1.0 + x));
        EXPECT_NEAR(relative_sagitta(mesh, 0, 1), 0.5 * std::tan(0.5 * x), x * x * x);
        EXPECT_EQ(midpoint(mesh, 0, 1, InsertionPolicy::Hermite).bulge,
                  relative_sagitta(mesh, 0, 1));
    }
}

TEST(Insertion, AClosedRakesLastEdgeRunsTheShortWayRound) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const auto on_ring = [](double s, double column) {
        MaterialPoint point;
        point.carried.position = {std::cos(turn * s), std::sin(turn * s), 0.0};
        point.carried.along_s = Vec3(-std::sin(turn * s), std::cos(turn * s), 0.0) * turn;
        point.s = s;
        point.place.column = column;
        return point;
    };
    MovingMesh mesh = edge(on_ring(0.875, 7.0), on_ring(0.0, 0.0));
    mesh.lattice = {8.0, true, 0.0};
    for (const bool swapped : {false, true}) {
        const Midpoint mid =
            midpoint(mesh, swapped ? 1 : 0, swapped ? 0 : 1, InsertionPolicy::Hermite);
        EXPECT_EQ(mid.point.s, 0.9375);
        EXPECT_EQ(mid.point.place.column, 7.5);
        EXPECT_LT(glm::length(mid.point.carried.position - on_ring(0.9375, 0.0).carried.position),
                  1e-3); // 8 pieces of a circle by cubics: (turn / 8)^4 / 384
    }
    MovingMesh across = edge(on_ring(0.9375, 7.5), on_ring(0.125, 1.0));
    across.lattice = {8.0, true, 0.0};
    const MaterialPoint past = midpoint(across, 0, 1, InsertionPolicy::Line).point;
    EXPECT_EQ(past.s, 0.03125); // beyond the seam
    EXPECT_EQ(past.place.column, 0.25);
}

} // namespace wakesurf::core::insertion_test
