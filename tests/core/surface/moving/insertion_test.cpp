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

/// An edge from vertex 0 to 1 with a triangle on either side, their tips at right angles to it and somewhat
/// beside its middle; it is edge 0 of triangle 0. @param point  what the surface is at (s, t)
template <class Point>
MovingMesh edge(Point point, double s0, double t0, double s1, double t1, bool closed = false) {
    MovingMesh mesh;
    mesh.rectangle = {.closed = closed, .patch = true};
    const auto add = [&](double s, double t) {
        MaterialPoint made = point(s, t);
        made.s = mesh.rectangle.wrapped_s(s);
        mesh.vertices.add(made, VertexRole::Free, 0.0);
    };
    const double s = s1 - s0, t = t1 - t0;
    add(s0, t0);
    add(s1, t1);
    add(s0 + 0.6 * s - 0.9 * t, t0 + 0.6 * t + 0.9 * s);
    add(s0 + 0.3 * s + 1.1 * t, t0 + 0.3 * t - 1.1 * s);
    const std::array<std::array<VertexId, 4>, 1> quads{{{1, 2, 0, 3}}};
    mesh.triangles.append(quads);
    return mesh;
}

MaterialPoint middle(const MovingMesh& mesh) {
    const auto [t, k] = mesh.triangles.find(0, 1);
    return point_on_edge(mesh, t, k);
}

struct Direction {
    double s, t;
};

constexpr std::array directions{Direction{1.0, 0.0}, Direction{0.0, 1.0}, Direction{0.6, -0.8}};

MovingMesh edge_on_wave(Direction d, double length) {
    const double s = 0.5 * length * d.s;
    const double t = 0.5 * length * d.t;
    return edge(on_wave, 0.7 - s, 0.4 - t, 0.7 + s, 0.4 + t);
}

/// Distances of the inserted point and of its tangents from the surface's, for an edge of this length about
/// (0.7, 0.4).
struct Errors {
    double position, tangents;
};

Errors errors(Direction d, double length) {
    const Carried made = middle(edge_on_wave(d, length)).carried;
    const Carried exact = on_wave(0.7, 0.4).carried;
    return {glm::length(made.position - exact.position),
            glm::length(made.along_s - exact.along_s) + glm::length(made.along_t - exact.along_t)};
}

double order(double coarse, double fine) {
    return std::log2(coarse / fine);
}

} // namespace

TEST(Insertion, IsOfFourthOrderInTheEdgesLength) {
    for (const Direction d : directions) {
        EXPECT_GT(order(errors(d, 0.2).position, errors(d, 0.1).position), 3.9);
        EXPECT_LT(errors(d, 0.1).position, 1e-6);
    }
}

TEST(Insertion, TangentsTimesTheEdgeAreOfFourthOrderAsWell) {
    for (const Direction d : directions)
        EXPECT_GT(order(errors(d, 0.2).tangents, errors(d, 0.1).tangents), 2.9) << d.s;
}

TEST(Insertion, AtTheSurfacesBoundaryTangentsAreOneOrderLess) {
    for (const Direction d : directions) {
        const auto error = [&](double length) {
            MovingMesh mesh = edge_on_wave(d, length);
            mesh.triangles.tear(mesh.triangles.find(1, 0).triangle);
            const Carried made = middle(mesh).carried;
            const Carried exact = on_wave(0.7, 0.4).carried;
            return glm::length(made.along_s - exact.along_s) +
                   glm::length(made.along_t - exact.along_t);
        };
        EXPECT_NEAR(order(error(0.2), error(0.1)), 2.0, 0.3) << d.s;
    }
}

TEST(Insertion, TangentsInTheMiddleAreThoseOfTheCubicAlongTheEdge) {
    for (const Direction d : directions)
        for (const double length : {0.2, 0.1}) {
            const Carried mid = middle(edge_on_wave(d, length)).carried;
            const Carried exact = on_wave(0.7, 0.4).carried;
            const Vec3 along = d.s * mid.along_s + d.t * mid.along_t;
            const Vec3 wanted = d.s * exact.along_s + d.t * exact.along_t;
            EXPECT_LT(glm::length(along - wanted), std::pow(length, 4.0)) << length;
        }
}

