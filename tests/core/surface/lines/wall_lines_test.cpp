// Lines along walls against closed forms; where they end; meshes that are no good; by any number of threads; within a memory budget.
#include "core/base/memory_account.hpp"
#include "core/surface/lines/wall_lines.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace wakesurf::core::wall_lines_test {

namespace {

constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

struct Wall {
    QuadComplex mesh;
    std::vector<Vec3f> velocity{};
    std::vector<float> values{};

    /// Each with vertices of its own.
    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const auto first = static_cast<VertexId>(mesh.vertices());
        mesh.position.insert(mesh.position.end(), {a, b, c});
        Cell cell;
        cell.corner = {first, first + 1, first + 2, first + 2};
        mesh.cells.push_back(cell);
    }

    void fill(const std::function<Vec3(const Vec3&)>& flow) {
        for (const Vec3& each : mesh.position) {
            velocity.emplace_back(flow(each));
            values.push_back(static_cast<float>(each.x));
        }
    }

    WallPlace nearest(const Vec3& place) const {
        WallPlace out;
        double least = std::numeric_limits<double>::infinity();
        const auto triangles = wall_triangles(mesh);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const auto& [a, b, c] = triangles[t];
            const Vec3 middle = (mesh.position[a] + mesh.position[b] + mesh.position[c]) / 3.0;
            if (const double far = glm::distance(middle, place); far < least) {
                least = far;
                out = {middle, {}, t};
            }
        }
        return out;
    }
};

Result<StreamLines> traced(const Wall& wall,
                           const std::vector<WallPlace>& seeds,
                           const StreamLinesRequest& request,
                           const MemoryAccount& account = MemoryAccount(std::size_t{1} << 33)) {
    WorkMemory memory(account, {}, std::chrono::milliseconds(0), "these lines");
    return trace_wall_lines(request, {wall.mesh, wall.velocity, wall.values}, seeds, 0.02, memory,
                            {});
}

/// A ball of radius 1: eight sides of n by n triangles.
Wall ball(int n) {
    Wall out;
    for (int octant = 0; octant < 8; ++octant) {
        const auto at = [&](int i, int j) {
            const Vec3 flat(i, j, n - i - j);
            const Vec3 sign(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
            return glm::normalize(sign * flat);
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                out.add(at(i, j), at(i + 1, j), at(i, j + 1));
                if (i + j + 1 < n)
                    out.add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            }
    }
    return out;
}

/// A square of side 2 about the origin, of n by n quads, each cut in two and moved at random within the square.
Wall square(int n) {
    Wall out;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> some(-0.3, 0.3);
    std::vector<Vec3> at;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const bool inner = i > 0 && j > 0 && i < n && j < n;
            const double x = inner ? some(random) : 0.0, y = inner ? some(random) : 0.0;
            at.emplace_back(2.0 * (i + x) / n - 1.0, 2.0 * (j + y) / n - 1.0, 0.5);
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto corner = [&](int k, int l) {
                return at[static_cast<std::size_t>((j + l) * (n + 1) + i + k)];
            };
            out.add(corner(0, 0), corner(1, 0), corner(0, 1));
            out.add(corner(1, 0), corner(0, 1), corner(1, 1)); // turned the other way
        }
    return out;
}

double to_the_middle(const StreamLines& lines) {
    double farthest = 0.0;
    const Vec3 first = lines.points.front();
    const double meridian = std::atan2(first.z, first.y);
    for (const Vec3& each : lines.points)
        if (std::hypot(each.y, each.z) > 0.3)
            farthest =
                std::max(farthest, std::abs(std::remainder(std::atan2(each.z, each.y) - meridian,
                                                           2.0 * std::numbers::pi)));
    return farthest;
}

} // namespace

