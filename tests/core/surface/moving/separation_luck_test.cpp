// A surface that is crushed before two bodies, at separations that differ by a few hundredths: a rule that
// works by luck at one of them fails at another. So the worst of them counts.
#include "core/field/bounded_form.hpp"
#include "core/field/closed_forms.hpp"
#include "tests/support/moving_runs.hpp"

#include <gtest/gtest.h>

#include <array>

namespace wakesurf::core::separation_luck_test {

namespace {

using namespace tests;

constexpr double most_slivers = 0.05;

/// Two round pillars in a channel, one behind the other and a little beside it, in a stream that swings to
/// and fro. The velocity is zero on both, as that of a real fluid: the stream function is of second order
/// there.
struct TwoPillars {
    static constexpr double radius = 0.4, height = 1.5;
    static constexpr std::array<double, 2> x{-0.8, 0.9}, y{0.15, -0.2};

    Vec3 velocity(const Vec3& p, double t) const {
        const double above = p.y - 0.2 * std::sin(1.3 * t);
        const double profile = above * (1.0 - above * above / (3.0 * height * height));
        const double slope = 1.0 - above * above / (height * height);
        double all = 1.0;
        std::array<double, 2> factor{}, by_x{}, by_y{};
        for (std::size_t i = 0; i < 2; ++i) {
            const double dx = p.x - x[i], dy = p.y - y[i];
            const double r2 = std::max(dx * dx + dy * dy, 0.8 * radius * radius);
            const double q = 1.0 - radius * radius / r2;
            const double dq = 4.0 * q * radius * radius / (r2 * r2);
            factor[i] = q * q;
            by_x[i] = dq * dx;
            by_y[i] = dq * dy;
            all *= factor[i];
        }
        const double along_x = by_x[0] * factor[1] + by_x[1] * factor[0];
        const double along_y = by_y[0] * factor[1] + by_y[1] * factor[0];
        return {slope * all + profile * along_y, -profile * along_x,
                0.3 * all * std::sin(2.0 * p.x + t)};
    }

    bool solid(const Vec3& p) const {
        return std::hypot(p.x - x[0], p.y - y[0]) < radius ||
               std::hypot(p.x - x[1], p.y - y[1]) < radius;
    }

    WallGeometry wall(const Box& box) const { return cylinder_wall(radius, box); }
};

std::shared_ptr<const Flow> two_pillars() {
    return std::make_shared<AnalyticFlow<TwoPillars>>(TwoPillars{},
                                                      Box{Vec3(-4, -1.5, -2), Vec3(5, 1.5, 2)});
}

/// The worst share of slivers at four separations, all within two hundredths of one.
void expect_few_slivers(const Rake& rake, const SurfaceParameters& asked, const char* name) {
    const auto flow = two_pillars();
    for (const double part : {0.98, 0.99, 1.01, 1.02}) {
        SurfaceParameters p = asked;
        p.separation *= part;
        const MeshShape shape = final_shape({flow, rake, p, name});
        EXPECT_TRUE(shape.quads > 100 && shape.slivers <= most_slivers && shape.specks == 0)
            << name << ", separation times " << part << ": " << shape;
    }
}

} // namespace

TEST(SeparationLuck, ATimeSurfaceThatIsCrushedBeforeTwoBodiesHasFewSlivers) {
    expect_few_slivers(line_rake({-2.5, -0.4, -0.3}, {-2.5, 0.4, -0.3}),
                       swept({0.4, 0, 0.1}, 8, 0.12), "along the stream");
}

TEST(SeparationLuck, ATimeSurfaceThatIsDrawnOverTwoBodiesHasFewSlivers) {
    expect_few_slivers(line_rake({-1.9, -0.8, -0.6}, {-1.9, 0.8, -0.6}),
                       swept({0.3, 0, 1.2}, 4, 0.12), "across the stream");
}

TEST(SeparationLuck, AStreakThatPassesTwoBodiesHasFewSlivers) {
    expect_few_slivers(line_rake({-2.5, -0.9, -0.6}, {-2.5, 0.9, 0.5}), streak(6, 0.16), "streak");
}

} // namespace wakesurf::core::separation_luck_test
