// Lines at even distances, ribbons and arrows: what is measured on them in lengths.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/surface_cutouts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wakesurf::core::even_lines_test {

namespace {

constexpr double fan_angle = 1.2;

/// A flat fan round the origin, from radius 1 to 5: s is the angle, t the radius, both from 0 to 1. Its sides are straight.
QuadComplex fan(int n = 60) {
    QuadComplex mesh;
    for (int row = 0; row <= n; ++row)
        for (int column = 0; column <= n; ++column) {
            const double s = double(column) / n;
            const double t = double(row) / n;
            const double radius = 1.0 + 4.0 * t;
            mesh.position.push_back(
                {radius * std::cos(fan_angle * s), radius * std::sin(fan_angle * s), 0.0});
            mesh.s.push_back(s);
            mesh.t.push_back(t);
            mesh.velocity.push_back(Vec3f(mesh.position.back() / radius));
        }
    const auto at = [&](int row, int column) {
        return static_cast<VertexId>(row * (n + 1) + column);
    };
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column)
            mesh.cells.push_back({{at(row, column), at(row, column + 1), at(row + 1, column + 1),
                                   at(row + 1, column)},
                                  {no_vertex, no_vertex, no_vertex, no_vertex}});
    return mesh;
}

double area(const Cutouts& cut, std::size_t polygon) {
    const std::size_t first = polygon == 0 ? 0 : cut.ends[polygon - 1];
    Vec3 twice(0.0);
    for (std::size_t k = first; k < cut.ends[polygon]; ++k) {
        const std::size_t next = k + 1 < cut.ends[polygon] ? k + 1 : first;
        twice += glm::cross(cut.points[cut.connectivity[k]], cut.points[cut.connectivity[next]]);
    }
    return 0.5 * glm::length(twice);
}

double area(const Cutouts& cut) {
    double sum = 0.0;
    for (std::size_t i = 0; i < cut.ends.size(); ++i)
        sum += area(cut, i);
    return sum;
}

/// Of a flat convex polygon, by the triangles round its first corner: its area, and that times where its middle is along a direction.
std::pair<double, double>
area_and_moment(const Cutouts& cut, std::size_t polygon, const Vec3& along) {
    const std::size_t first = polygon == 0 ? 0 : cut.ends[polygon - 1];
    const auto point = [&](std::size_t k) { return cut.points[cut.connectivity[k]]; };
    double sum = 0.0, moment = 0.0;
    for (std::size_t k = first + 1; k + 1 < cut.ends[polygon]; ++k) {
        const double size =
            0.5 * glm::length(glm::cross(point(k) - point(first), point(k + 1) - point(first)));
        sum += size;
        moment += size * glm::dot(point(first) + point(k) + point(k + 1), along) / 3.0;
    }
    return {sum, moment};
}

double length(const std::vector<ContourLine>& lines) {
    double sum = 0.0;
    for (const ContourLine& line : lines)
        for (std::size_t i = 1; i < line.points.size(); ++i)
            sum += glm::length(line.points[i] - line.points[i - 1]);
    return sum;
}

/// Smallest distance to the mesh's vertices' facets, by way of cells' triangles round the middle of each.
double off_surface(const QuadComplex& mesh, const Vec3& p) {
    double nearest = 1e300;
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            const Vec3 a = mesh.position[outline.vertex[i]];
            const Vec3 b = mesh.position[outline.vertex[(i + 1) % outline.count]];
            const double along =
                glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            nearest = std::min(nearest, glm::length(p - glm::mix(a, b, along)));
        }
    }
    return nearest;
}

/// Of polygons that touch: how far they reach along and across, their area, and its moment along.
struct Extent {
    glm::vec<2, double> low{1e300}, high{-1e300};
    double area = 0.0, moment = 0.0;
};