TEST(WallLines, OfAUniformFlowOnABallAreMeridiansToTheSecondOrder) {
    const auto error = [](int n) {
        Wall wall = ball(n);
        wall.fill([](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
        double sum = 0.0;
        for (int i = 0; i < 12; ++i) {
            const double angle = 0.3 + 0.5 * i;
            const auto lines = value_of(
                traced(wall, {wall.nearest({-0.9, 0.4 * std::cos(angle), 0.4 * std::sin(angle)})},
                       {.direction = Direction::Forward, .length = 2.0}));
            EXPECT_GT(lines.points.back().x, 0.4);
            sum += to_the_middle(lines);
        }
        return sum / 12;
    };
    const double coarse = error(16), fine = error(64);
    EXPECT_LT(coarse, 0.1);
    EXPECT_GT(std::log(coarse / fine) / std::log(4.0), 1.5) << coarse << " " << fine;
}

TEST(WallLines, OfALinearFlowOnAPlaneAreItsSpiralsToRounding) {
    Wall wall = square(9);
    const double pull = 0.25;
    wall.fill([&](const Vec3& p) { // what goes through the wall does not count
        return Vec3(-pull * p.x - p.y, p.x - pull * p.y, 7.0);
    });
    const WallPlace seed = wall.nearest({0.5, 0.4, 0.5});
    const auto lines = value_of(traced(wall, {seed}, {.duration = 1.5, .length = 9.0}));
    ASSERT_EQ(lines.lines(), 1u);
    EXPECT_EQ(lines.ends.limit + lines.ends.domain, 2u);
    EXPECT_GT(lines.points.size(), 20u);
    EXPECT_LT(lines.times.front(), 0.0F);
    EXPECT_NEAR(lines.times.back(), 1.5, 1e-6);
    for (std::size_t i = 0; i < lines.points.size(); ++i) {
        const double t = lines.times[i];
        const double shrunk = std::exp(-pull * t);
        const Vec3 expected(shrunk * (std::cos(t) * seed.place.x - std::sin(t) * seed.place.y),
                            shrunk * (std::sin(t) * seed.place.x + std::cos(t) * seed.place.y),
                            0.5);
        EXPECT_LT(glm::distance(lines.points[i], expected), 2e-6) << "velocities have 32 bits";
        EXPECT_NEAR(lines.values[i], lines.points[i].x, 1e-6);
    }
}

TEST(WallLines, EndWhereTheFlowRestsAndAtTheBorder) {
    Wall sink = square(9);
    sink.fill([](const Vec3& p) { return Vec3(-p.x, -p.y, 0.0); });
    const auto in = value_of(traced(sink, {sink.nearest({0.5, 0.2, 0.5})}, {.length = 9.0}));
    EXPECT_EQ(in.ends.rest, 1u);
    EXPECT_EQ(in.ends.domain, 1u);
    EXPECT_LT(glm::length(in.points.back() - Vec3(0, 0, 0.5)), 1e-4);
    EXPECT_NEAR(std::max(std::abs(in.points.front().x), std::abs(in.points.front().y)), 1.0, 1e-9);
}

TEST(WallLines, ThatCreepWhereNearlyNothingFlowsHaveComeToRest) {
    Wall valley = square(9);
    valley.fill([](const Vec3& p) { return Vec3(-p.x, 1e-5, 0.0); });
    const auto lines = value_of(traced(valley, {valley.nearest({0.5, 0.0, 0.5})},
                                       {.direction = Direction::Forward, .length = 9.0}));
    EXPECT_EQ(lines.ends.rest, 1u);
    EXPECT_LT(std::abs(lines.points.back().x), 1e-6);
    EXPECT_LT(lines.times.back(), 500.0F) << "it would take 1e5";
}

TEST(WallLines, ThatGoRoundCloseAndEnd) {
    Wall tube;
    constexpr int sides = 40;
    const auto at = [](int i, double z) {
        const double angle = 2.0 * std::numbers::pi * (i % sides) / sides;
        return Vec3(std::cos(angle), std::sin(angle), z);
    };
    for (int i = 0; i < sides; ++i) {
        tube.add(at(i, 0), at(i + 1, 0), at(i + 1, 1));
        tube.add(at(i, 0), at(i + 1, 1), at(i, 1));
    }
    tube.fill([](const Vec3& p) { return Vec3(-p.y, p.x, 0.0); });
    const auto lines = value_of(traced(tube, {tube.nearest({1, 0, 0.4})},
                                       {.direction = Direction::Forward, .length = 1000.0}));
    EXPECT_EQ(lines.ends.limit, 1u);
    EXPECT_LT(lines.times.back(), 4.0 * 2.0 * std::numbers::pi) << "not for the whole length";
    for (const Vec3& each : lines.points)
        EXPECT_NEAR(each.z, lines.points.front().z, 1e-9);
}

TEST(WallLines, OnMeshesThatAreNoGoodEndOnTheMeshTheSameOnAnyNumberOfThreads) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(-1.0, 1.0);
    for (int round = 0; round < 20; ++round) {
        Wall wall = ball(6);
        for (int i = 0; i < 20; ++i) { // slivers, points, doubles and fins
            const auto any = [&] { return wall.mesh.position[random() % wall.mesh.vertices()]; };
            const Vec3 a = any(), b = any();
            wall.add(a, b, a);
            wall.add(a, 0.5 * (a + b), b);
            wall.add(a, b, any());
            wall.add(a, a, a);
        }
        wall.fill([&](const Vec3&) { return Vec3(some(random), some(random), some(random)); });
        for (std::size_t i = 0; i < wall.velocity.size(); i += 97)
            wall.velocity[i] = Vec3f(no_number);
        const auto seeds = value_of(even_wall_places(wall.mesh, 60, {}));
        const StreamLinesRequest request{.length = 20.0, .most_points = 20'000};
        const auto lines = value_of(traced(wall, seeds, request));
        EXPECT_LE(lines.points.size(), 20'000u);
        for (const Vec3& each : lines.points) {
            ASSERT_TRUE(finite(each));
            EXPECT_LT(glm::length(each), 1.0 + 1e-9);
        }
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        const auto again = value_of(traced(wall, seeds, request));
        EXPECT_EQ(again.points, lines.points);
        EXPECT_EQ(again.times, lines.times);
    }
}

TEST(WallLines, BesideWhichNothingIsKnownAreLeftOutAndMemoryIsAskedFor) {
    Wall wall = square(3);
    wall.fill([](const Vec3&) { return Vec3(1.0, 0.0, 0.0); });
    const std::vector<WallPlace> seeds{wall.nearest({0, 0, 0.5}), wall.nearest({0.9, 0.9, 0.5})};
    const auto refused = traced(wall, seeds, {.length = 9.0}, MemoryAccount(1000));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Error::Code::OverLimit);
    std::ranges::fill(wall.velocity, Vec3f(no_number));
    const auto none = value_of(traced(wall, seeds, {.length = 9.0}));
    EXPECT_EQ(none.lines(), 0u);
    EXPECT_EQ(none.outside, 2u);
}

} // namespace wakesurf::core::wall_lines_test
