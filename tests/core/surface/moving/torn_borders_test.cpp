// Where a body tears a sheet: the tear is one clean border along the body and the line behind it, without
// holes beside it, crumbs, or cells that reach into the body.
#include "core/field/analytic_flow.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace wakesurf::core::torn_borders_test {

namespace {

using namespace tests;

constexpr double radius = 0.5;    ///< of both bodies
constexpr double deepest = 0.25;  ///< of the separation
constexpr double farthest = 0.45; ///< of the separation, a torn edge from where the true sheet ends
/// Length. A body squeezes the sheet beside it: what is narrower there than 0.15 of the separation is taken
/// off, and would be wider behind it.
constexpr double squeezed = 0.13;

/// The cylinder stands along z.
double from_axis(const Vec3& p, bool cylinder) {
    return cylinder ? std::hypot(p.x, p.y) : glm::length(p);
}

/// The smallest distance from the axis of all vertices, and of the middles of edges and cells.
double deepest_point(const QuadComplex& mesh, bool cylinder) {
    double least = 1e300;
    for (const Cell& cell : mesh.cells) {
        const CellOutline outline(mesh, cell);
        Vec3 centre(0.0);
        for (std::uint32_t i = 0; i < outline.count; ++i) {
            centre += outline.point[i] / static_cast<double>(outline.count);
            least = std::min({least, from_axis(outline.point[i], cylinder),
                              from_axis(0.5 * (outline.point[i] + outline.next(i)), cylinder)});
        }
        least = std::min(least, from_axis(centre, cylinder));
    }
    return least;
}

/// How far from the stagnation line a particle passes the rake that is at `p` now: the stream function, as a
/// length.
double offset_at_release(const Vec3& p, bool cylinder) {
    const double ratio = std::min(1.0, radius / from_axis(p, cylinder));
    return cylinder ? std::abs(p.y) * (1.0 - ratio * ratio)
                    : std::hypot(p.y, p.z) * std::sqrt(1.0 - ratio * ratio * ratio);
}

/// How far a point of a torn edge is from where a particle that is released ever closer to the stagnation
/// line goes, along the body, then along the middle of its wake: now, or when it was released.
double off_true_edge(const Vec3& p, bool cylinder) {
    const double beside = cylinder ? std::abs(p.y) : std::hypot(p.y, p.z);
    const double off_body = std::abs(from_axis(p, cylinder) - radius);
    const double now = p.x > 0.0 ? std::min(off_body, beside) : off_body;
    return std::min(now, offset_at_release(p, cylinder));
}

/// Edges of the border that are not the rake's ends, the first row or the newest one.
double farthest_torn_edge(const KeyedMesh& shown, bool cylinder) {
    const QuadComplex& mesh = shown.mesh;
    const auto on_rectangle = [&](VertexId a, VertexId b) {
        const auto both = [&](const auto& at) { return at(a) && at(b); };
        return both([&](VertexId v) { return mesh.s[v] == 0.0; }) ||
               both([&](VertexId v) { return mesh.s[v] == 1.0; }) ||
               both([&](VertexId v) { return mesh.t[v] <= 0.1; }) ||
               both([&](VertexId v) { return mesh.t[v] == shown.time; });
    };
    double most = 0.0;
    for (const auto& [a, b] : border_edges(mesh))
        if (!on_rectangle(a, b))
            most = std::max({most, off_true_edge(mesh.position[a], cylinder),
                             off_true_edge(mesh.position[b], cylinder)});
    return most;
}

/// The worst of all looks at a surface.
struct Seen {
    std::int64_t most_holes = 0, fewest_holes = 0, last_holes = 0;
    std::size_t specks = 0, quads = 0;
    double depth = 0.0;    ///< into the body, in separations
    double torn_off = 0.0; ///< a torn edge from the true one, in separations

    /// @param own  holes that the body may make: it pierces a patch, while a streak sheet is torn from its
    ///             oldest row on. A tear in a patch grows in some steps, with a bridge over it.
    bool clean(std::int64_t own = 0) const {
        return quads > 100 && fewest_holes >= 0 && last_holes <= own && most_holes <= 2 * own &&
               specks == 0 && depth <= deepest;
    }
};

std::ostream& operator<<(std::ostream& out, const Seen& all) {
    return out << all.quads << " quads, at most " << all.most_holes << " holes, " << all.specks
               << " specks, " << all.depth << " deep, torn edges " << all.torn_off << " off";
}

Seen seen(const char* flow, const Rake& rake, const SurfaceParameters& p, int looks) {
    const bool cylinder = std::string_view(flow) == "cylinder";
    Seen all;
    follow({*make_analytic_flow(flow), rake, p, flow}, looks,
           [&](const MovingSurface&, const KeyedMesh& shown) {
               const MeshShape shape = shape_of(shown.mesh);
               all.quads = shape.quads;
               all.most_holes = std::max(all.most_holes, shape.holes());
               all.fewest_holes = std::min(all.fewest_holes, shape.holes());
               all.last_holes = shape.holes();
               all.specks = std::max(all.specks, shape.specks);
               const double deep = radius - deepest_point(shown.mesh, cylinder);
               all.depth = std::max(all.depth, deep / p.separation);
               if (p.kind == SurfaceKind::Streak)
                   all.torn_off =
                       std::max(all.torn_off, farthest_torn_edge(shown, cylinder) / p.separation);
           });
    return all;
}

/// Across the cylinder, turned by an angle in the plane that the flow is perpendicular to.
Rake tilted(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec3 half = 1.1 * Vec3(0.0, std::cos(angle), std::sin(angle));
    return line_rake(Vec3(-2, 0, 0) - half, Vec3(-2, 0, 0) + half);
}

void expect_clean_tears_at_tilts(double separation, double first, double step, double last) {
    for (double degrees = first; degrees <= last; degrees += step) {
        const double to = separation < 0.1 ? 4.5 : 6.0;
        const Seen all = seen("cylinder", tilted(degrees), streak(to, separation), 6);
        EXPECT_TRUE(all.clean()) << degrees << " degrees: " << all;
        // Rakes nearly along the cylinder come to it with all of their seeds.
        if (degrees <= 60.0) {
            EXPECT_LE(all.torn_off, farthest) << degrees << " degrees: " << all;
        }
    }
}

} // namespace