std::vector<Extent> touching(const Cutouts& cut, const Vec3& along, const Vec3& across) {
    std::vector<Extent> groups;
    for (std::size_t i = 0; i < cut.ends.size(); ++i) {
        Extent joined;
        const std::size_t first = i == 0 ? 0 : cut.ends[i - 1];
        for (std::size_t k = first; k < cut.ends[i]; ++k) {
            const Vec3& p = cut.points[cut.connectivity[k]];
            const glm::vec<2, double> at(glm::dot(p, along), glm::dot(p, across));
            joined.low = glm::min(joined.low, at);
            joined.high = glm::max(joined.high, at);
        }
        const auto [size, moment] = area_and_moment(cut, i, along);
        joined.area = size;
        joined.moment = moment;
        std::erase_if(groups, [&](const Extent& other) {
            const bool apart = glm::any(glm::lessThan(other.high + 1e-9, joined.low)) ||
                               glm::any(glm::lessThan(joined.high + 1e-9, other.low));
            if (apart)
                return false;
            joined.low = glm::min(joined.low, other.low);
            joined.high = glm::max(joined.high, other.high);
            joined.area += other.area;
            joined.moment += other.moment;
            return true;
        });
        groups.push_back(joined);
    }
    return groups;
}

Surface tube() {
    const auto flow = make_analytic_flow("uniform").value();
    SurfaceParameters p{.to = 2.0, .separation = 0.1};
    return build_surface(*flow, {Rake::Kind::Circle, {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 16}, p)
        .value();
}

} // namespace

TEST(EvenLines, AUnitOfAParameterIsAsLongAsTheSurfaceIsWide) {
    const QuadComplex mesh = fan();
    const auto of_s = lengths_per_unit(mesh, mesh.s, false);
    const auto of_t = lengths_per_unit(mesh, mesh.t, false);
    for (VertexId v = 0; v < mesh.vertices(); ++v) {
        const double radius = glm::length(mesh.position[v]);
        EXPECT_NEAR(of_s[v], fan_angle * radius, 0.045 * radius);
        EXPECT_NEAR(of_t[v], 4.0, 0.01);
    }
}

TEST(EvenLines, AreNeverCloserThanSevenTenthsNorFartherThanFourteenTenthsOfTheirDistance) {
    const QuadComplex mesh = fan();
    const auto unit = lengths_per_unit(mesh, mesh.s, false);
    for (const double spacing : {0.5, 0.21, 0.1}) {
        const auto levels = even_levels(mesh, mesh.s, unit, spacing, false, 1000);
        ASSERT_TRUE(levels);
        const auto lines = even_lines(mesh, mesh.s, unit, *levels, spacing, false);
        for (double radius = 1.6; radius < 4.4; radius += 0.3) {
            std::vector<double> across;
            for (const ContourLine& line : lines)
                if (const auto [low, high] = std::minmax(
                        {glm::length(line.points.front()), glm::length(line.points.back())});
                    low <= radius && radius <= high)
                    across.push_back(line.value * fan_angle * radius);
            std::sort(across.begin(), across.end());
            ASSERT_GT(across.size(), 2u);
            for (std::size_t i = 1; i < across.size(); ++i) {
                EXPECT_GT(across[i] - across[i - 1], 0.69 * spacing) << radius;
                EXPECT_LT(across[i] - across[i - 1], 1.44 * spacing) << radius;
            }
        }
    }
    EXPECT_FALSE(even_levels(mesh, mesh.s, unit, 0.001, false, 1000));
}

TEST(EvenLines, AreAsManyAsFitHoweverUnevenTheParameterIs) {
    QuadComplex mesh = fan();
    const auto even =
        even_levels(mesh, mesh.s, lengths_per_unit(mesh, mesh.s, false), 0.4, false, 1000);
    for (double& s : mesh.s)
        s = std::exp(12.0 *
                     (s - 1.0)); // 160,000 times denser at one side, as beside a stagnation line
    const auto unit = lengths_per_unit(mesh, mesh.s, false);
    const auto dense = even_levels(mesh, mesh.s, unit, 0.4, false, 1000);
    ASSERT_TRUE(even && dense);
    EXPECT_LT(dense->size(), 6 * even->size());
    const double area = 0.5 * fan_angle * (25.0 - 1.0);
    const double together = length(even_lines(mesh, mesh.s, unit, *dense, 0.4, false));
    EXPECT_GT(together * 0.4, area / 1.4142136);
    EXPECT_LT(together * 0.4, area * 1.4142136);
}

