// What is suggested where the domain is odd: full of holes, thin, or with a body that fills the inlet.
#include "core/dataset/time_step_cache.hpp"
#include "core/field/stored_flow.hpp"
#include "tests/support/sampled_source.hpp"
#include "tests/support/suggested_scene.hpp"

#include <atomic>

namespace wakesurf::core::odd_domains_test {

namespace {

using tests::suggested, tests::times;

/// Uniform flow along x through a block with a hole in each of n^3 parts, as a folded mesh has them. Counts
/// the lookups.
class HoledFlow final : public Flow {
  public:
    explicit HoledFlow(double holes) : holes_(holes) {}

    Box domain() const override { return {Vec3(-2.0), Vec3(2.0)}; }

    std::optional<std::array<double, 2>> time_range() const override { return std::nullopt; }

    double finest_spacing() const override { return 0.05; }

    PointStatus status(const Vec3& p) const override {
        ++looks;
        const Vec3 part = glm::fract(0.25 * (p + 2.0) * holes_) - 0.5;
        return std::abs(p.x) < 1.9 && glm::length(part) < 0.2 ? PointStatus::InObstacle
                                                              : PointStatus::Inside;
    }

    Result<TraceCost> trace(std::span<Curve>, const TraceOptions&, std::stop_token) const override {
        return TraceCost{};
    }

    Result<TraceCost>
    advance(const Particles&, double, const AdvanceOptions&, std::stop_token) const override {
        return TraceCost{};
    }

    bool few_data(double, double) const override { return true; }

    bool obstacle() const override { return true; }

    Result<void> sample(std::span<const Vec3>,
                        std::span<const double>,
                        std::span<Vec3> velocities,
                        std::stop_token,
                        bool) const override {
        std::ranges::fill(velocities, Vec3(1.0, 0.0, 0.0));
        return {};
    }

    mutable std::atomic<std::uint64_t> looks = 0;

  private:
    double holes_;
};

} // namespace

TEST(OddDomain, StandsInMovingFluidWhereABodyFillsTheInlet) {
    UniformGrid grid{.spacing = Vec3(0.1), .dimensions = {41, 21, 21}};
    const auto at = times(11, 0.5);
    SolidMask mask;
    for (int i = 0; i < 41 * 21 * 21; ++i)
        mask.fluid.push_back(i % 41 > 5 && i % 41 < 10 ? 0 : 1);
    auto source = std::make_shared<tests::SampledSource>(
        grid, at,
        [](const Vec3& p, double t) {
            return p.x < 1.0 ? Vec3(0.0)
                             : Vec3(1.0, 0.3 * std::sin(2.0 * p.x - t), 0.2 * std::cos(3.0 * p.y));
        },
        std::move(mask));
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    const auto scene = suggested(*flow, {at, false, 1000});
    EXPECT_EQ(scene.why.find("body"), std::string::npos) << scene.why;
    for (const Vec3& end : scene.rake.points)
        EXPECT_GT(end.x, 1.0);
}

TEST(OddDomain, LiesAlongTheWiderSideOfAThinDomain) {
    UniformGrid grid{.spacing = {0.1, 0.1, 5e-7}, .dimensions = {41, 21, 5}};
    const auto at = times(11, 0.5);
    auto source = std::make_shared<tests::SampledSource>(grid, at, [](const Vec3& p, double t) {
        return Vec3(1.0 + 0.3 * std::sin(3.0 * p.y + t), 0.4 * std::sin(2.0 * p.x - t), 0.0);
    });
    const auto flow =
        make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}));
    const auto scene = suggested(*flow, {at, false, 1000});
    EXPECT_GT(std::abs(scene.rake.points[1].y - scene.rake.points[0].y), 0.5);
    EXPECT_EQ(scene.rake.points[1].z, scene.rake.points[0].z);
}

TEST(OddDomain, LooksCloselyAtOneHoleOfMany) {
    const HoledFlow one(1.0), many(6.0);
    suggested(one, {{0.0}, true, 0});
    suggested(many, {{0.0}, true, 0});
    EXPECT_LT(static_cast<double>(many.looks), 1.2 * static_cast<double>(one.looks));
}

} // namespace wakesurf::core::odd_domains_test