TEST(TornBorders, OfACylinderHaveNoHolesBesideAndNoSpecksHoweverTheRakeIsTilted) {
    expect_clean_tears_at_tilts(0.2, 0.0, 5.0, 85.0);
    for (const double degrees : {41.0, 44.0}) // tears that began to grow behind the border
        expect_clean_tears_at_tilts(0.2, degrees, 1.0, degrees);
}

TEST(TornBorders, OfACylinderHaveNoHolesBesideAndNoSpecksAtHalfTheSeparation) {
    expect_clean_tears_at_tilts(0.1, 5.0, 25.0, 80.0);
}

TEST(TornBorders, OfACylinderHaveNoHolesBesideAndNoSpecksWhenFine) {
    expect_clean_tears_at_tilts(0.05, 30.0, 30.0, 30.0);
}

/// Rakes of any length, place and tilt, at any separation.
TEST(TornBorders, OfACylinderHaveNoHolesFromRandomRakes) {
    std::mt19937 random(13);
    const auto within = [&](double least, double most) {
        return least + (most - least) * static_cast<double>(random()) / std::mt19937::max();
    };
    for (int i = 0; i < 24; ++i) {
        const double angle = within(0.0, 0.5 * std::numbers::pi), half = within(0.4, 1.2);
        const Vec3 across = half * Vec3(within(-0.2, 0.2), std::cos(angle), std::sin(angle));
        const Vec3 middle(-2.0, within(-0.1, 0.1), within(-0.1, 0.1));
        const double to = within(4.0, 6.0), separation = within(0.1, 0.2);
        const Rake rake = line_rake(middle - across, middle + across);
        const Seen all = seen("cylinder", rake, streak(to, separation), 3);
        EXPECT_EQ(all.most_holes, 0) << "rake " << i << ": " << all;
    }
}

/// The truth of a rake beside the centre is a sheet that is drawn over the body, and may be torn there, from
/// the oldest row on.
TEST(TornBorders, OfASphereHaveNoHolesBesideAndNoSpecksThroughItsCentreAndBesideIt) {
    for (const double beside : {0.0, 0.001, 0.01, 0.1})
        for (const double separation : {0.2, 0.1}) {
            const Rake rake = line_rake({-2, -1, beside}, {-2, 1, beside});
            const Seen all = seen("sphere", rake, streak(6, separation), 6);
            EXPECT_TRUE(all.clean()) << beside << " beside, " << separation << ": " << all;
            EXPECT_LE(all.torn_off, farthest + (squeezed + beside) / separation)
                << beside << " beside, " << separation << ": " << all;
        }
}

TEST(TornBorders, OfASphereHaveNoHolesBesideAndNoSpecksWhenFine) {
    const Seen all = seen("sphere", line_rake({-2, -1, 0}, {-2, 1, 0}), streak(4.5, 0.05), 4);
    EXPECT_TRUE(all.clean()) << all;
    EXPECT_LE(all.torn_off, farthest + squeezed / 0.05) << all;
}

TEST(TornBorders, OfAPatchThatABodyPiercesAreOneHole) {
    for (const double separation : {0.2, 0.1})
        for (const double beside : {0.0, 0.013, 0.1}) {
            const Rake rake = line_rake({-1.5, -1, -1 + beside}, {-1.5, 1, -1 + beside});
            const SurfaceParameters p = swept({0, 0, 2}, 5, separation);
            const Seen sphere = seen("sphere", rake, p, 5), cylinder = seen("cylinder", rake, p, 5);
            EXPECT_TRUE(sphere.clean(1)) << beside << " beside a sphere: " << sphere;
            EXPECT_TRUE(cylinder.clean(1)) << beside << " beside a cylinder: " << cylinder;
        }
}

/// Half the separation shows no more parts: no crumb is an accident of the mesh's size.
TEST(TornBorders, LeaveAsManyPartsAtHalfTheSeparation) {
    for (const double degrees : {0.0, 20.0, 40.0}) {
        std::vector<std::size_t> parts;
        for (const double separation : {0.2, 0.1})
            parts.push_back(final_shape({*make_analytic_flow("cylinder"), tilted(degrees),
                                         streak(6, separation), "cylinder"})
                                .components);
        EXPECT_EQ(parts[0], parts[1]) << degrees << " degrees";
    }
}

} // namespace wakesurf::core::torn_borders_test
