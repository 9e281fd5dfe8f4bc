#include "core/field/analytic_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace wakesurf::core::analytic_flow_test {

namespace {

Vec3 velocity_at(const Flow& flow, Vec3 p, double t = 0.0) {
    Vec3 v;
    EXPECT_TRUE(flow.sample({&p, 1}, {&t, 1}, {&v, 1}, {}));
    return v;
}

} // namespace

TEST(AnalyticFlow, EveryNameMakesAFlowWithADescription) {
    for (const std::string& name : analytic_flow_names()) {
        const auto flow = make_analytic_flow(name);
        ASSERT_TRUE(flow) << name;
        const auto info = describe_analytic_flow(name);
        ASSERT_TRUE(info) << name;
        EXPECT_EQ(info->bounds.hi, (*flow)->domain().hi) << name;
        EXPECT_FALSE(info->times.empty()) << name;
    }
}

TEST(AnalyticFlow, IncompressibleFlowsHaveNoDivergence) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.05, 0.95);
    for (const char* name :
         {"uniform", "oscillating", "rotation", "shear", "strain", "rotating-strain", "lamb-oseen",
          "sphere", "cylinder", "hill", "abc", "double-gyre", "stagnation"}) {
        const auto flow = make_analytic_flow(name);
        const Box box = (*flow)->domain();
        for (int i = 0; i < 50; ++i) {
            const Vec3 p = box.lo + box.extent() * Vec3(unit(random), unit(random), unit(random));
            if ((*flow)->status(p) != PointStatus::Inside)
                continue;
            const double h = 1e-4;
            double divergence = 0.0;
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 e(0.0);
                e[axis] = h;
                divergence += (velocity_at(**flow, p + e, 1.3)[axis] -
                               velocity_at(**flow, p - e, 1.3)[axis]) /
                              (2 * h);
            }
            EXPECT_NEAR(divergence, 0.0, 1e-5) << name << " at " << p.x << " " << p.y << " " << p.z;
        }
    }
}

TEST(AnalyticFlow, BodiesAreImpermeable) {
    const auto sphere = make_analytic_flow("sphere?a=0.7");
    for (double angle = 0.0; angle < 3.0; angle += 0.1) {
        const Vec3 n(std::cos(angle), 0.6 * std::sin(angle), 0.8 * std::sin(angle));
        EXPECT_NEAR(glm::dot(velocity_at(**sphere, 0.7 * n), n), 0.0, 1e-12);
    }
    EXPECT_NEAR(velocity_at(**sphere, {0, 0.7, 0}).x, 1.5, 1e-12); // 1.5 U at the equator
    EXPECT_EQ((*sphere)->status({0.3, 0, 0}), PointStatus::InObstacle);
    EXPECT_EQ((*sphere)->status({0.8, 0, 0}), PointStatus::Inside);
    EXPECT_EQ((*sphere)->status({11, 0, 0}), PointStatus::OutsideDomain);
}

TEST(AnalyticFlow, ParametersReplaceDefaults) {
    EXPECT_EQ(velocity_at(**make_analytic_flow("uniform?u=2,w=-3"), {0, 0, 0}), Vec3(2, 0, -3));
}

TEST(AnalyticFlow, UnknownNamesAndParametersAreRefusedWithWhatThereIs) {
    EXPECT_NE(make_analytic_flow("vortex").error().hint.find("lamb-oseen"), std::string::npos);
    for (const char* bad : {"uniform?q=1", "uniform?u", "uniform?u=", "uniform?u=1x",
                            "uniform?u=nan", "uniform?u=1e999", "tornado?u=1"}) {
        const auto flow = make_analytic_flow(bad);
        ASSERT_FALSE(flow) << bad;
        EXPECT_EQ(flow.error().code, Error::Code::InvalidArgument) << bad;
    }
}

} // namespace wakesurf::core::analytic_flow_test
