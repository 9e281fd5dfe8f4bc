// How much the fluid round particles and along curves expands, beside its closed form, for every way of being
// carried.
#include "core/field/flow.hpp"
#include "core/field/function_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/support/meshed_source.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <string>

namespace wakesurf::core::expansion_test {
namespace {

using namespace tests;

/// Linear in place and time, so that every interpolation has it exactly. Its divergence is 0.35 (1 + t).
Vec3 spreading(const Vec3& p, double t) {
    return (1.0 + t) * Vec3(0.3 * p.x - p.y, 0.15 * p.y + p.x, -0.1 * p.z + 0.2 * p.x);
}

constexpr double until = 1.2;
constexpr double expansion = 0.35 * (until + 0.5 * until * until);

std::unique_ptr<Flow> stored_on(const Grid& grid) {
    auto source =
        std::make_shared<SampledSource>(grid, std::vector<double>{0.0, 0.5, 1.0, 1.5}, spreading);
    return make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
}

std::map<std::string, std::unique_ptr<Flow>> every_flow() {
    const UniformGrid uniform{
        .origin = Vec3(-8), .spacing = Vec3(1.0, 0.5, 0.8), .dimensions = {17, 33, 21}};
    RectilinearGrid rectilinear;
    for (auto& along_axis : rectilinear.coordinates)
        along_axis = {-8.0, -5.0, -3.0, -2.0, -0.5, 0.7, 1.0, 2.5, 4.0, 8.0};
    std::map<std::string, std::unique_ptr<Flow>> flows;
    flows["closed form"] = make_function_flow(spreading, {Vec3(-8), Vec3(8)});
    flows["uniform"] = stored_on(uniform);
    flows["rectilinear"] = stored_on(rectilinear);
    flows["cells"] =
        meshed_flow(block({5, 4, 6}, [](const Vec3& u) { return 16.0 * u - Vec3(8.0); }),
                    {0.0, 0.5, 1.0, 1.5}, spreading);
    return flows;
}

const std::vector<Vec3> seeds{{1.0, 0.3, 0.5}, {-0.7, 1.2, -2.0}, {0.2, -0.9, 3.0}};

} // namespace

TEST(Expansion, OfParticlesIsTheDivergenceOverTimeForEveryFieldAndMethod) {
    for (const auto& [name, flow] : every_flow())
        for (const auto method : {AdvanceOptions::Method::Rk4, AdvanceOptions::Method::Dopri5})
            for (const bool smooth : {false, true}) {
                SCOPED_TRACE(name + (smooth ? ", smooth, " : ", ") +
                             (method == AdvanceOptions::Method::Rk4 ? "RK4" : "controlled"));
                std::vector<Vec3> position = seeds, s(3, {1.0, 0.0, 0.0}), t(3, {0.0, 1.0, 0.0});
                std::vector<double> time(3, 0.0);
                std::vector<CurveEnd> end(3, CurveEnd::Running);
                std::vector<float> grown(3, 0.0f);
                AdvanceOptions options;
                options.method = method;
                options.step = 0.05;
                options.longest_step = 0.2;
                options.smooth = smooth;
                ASSERT_TRUE(flow->advance({position, s, t, time, end, {}, {}, {}, grown}, until,
                                          options, {}));
                for (std::size_t i = 0; i < 3; ++i) {
                    EXPECT_EQ(end[i], CurveEnd::Running);
                    EXPECT_NEAR(double(grown[i]), expansion, 1e-5);
                }
                // Back to where they were, they are as large as they were.
                ASSERT_TRUE(flow->advance({position, s, t, time, end, {}, {}, {}, grown}, 0.0,
                                          options, {}));
                for (const float left : grown)
                    EXPECT_NEAR(double(left), 0.0, 1e-5);
            }
}

TEST(Expansion, OfCurvesIsTheDivergenceOverTheirSteps) {
    for (const auto& [name, flow] : every_flow()) {
        SCOPED_TRACE(name);
        std::vector<Curve> curves(seeds.size());
        for (std::size_t i = 0; i < seeds.size(); ++i) {
            curves[i].seed = seeds[i];
            curves[i].duration = until;
        }
        TraceOptions options;
        options.longest_step = 0.2;
        ASSERT_TRUE(flow->trace(curves, options, {}));
        for (const Curve& curve : curves) {
            EXPECT_EQ(curve.end, CurveEnd::Time);
            const double sum = std::accumulate(curve.steps.begin(), curve.steps.end(), 0.0,
                                               [](double before, const CurveStep& step) {
                                                   return before + double(step.expansion);
                                               });
            EXPECT_NEAR(sum, expansion, 1e-5);
        }
    }
}

} // namespace wakesurf::core::expansion_test