TEST(EvenLines, StayWhereTheyAreAsTheSurfaceGrows) {
    std::vector<double> before;
    for (const double grown : {1.0, 1.3, 2.9, 5.0}) {
        QuadComplex mesh = fan();
        for (VertexId v = 0; v < mesh.vertices(); ++v) {
            mesh.t[v] *= grown; // as a front that has come so much further
            mesh.position[v] *= (1.0 + 4.0 * mesh.t[v]) / glm::length(mesh.position[v]);
        }
        const auto unit = lengths_per_unit(mesh, mesh.t, false);
        const auto levels = even_levels(mesh, mesh.t, unit, 0.9, false, 1000);
        ASSERT_TRUE(levels);
        std::vector<double> values;
        for (const EvenLevel& each : *levels)
            values.push_back(each.value);
        for (const double value : before)
            EXPECT_TRUE(std::binary_search(values.begin(), values.end(), value)) << value;
        EXPECT_GT(values.size(), before.size());
        before = values;
    }
}

TEST(EvenLines, HaveOneAtLeastWhereverTheParameterLies) {
    for (const auto& [low, high] :
         {std::pair{3.0, 5.0}, {-5.0, 5.0}, {-7.1, -7.0}, {1e6, 1e6 + 1e-3}, {0.0, 1e-9}}) {
        QuadComplex mesh = fan(8);
        for (double& t : mesh.t)
            t = low + (high - low) * t;
        const auto levels =
            even_levels(mesh, mesh.t, lengths_per_unit(mesh, mesh.t, false), 100.0, false, 10);
        ASSERT_TRUE(levels);
        ASSERT_EQ(levels->size(), 1u) << low;
        EXPECT_GT(levels->front().value, low);
        EXPECT_LT(levels->front().value, high);
    }
}

TEST(EvenLines, OfATubeGoRoundItWithoutASeam) {
    const Surface surface = tube();
    const QuadComplex& mesh = surface.mesh;
    const auto unit = lengths_per_unit(mesh, mesh.s, true);
    for (const double length : unit)
        EXPECT_NEAR(length, 2.0 * 3.14159265, 0.02);
    const auto levels = even_levels(mesh, mesh.s, unit, 0.5, true, 1000);
    ASSERT_TRUE(levels);
    EXPECT_EQ(levels->size(), 16u); // 2 pi / 0.5 is between 8 / 0.7 and 16 / 0.7
    const auto lines = even_lines(mesh, mesh.s, unit, *levels, 0.5, true);
    EXPECT_EQ(lines.size(), 16u);
    EXPECT_EQ(contour_lines(mesh, mesh.s, std::array{0.3}, {true, {}}).size(), 1u);
    for (const ContourLine& line : lines)
        for (const Vec3& p : line.points)
            EXPECT_NEAR(std::hypot(p.y, p.z), 1.0, 2e-3);
}

TEST(Ribbons, AreAsWideAsAskedAndLieInTheSurface) {
    const QuadComplex mesh = fan();
    const auto unit = lengths_per_unit(mesh, mesh.s, false);
    const auto levels = even_levels(mesh, mesh.s, unit, 0.4, false, 1000);
    ASSERT_TRUE(levels);
    constexpr double width = 0.08;
    const Cutouts cut = ribbons(mesh, mesh.s, unit, *levels, width, false).value();
    ASSERT_EQ(cut.value.size(), cut.ends.size());
    std::size_t first = 0;
    for (std::size_t i = 0; i < cut.ends.size(); ++i)
        for (; first < cut.ends[i]; ++first) {
            const Vec3 p = cut.points[cut.connectivity[first]];
            EXPECT_EQ(p.z, 0.0);
            const double away = std::atan2(p.y, p.x) - cut.value[i] * fan_angle;
            EXPECT_LE(std::abs(away) * glm::length(p), 0.5 * width * 1.03);
        }
    // Short pieces are left out of the lines only.
    const double long_ways = length(even_lines(mesh, mesh.s, unit, *levels, 0.0, false));
    EXPECT_NEAR(area(cut), width * long_ways, 0.03 * width * long_ways);
}