TEST(Insertion, TheMiddleIsThatOfTheParameters) {
    const auto point = [](double s, double t) {
        MaterialPoint made = on_wave(s, t);
        made.birth_area = static_cast<float>(8.0 * s - 1.0);
        return made;
    };
    const MaterialPoint mid = middle(edge(point, 0.25, 1.0, 0.5, 2.0));
    EXPECT_EQ(mid.s, 0.375);
    EXPECT_EQ(mid.t, 1.5);
    EXPECT_EQ(mid.birth_area, 2.0f);
    EXPECT_TRUE(mid.approximated);
}

TEST(Insertion, TheEdgesDirectionDoesNotMatter) {
    const MovingMesh mesh = edge(on_wave, 0.6, 0.3, 0.8, 0.5);
    const auto back = mesh.triangles.find(1, 0);
    const Vec3 there = middle(mesh).carried.position;
    EXPECT_LT(glm::length(there - point_on_edge(mesh, back.triangle, back.k).carried.position),
              1e-15);
}

TEST(Insertion, AnyPartOfAnEdgeIsOnTheSameCubic) {
    const MovingMesh mesh = edge(on_wave, 0.6, 0.3, 0.8, 0.5);
    const auto [t, k] = mesh.triangles.find(0, 1);
    for (const double part : {0.0, 0.25, 0.5, 0.9, 1.0}) {
        const MaterialPoint made = point_on_edge(mesh, t, k, part);
        EXPECT_EQ(made.carried.position, edge_cubic(mesh, 0, 1).at(part).position);
        EXPECT_NEAR(made.s, 0.6 + 0.2 * part, 1e-15);
        EXPECT_LT(glm::length(made.carried.position - wave(made.s, made.t)), 1e-4);
        EXPECT_LT(glm::length(made.carried.along_s - on_wave(made.s, made.t).carried.along_s),
                  1e-2);
    }
}

TEST(Insertion, TangentsThatCannotBeTrustedLeaveThePointOnTheChord) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double wild : {30.0, 1e200, infinite, nan}) {
        MovingMesh mesh = edge(on_wave, 0.6, 0.4, 0.8, 0.4);
        mesh.vertices.along_s[0].z = wild;
        const auto& p = mesh.vertices.position;
        EXPECT_EQ(middle(mesh).carried.position, p[0] + 0.5 * (p[1] - p[0])) << wild;
    }
}

TEST(Insertion, TheBendIsTheTurnAcrossTheChord) {
    // A circle's arc of angle 2x with exact tangents: the turn is 2x times the chord's length over cos(x),
    // all of it across.
    for (const double x : {0.2, 0.1}) {
        const auto on_circle = [](double s, double t) {
            MaterialPoint point;
            point.carried.position = {std::cos(s), std::sin(s), t};
            point.carried.along_s = {-std::sin(s), std::cos(s), 0.0};
            point.carried.along_t = {0.0, 0.0, 1.0};
            point.s = s;
            point.t = t;
            return point;
        };
        const MovingMesh mesh = edge(on_circle, 1.0 - x, 0.0, 1.0 + x, 0.0);
        EXPECT_NEAR(glm::length(edge_turn(mesh, 0, 1)), 2.0 * x * 2.0 * std::sin(x), 1e-12);
        EXPECT_LT(glm::length(edge_turn(mesh, 0, 1) - edge_bend(mesh, 0, 1)), 1e-12);
    }
}

TEST(Insertion, AClosedRakesLastEdgeRunsTheShortWayRound) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const auto on_ring = [](double s, double t) {
        MaterialPoint point;
        point.carried.position = {std::cos(turn * s), std::sin(turn * s), t};
        point.carried.along_s = Vec3(-std::sin(turn * s), std::cos(turn * s), 0.0) * turn;
        point.carried.along_t = {0.0, 0.0, 1.0};
        point.s = s;
        point.t = t;
        return point;
    };
    const MaterialPoint before = middle(edge(on_ring, 0.875, 0.0, 1.0, 0.0, true));
    EXPECT_EQ(before.s, 0.9375);
    EXPECT_LT(glm::length(before.carried.position - on_ring(0.9375, 0.0).carried.position),
              1e-3); // 8 pieces of a circle by cubics: (turn / 8)^4 / 384
    const MaterialPoint past = middle(edge(on_ring, 0.9375, 0.0, 1.125, 0.0, true));
    EXPECT_EQ(past.s, 0.03125); // beyond the seam
}

} // namespace wakesurf::core::insertion_test
