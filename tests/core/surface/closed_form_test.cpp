// Surfaces whose vertices a formula knows: every vertex within 1e-5 at separation 0.05 with exact accuracy.
#include "core/field/analytic_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace wakesurf::core::closed_form_test {

namespace {

struct Made {
    Surface surface;
    SeedingCurve seeding;

    template <class Visit>
    void each(const Visit& visit) const { // (seed, age, place)
        for (std::size_t v = 0; v < surface.mesh.vertices(); ++v)
            visit(seeding.at(surface.mesh.s[v]), surface.mesh.t[v], surface.mesh.position[v]);
    }
};

Made made(const char* flow,
          Vec3 a,
          Vec3 b,
          double to,
          SurfaceKind kind = SurfaceKind::Stream,
          double from = 0.0) {
    const Rake rake{Rake::Kind::Line, {a, b}, 16};
    SurfaceParameters p{.kind = kind,
                        .from = from,
                        .to = from + to,
                        .separation = 0.05,
                        .accuracy = Accuracy::Exact};
    auto surface = build_surface(**make_analytic_flow(flow), rake, p);
    EXPECT_TRUE(surface) << flow;
    EXPECT_GT(surface->mesh.cells.size(), 500u) << flow;
    return {std::move(*surface), SeedingCurve(rake)};
}

constexpr double allowed = 1e-5;

} // namespace

TEST(ClosedForm, StrainStretchesEveryAxisByItsExponential) {
    made("strain?a=0.5,b=-0.3,c=-0.2", {0.5, -1, 0.4}, {1, 1, -0.3}, 3.0)
        .each([](Vec3 seed, double t, Vec3 p) {
            const Vec3 truth =
                seed * Vec3(std::exp(0.5 * t), std::exp(-0.3 * t), std::exp(-0.2 * t));
            ASSERT_LT(glm::length(p - truth), allowed);
        });
}

TEST(ClosedForm, SphereKeepsTheStreamFunctionAndTheAzimuth) {
    const auto psi = [](const Vec3& p) {
        const double rho2 = p.y * p.y + p.z * p.z;
        const double r = glm::length(p);
        return 0.5 * rho2 * (1.0 - 0.125 / (r * r * r));
    };
    made("sphere", {-3, 0.1, 0.2}, {-3, 1.5, 0.6}, 5.0).each([&](Vec3 seed, double, Vec3 p) {
        ASSERT_NEAR(psi(p), psi(seed), allowed);
        ASSERT_NEAR(std::atan2(p.z, p.y), std::atan2(seed.z, seed.y), allowed);
    });
}

TEST(ClosedForm, CylinderKeepsTheStreamFunctionAndDriftsAlongItsAxis) {
    const auto psi = [](const Vec3& p) { return p.y * (1.0 - 0.25 / (p.x * p.x + p.y * p.y)); };
    made("cylinder", {-3, 0.1, -0.2}, {-3, 1.5, 0.6}, 5.0).each([&](Vec3 seed, double t, Vec3 p) {
        ASSERT_NEAR(psi(p), psi(seed), allowed);
        ASSERT_NEAR(p.z, seed.z + 0.2 * t, allowed);
    });
}

TEST(ClosedForm, HillsVortexKeepsItsStreamFunctionInsideAndOutside) {
    const auto psi = [](const Vec3& p) {
        const double rho2 = p.x * p.x + p.y * p.y;
        const double r2 = rho2 + p.z * p.z;
        return r2 < 1.0 ? -0.75 * rho2 * (1.0 - r2)
                        : 0.5 * rho2 * (1.0 - 1.0 / (r2 * std::sqrt(r2)));
    };
    for (const auto& [a, b] :
         {std::pair{Vec3(0.1, 0, 0.1), Vec3(0.9, 0, 0.1)}, {Vec3(0.3, 0, -2), Vec3(1, 0.5, -2)}})
        made("hill", a, b, 3.0).each([&](Vec3 seed, double, Vec3 p) {
            ASSERT_NEAR(psi(p), psi(seed), allowed);
        });
}

TEST(ClosedForm, AbcWithoutCKeepsHAndClimbsByIt) {
    made("abc?A=1,B=1,C=0", {0, 0, 0}, {2, 0.5, 1}, 4.0).each([](Vec3 seed, double t, Vec3 p) {
        const auto h = [](const Vec3& q) { return std::sin(q.x) + std::cos(q.z); };
        ASSERT_NEAR(h(p), h(seed), allowed);
        ASSERT_NEAR(p.y, seed.y + h(seed) * t, allowed);
    });
}

TEST(ClosedForm, RotatingStrainFollowsItsFlowMap) {
    const double s = 0.5, omega = 1.0, from = 0.4;
    made("rotating-strain", {0.2, -0.5, 0}, {1, 0.7, 0.5}, 4.0, SurfaceKind::Path, from)
        .each([&](Vec3 seed, double t, Vec3 p) {
            const auto turned = [](double angle, double x, double y) {
                return Vec3(std::cos(angle) * x - std::sin(angle) * y,
                            std::sin(angle) * x + std::cos(angle) * y, 0);
            };
            const Vec3 x = turned(-omega * from, seed.x, seed.y);
            const double k = std::sqrt(omega * omega - s * s);
            const double c = std::cos(k * t), n = std::sin(k * t) / k;
            Vec3 truth = turned(omega * (from + t), (c + n * s) * x.x + n * omega * x.y,
                                -n * omega * x.x + (c - n * s) * x.y);
            truth.z = seed.z;
            ASSERT_LT(glm::length(p - truth), allowed);
        });
}

} // namespace wakesurf::core::closed_form_test