TEST(Ribbons, OnARealSurfaceCoverTheirLengthTimesTheirWidth) {
    const auto flow = make_analytic_flow("lamb-oseen").value();
    SurfaceParameters p;
    p.separation = 0.1;
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Streak}) {
        p.kind = kind;
        p.to = 3.0;
        const Surface surface =
            build_surface(*flow, {Rake::Kind::Line, {{0.3, 0, -1}, {1.5, 0, -1}}, 16}, p).value();
        const QuadComplex& mesh = surface.mesh;
        for (const bool timelines : {false, true}) {
            const auto& along = timelines ? mesh.t : mesh.s;
            const auto unit = lengths_per_unit(mesh, along, false);
            const auto levels = even_levels(mesh, along, unit, 0.4, false, 1000);
            ASSERT_TRUE(levels);
            constexpr double width = 0.05;
            const Cutouts cut = ribbons(mesh, along, unit, *levels, width, false).value();
            const double ways = length(even_lines(mesh, along, unit, *levels, 0.0, false));
            EXPECT_GT(ways, 3.0);
            EXPECT_NEAR(area(cut), width * ways, 0.06 * width * ways)
                << static_cast<int>(kind) << timelines;
        }
    }
}

TEST(Ribbons, OfATubeAreWholeWhereItsParameterWraps) {
    const Surface surface = tube();
    const QuadComplex& mesh = surface.mesh;
    const auto unit = lengths_per_unit(mesh, mesh.s, true);
    const std::vector<EvenLevel> seam{{1.0, 0.0}};
    const std::vector<EvenLevel> other{{0.5, 0.0}};
    const Cutouts at_seam = ribbons(mesh, mesh.s, unit, seam, 0.2, true).value();
    const Cutouts opposite = ribbons(mesh, mesh.s, unit, other, 0.2, true).value();
    EXPECT_NEAR(area(at_seam), area(opposite), 0.03 * area(opposite));
}

TEST(Arrows, HaveTheShapeAskedForPointWithTheFlowAndLieInTheSurface) {
    const auto flow = make_analytic_flow("uniform").value();
    constexpr double width = 0.12, spacing = 0.6;
    for (const Direction direction : {Direction::Forward, Direction::Backward}) {
        SurfaceParameters p{.to = direction == Direction::Forward ? 4.0 : -4.0, .separation = 0.1};
        const Surface surface =
            build_surface(*flow, {Rake::Kind::Line, {{0, -1, 0}, {0, 1, 0.3}}, 9}, p).value();
        const QuadComplex& mesh = surface.mesh;
        const auto unit = lengths_per_unit(mesh, mesh.s, false);
        const auto levels = even_levels(mesh, mesh.s, unit, spacing, false, 1000);
        ASSERT_TRUE(levels);
        const auto lines = even_lines(mesh, mesh.s, unit, *levels, spacing, false);
        const Cutouts cut = arrows(mesh, lines, spacing, width, {}).value();
        // On a line of length 4: at 0.3, 0.9 ... while 0.36 are left.
        const double each = width * width * (2.0 / 3.0 + 0.5);
        EXPECT_NEAR(area(cut) / each, 6.0 * static_cast<double>(lines.size()), 1e-6);
        // The tips of one line are its arrows' furthest points along the flow.
        double tip = -1e300;
        for (const Vec3& point : cut.points) {
            tip = std::max(tip, point.x);
            EXPECT_LT(off_surface(mesh, point), 0.08);
            EXPECT_NEAR(point.z, 0.15 * (point.y + 1.0), 1e-12);
        }
        const double last = direction == Direction::Forward ? 0.3 + 5 * spacing + 3 * width : -0.3;
        EXPECT_NEAR(tip, direction == Direction::Forward ? last : tip, 1e-9);
    }
}

