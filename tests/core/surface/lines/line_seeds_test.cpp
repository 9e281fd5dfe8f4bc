// Seeds of streamlines: evenly where they are asked for, and refused in words where that cannot be.
#include "core/surface/lines/line_seeds.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace wakesurf::core::line_seeds_test {

namespace {

using Kind = LineSeeds::Kind;
const Box domain{Vec3(-1.0), Vec3(1.0)};

std::string refusal(const LineSeeds& seeds) {
    const auto checked = check_line_seeds(seeds, domain);
    return checked ? "" : checked.error().message + ": " + checked.error().hint;
}

/// A square of 2 by 1, the second half of it in many small triangles' worth of quads.
QuadComplex plate() {
    QuadComplex wall;
    const auto quad = [&](double x, double length) {
        const auto first = static_cast<VertexId>(wall.position.size());
        for (const Vec3& each :
             {Vec3(x, 0, 0), Vec3(x + length, 0, 0), Vec3(x + length, 1, 0), Vec3(x, 1, 0)})
            wall.position.push_back(each);
        wall.cells.push_back({{first, first + 1, first + 2, first + 3}, Cell{}.mid});
    };
    quad(0.0, 1.0);
    for (int i = 0; i < 100; ++i)
        quad(1.0 + i * 0.01, 0.01);
    return wall;
}

} // namespace

TEST(LineSeeds, OnALineAreAtEvenDistancesWithItsEnds) {
    const auto seeds = line_seed_places({Kind::Line, {{0, 0, 0}, {1, 0, 0}}, 0.0, 5});
    ASSERT_EQ(seeds.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_NEAR(seeds[i].x, 0.25 * static_cast<double>(i), 1e-15);
    EXPECT_EQ(line_seed_places({Kind::Line, {{0, 0, 0}, {1, 0, 0}}, 0.0, 1})[0], Vec3(0.5, 0, 0));
}

TEST(LineSeeds, InAPlaneAreAsFarApartAlongAsAcross) {
    const auto seeds = line_seed_places({Kind::Plane, {{0, 0, 0}, {2, 0, 0}, {0, 0, 1}}, 0.0, 50});
    ASSERT_EQ(seeds.size(), 50u);
    EXPECT_EQ(seeds[0], Vec3(0.1, 0, 0.1));
    EXPECT_NEAR(glm::distance(seeds[1], Vec3(0.3, 0, 0.1)), 0.0, 1e-15);
    EXPECT_NEAR(glm::distance(seeds[10], Vec3(0.1, 0, 0.3)), 0.0, 1e-15);
}

TEST(LineSeeds, OnASphereLieAtItsRadiusEvenlyAllRound) {
    const Vec3 centre(0.1, 0.2, 0.3);
    const auto seeds = line_seed_places({Kind::Sphere, {centre}, 0.5, 400});
    ASSERT_EQ(seeds.size(), 400u);
    Vec3 sum(0.0);
    double least = 1.0;
    for (const Vec3& each : seeds) {
        EXPECT_NEAR(glm::distance(each, centre), 0.5, 1e-12);
        sum += each - centre;
        for (const Vec3& other : seeds)
            if (&other != &each)
                least = std::min(least, glm::distance(each, other));
    }
    EXPECT_LT(glm::length(sum) / 400.0, 1e-3);
    // Of equal hexagons of all its area: 0.095.
    EXPECT_GT(least, 0.07);
}

TEST(LineSeeds, OnWallsLieEvenlyByAreaHoweverTheyAreCut) {
    const auto places = value_of(even_wall_places(plate(), 200, {}));
    ASSERT_EQ(places.size(), 200u);
    int left = 0;
    double least = 1.0;
    for (const WallPlace& each : places) {
        left += each.place.x < 1.0 ? 1 : 0;
        EXPECT_EQ(std::abs(each.normal.z), 1.0);
        for (const WallPlace& other : places)
            if (&other != &each)
                least = std::min(least, glm::distance(each.place, other.place));
    }
    EXPECT_NEAR(left, 100, 8);
    EXPECT_GT(least, 0.05); // 0.1 where all lie in squares
    EXPECT_TRUE(value_of(even_wall_places(QuadComplex{}, 10, {})).empty());
}

TEST(LineSeeds, ThatCannotBeAreRefusedWithTheCure) {
    const auto expect = [](const LineSeeds& seeds, const std::string& words) {
        EXPECT_NE(refusal(seeds).find(words), std::string::npos) << refusal(seeds);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect({Kind::Sphere, {{0, 0, 0}}, 1e30, 9}, "1e+30 is no radius for a sphere in this domain");
    expect({Kind::Sphere, {{0, 0, 0}}, 1e30, 9}, "choose one from 3.46e-06 to 3.46");
    expect({Kind::Sphere, {{0, 0, 0}}, 1e-30, 9}, "no radius");
    expect({Kind::Sphere, {{0, 0, 0}}, nan, 9}, "no radius");
    expect({Kind::Walls, {}, 0.0, 9}, "no distance from walls");
    expect({Kind::Along, {}, 0.1, 9}, "of spheres and walls only");
    expect({Kind::Along, {{0, 0, 0}}, 0.0, 9}, "lines along the walls have no points");
    expect({Kind::Line, {{0, 0, 0}, {1, 0, 0}}, 0.0, 9, {"hull"}}, "of seeds at walls only");
    expect({Kind::Line, {{0, 0, 0}, {1, 0, 0}}, 0.5, 9}, "leave it out");
    expect({Kind::Line, {{0, 0, 0}}, 0.0, 9}, "a line has two points");
    expect({Kind::Line, {{0, 0, 0}, {0, 0, 0}}, 0.0, 9}, "the same place");
    expect({Kind::Line, {{0, 0, 0}, {nan, 0, 0}}, 0.0, 9}, "not finite");
    expect({Kind::Line, {{0, 0, 0}, {1, 0, 0}}, 0.0, 0}, "choose 1 or more");
    expect({Kind::Plane, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, 0.0, 9}, "lie on a line");
    expect({Kind::Line, {{5, 0, 0}, {6, 0, 0}}, 0.0, 9}, "in x it goes from -1 to 1");
    expect({Kind::Sphere, {{5, 0, 0}}, 0.5, 9}, "move them inside it");
    expect({Kind::Plane, {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}}, 0.0, 9}, "far outside");
    EXPECT_EQ(refusal({Kind::Sphere, {{1.2, 0, 0}}, 0.5, 9}), "");
    EXPECT_EQ(refusal({Kind::Plane, {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, 0.0, 9}), "");
}

} // namespace wakesurf::core::line_seeds_test