TEST(Arrows, FollowTheSurfaceRoundAVortex) {
    const auto flow = make_analytic_flow("lamb-oseen").value();
    SurfaceParameters p{.to = 3.0, .separation = 0.05};
    const Surface surface =
        build_surface(*flow, {Rake::Kind::Line, {{0.5, 0, -1}, {1.5, 0, -1}}, 32}, p).value();
    const QuadComplex& mesh = surface.mesh;
    const auto unit = lengths_per_unit(mesh, mesh.s, false);
    const auto levels = even_levels(mesh, mesh.s, unit, 0.4, false, 1000);
    ASSERT_TRUE(levels);
    const auto lines = even_lines(mesh, mesh.s, unit, *levels, 0.4, false);
    const Cutouts cut = arrows(mesh, lines, 0.4, 0.06, {}).value();
    EXPECT_GT(cut.ends.size(), 20u);
    const double each = 0.06 * 0.06 * (2.0 / 3.0 + 0.5);
    const double number = area(cut) / each;
    EXPECT_NEAR(number, std::round(number), 0.06 * number);
    EXPECT_GT(number, 10.0);
    for (std::size_t i = 0; i < cut.points.size(); i += 7)
        EXPECT_LT(off_surface(mesh, cut.points[i]), 0.05);
}

TEST(Arrows, OfStreakAndTimeSurfacesPointTheWayOfTheVelocityInTheSurface) {
    // The velocity runs across the lines of the mesh, and out of its plane.
    QuadComplex mesh = fan();
    const Vec3 flow(1.0, 0.5, 2.0);
    for (Vec3f& v : mesh.velocity)
        v = Vec3f(flow);
    const auto unit = lengths_per_unit(mesh, mesh.s, false);
    const auto levels = even_levels(mesh, mesh.s, unit, 0.4, false, 1000);
    const auto lines = even_lines(mesh, mesh.s, unit, levels.value(), 0.4, false);
    constexpr double width = 0.1;
    const Cutouts cut = arrows(mesh, lines, 0.4, width, {false, false}).value();
    const double number = area(cut) / (width * width * (2.0 / 3.0 + 0.5));
    EXPECT_GT(number, 40.0);
    EXPECT_NEAR(number, std::round(number), 0.02); // whole ones only
    // Of a shaft a third as wide and twice as long as its head, the middle of the area is 11/7 of a width from the shaft's end.
    const Vec3 along = glm::normalize(Vec3(flow.x, flow.y, 0.0));
    const Vec3 across(-along.y, along.x, 0.0);
    const std::vector<Extent> each = touching(cut, along, across);
    EXPECT_EQ(each.size(), static_cast<std::size_t>(std::round(number)));
    for (const Extent& arrow : each) {
        EXPECT_NEAR(arrow.high.x - arrow.low.x, 3.0 * width, 0.005 * width);
        EXPECT_NEAR(arrow.high.y - arrow.low.y, width, 1e-9);
        EXPECT_NEAR(arrow.moment / arrow.area - arrow.low.x, 11.0 / 7.0 * width, 1e-4 * width);
    }
    for (const Vec3& point : cut.points)
        EXPECT_EQ(point.z, 0.0);
}

TEST(Arrows, AThousandMillionTimesThinnerThanACellAreMadeAsFast) {
    const QuadComplex mesh = fan();
    const auto unit = lengths_per_unit(mesh, mesh.s, false);
    const auto levels = even_levels(mesh, mesh.s, unit, 0.4, false, 1000);
    const auto lines = even_lines(mesh, mesh.s, unit, levels.value(), 0.4, false);
    const Cutouts thin = arrows(mesh, lines, 0.4, 1e-9, {}).value();
    EXPECT_GE(thin.ends.size(), 2 * lines.size());
    EXPECT_EQ(arrows(mesh, lines, 1e-6, 1e-9, {}).error().code, Error::Code::OverLimit);
}

TEST(Ribbons, ThatWouldFillTheMemoryAreRefused) {
    const QuadComplex mesh = fan();
    const auto unit = lengths_per_unit(mesh, mesh.s, false);
    std::vector<EvenLevel> levels;
    for (int i = 0; i < 1000; ++i)
        levels.push_back({i / 1000.0, 0.0});
    EXPECT_TRUE(ribbons(mesh, mesh.s, unit, levels, 1e-3, false));
    EXPECT_EQ(ribbons(mesh, mesh.s, unit, levels, 1e9, false).error().code, Error::Code::OverLimit);
}

} // namespace wakesurf::core::even_lines_test
