// Slices against closed forms, with convergence; beside bodies; by any number of threads, from whole time-steps, bricks and cells.
#include "core/field/analytic_flow.hpp"
#include "core/field/stored_flow.hpp"
#include "core/surface/slice/slice_raster.hpp"
#include "tests/support/bricked_source.hpp"
#include "tests/support/cell_meshes.hpp"
#include "tests/support/sampled_source.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

namespace wakesurf::core::slice_raster_test {

namespace {

const Plane oblique{{0.1, 0.0, -0.1}, {1, -2, 3}};

UniformGrid cube(std::uint32_t nodes) {
    return {Vec3(-1.0), Vec3(2.0 / (nodes - 1)), {nodes, nodes, nodes}};
}

using Formula = std::function<double(const Vec3& place, double time)>;

/// A scalar that is a formula at the nodes of a source.
class FormulaScalar final : public ScalarSource {
  public:
    FormulaScalar(std::shared_ptr<const tests::SampledSource> source, Formula formula)
        : source_(std::move(source)), formula_(std::move(formula)) {}

    const std::vector<double>& times() const override { return source_->times(); }

    Result<std::shared_ptr<const Slab>>
    scalar_values(std::size_t, std::size_t step, const std::stop_token&) const override {
        const std::size_t nodes = node_count(source_->grid());
        auto slab = std::make_shared<Slab>(nodes * sizeof(float));
        auto* out = reinterpret_cast<float*>(slab->bytes().data());
        for (std::size_t node = 0; node < nodes; ++node)
            out[node] = static_cast<float>(formula_(source_->position(node), times()[step]));
        return slab;
    }

  private:
    std::shared_ptr<const tests::SampledSource> source_;
    Formula formula_;
};

/// Stored data with the times 0 and 1: a scalar, and a velocity of which it is the x component.
struct Data {
    Data(const Grid& grid,
         const Formula& formula,
         const std::function<bool(const Vec3&)>& solid = {})
        : source(source_of(grid, formula, solid)),
          scalar(std::make_shared<FormulaScalar>(source, formula)),
          flow(
              make_stored_flow(std::make_shared<TimeStepCache>(source, TimeStepCache::Options{}))) {
    }

    static std::shared_ptr<const tests::SampledSource> source_of(
        const Grid& grid, const Formula& formula, const std::function<bool(const Vec3&)>& solid) {
        const auto velocity = [formula](const Vec3& x, double time) {
            return Vec3(formula(x, time), std::sin(x.x), 1.0);
        };
        const tests::SampledSource places(grid, {0.0}, velocity);
        SolidMask mask;
        for (std::size_t node = 0; solid && node < node_count(grid); ++node)
            mask.fluid.push_back(solid(places.position(node)) ? 0 : 1);
        return std::make_shared<tests::SampledSource>(grid, std::vector{0.0, 1.0}, velocity, mask);
    }

    Result<SliceRaster>
    slice(const Plane& plane, double time = 0.0, std::size_t samples = 90) const {
        return sample_slice({plane, StoredScalar{scalar.get(), 0}, time, samples}, *flow, {});
    }

    std::shared_ptr<const tests::SampledSource> source;
    std::shared_ptr<const ScalarSource> scalar;
    std::shared_ptr<const Flow> flow;
};

/// The largest difference from a formula; infinite where one of them has no value and the other should.
double largest_error(const SliceRaster& raster, const std::function<double(const Vec3&)>& exact) {
    double most = 0.0;
    for (std::size_t row = 0; row < raster.rows; ++row)
        for (std::size_t column = 0; column < raster.columns; ++column) {
            const double value = raster.values[row * raster.columns + column];
            const double should = exact(raster.place(column, row));
            if (std::isnan(value) != std::isnan(should))
                return std::numeric_limits<double>::infinity();
            if (!std::isnan(value))
                most = std::max(most, std::abs(value - should));
        }
    return most;
}

/// Has no value outside of the cube from -1 to 1.
std::function<double(const Vec3&)> in_cube(std::function<double(const Vec3&)> formula) {
    return [formula = std::move(formula)](const Vec3& x) {
        const double farthest = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
        return farthest <= 1.0 ? formula(x) : std::numeric_limits<double>::quiet_NaN();
    };
}

double wave(const Vec3& x) {
    return std::sin(3.0 * x.x) * std::cos(2.0 * x.y) + x.z * x.z;
}

bool same_bytes(const SliceRaster& a, const SliceRaster& b) {
    return a.values.size() == b.values.size() &&
           std::memcmp(a.values.data(), b.values.data(), a.values.size() * sizeof(float)) == 0;
}

} // namespace

TEST(SliceRaster, OfAClosedFormHasItsSpeedComponentsAndVorticity) {
    const auto flow = make_analytic_flow("rotation?omega=2,w=0.5").value();
    const auto error_of = [&](const SampledField& field,
                              const std::function<double(const Vec3&)>& exact) {
        const auto raster = sample_slice({{{0.2, 0, 0.1}, {0, 0, 1}}, field, 0.0, 40}, *flow, {});
        EXPECT_TRUE(raster);
        EXPECT_EQ(raster->in_flow, raster->values.size());
        return largest_error(*raster, exact);
    };
    EXPECT_LT(
        error_of(SpeedField{},
                 [](const Vec3& x) { return std::sqrt(4.0 * (x.x * x.x + x.y * x.y) + 0.25); }),
        1e-5);
    EXPECT_LT(error_of(VelocityAlong{{0, 1, 0}}, [](const Vec3& x) { return 2.0 * x.x; }), 1e-5);
    EXPECT_LT(error_of(VelocityAlong{{0, 0, 1}}, [](const Vec3&) { return 0.5; }), 1e-6);
    EXPECT_LT(error_of(GradientField::VorticityZ, [](const Vec3&) { return 4.0; }), 1e-5);
}

TEST(SliceRaster, OfAStoredScalarConvergesToSecondOrderOnAnyPlane) {
    double before = 0.0;
    for (const std::uint32_t nodes : {17u, 33u, 65u}) {
        const Data data(cube(nodes), [](const Vec3& x, double) { return wave(x); });
        const double error = largest_error(data.slice(oblique).value(), in_cube(wave));
        if (before > 0.0) {
            EXPECT_NEAR(before / error, 4.0, 0.5);
        }
        before = error;
    }
    EXPECT_LT(before, 2e-3);
}

TEST(SliceRaster, BetweenStoredTimesIsLinearInTime) {
    const auto moving = [](const Vec3& x, double time) {
        return x.x + 2.0 * x.y - x.z + 3.0 * time;
    };
    const Data data(cube(5), moving);
    const auto raster = data.slice(oblique, 0.25);
    EXPECT_LT(largest_error(*raster, in_cube([&](const Vec3& x) { return moving(x, 0.25); })),
              1e-5);
    const auto late = data.slice(oblique, 1.5);
    ASSERT_FALSE(late);
    EXPECT_EQ(late.error().code, Error::Code::OutOfTime);
}

TEST(SliceRaster, InAMeshOfCellsHasTheValuesOfItsCells) {
    const auto linear = [](const Vec3& x, double) { return x.x - 2.0 * x.y + 0.5 * x.z; };
    const auto mesh =
        tests::block({6, 6, 6}, [](const Vec3& u) { return 2.0 * tests::wavy(u) - 1.0; });
    const Data data(mesh, linear);
    const auto raster = data.slice(oblique);
    ASSERT_TRUE(raster);
    EXPECT_LT(largest_error(*raster, in_cube([&](const Vec3& x) { return linear(x, 0.0); })), 1e-5);
}

TEST(SliceRaster, HasNoValueInABodyAndOutsideTheDomain) {
    const auto ball = [](const Vec3& x) { return glm::length(x) < 0.4; };
    const Data data(
        cube(41), [](const Vec3& x, double) { return x.x; }, ball);
    const auto raster = data.slice({{0, 0, 0}, {0, 0, 1}}, 0.0, 100);
    ASSERT_TRUE(raster);
    std::size_t empty = 0;
    for (std::size_t i = 0; i < raster->values.size(); ++i) {
        const double away = glm::length(raster->place(i % raster->columns, i / raster->columns));
        if (away < 0.3 || away > 0.5) {
            EXPECT_EQ(std::isnan(raster->values[i]), away < 0.3) << away;
        }
        empty += std::isnan(raster->values[i]) ? 1 : 0;
    }
    EXPECT_EQ(raster->in_flow, raster->values.size() - empty);
    EXPECT_NEAR(static_cast<double>(empty), 3.1416 * 0.4 * 0.4 * 2500.0, 250.0);
}

TEST(SliceRaster, OfAFieldWithoutValuesIsEmptyButKnowsThatItIsInTheFlow) {
    const Data data(cube(5),
                    [](const Vec3&, double) { return std::numeric_limits<double>::quiet_NaN(); });
    const auto raster = data.slice({{0, 0, 0}, {0, 0, 1}});
    ASSERT_TRUE(raster);
    EXPECT_FALSE(raster->range);
    EXPECT_EQ(raster->in_flow, raster->values.size());
}

TEST(SliceRaster, IsTheSameBytesOnAnyNumberOfThreads) {
    const Data data(cube(33), [](const Vec3& x, double time) { return wave(x) + time; });
    const std::array<SampledField, 4> fields{StoredScalar{data.scalar.get(), 0}, SpeedField{},
                                             VelocityAlong{{0.6, 0, 0.8}},
                                             GradientField::QCriterion};
    for (const SampledField& field : fields) {
        const SliceRequest request{oblique, field, 0.3, 300};
        const auto many = sample_slice(request, *data.flow, {});
        const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
        const auto one = sample_slice(request, *data.flow, {});
        ASSERT_TRUE(many && one);
        EXPECT_TRUE(same_bytes(*many, *one));
    }
}

TEST(SliceRaster, InBricksIsTheSameBytesWithinTheSmallestBudget) {
    const Data data(cube(65), [](const Vec3& x, double time) { return wave(x) + time; });
    TimeStepCache::Options options;
    options.budget_bytes = 0;
    options.by_brick = true;
    const auto cache = std::make_shared<TimeStepCache>(
        std::make_shared<tests::BrickedSource>(data.source, 8), options);
    const auto flow = make_stored_flow(cache);
    for (const SampledField& field :
         {SampledField(SpeedField{}), SampledField(GradientField::QCriterion)}) {
        const SliceRequest request{oblique, field, 0.3, 300};
        const auto whole = sample_slice(request, *data.flow, {});
        const auto bricks = sample_slice(request, *flow, {});
        ASSERT_TRUE(whole && bricks);
        EXPECT_TRUE(same_bytes(*whole, *bricks));
        EXPECT_LE(cache->status().bytes, cache->status().budget);
    }
    EXPECT_LT(cache->status().budget, data.source->bytes_per_step());
}

TEST(SliceRaster, WithFewerSamplesHasTheSameWindowAndSquaresAsFar) {
    const auto flow = make_analytic_flow("sphere").value();
    const Plane plane{{0, 0.1, 0}, {0, 1, 0}};
    const auto fine = sample_slice({plane, SpeedField{}, 0.0, 200}, *flow, {}).value();
    const auto coarse = sample_slice({plane, SpeedField{}, 0.0, 20}, *flow, {}).value();
    EXPECT_EQ(fine.window.across, coarse.window.across);
    EXPECT_EQ(fine.columns, 10 * coarse.columns);
    EXPECT_EQ(std::max(coarse.columns, coarse.rows), 20u);
    const double width = glm::length(fine.window.across) / static_cast<double>(fine.columns);
    const double height = glm::length(fine.window.up) / static_cast<double>(fine.rows);
    EXPECT_NEAR(width / height, 1.0, 0.01);
}

TEST(SliceRaster, MinusItselfIsZeroEverywhere) {
    const auto ball = [](const Vec3& x) { return glm::length(x) < 0.4; };
    const Data data(
        cube(17), [](const Vec3& x, double time) { return wave(x) + time; }, ball);
    const auto raster = data.slice(oblique, 0.5);
    const SliceRequest same{oblique, StoredScalar{data.scalar.get(), 0}, 0.5, 90};
    const auto difference = slice_minus(*raster, same, *data.flow, {});
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->in_flow, raster->in_flow);
    EXPECT_EQ(difference->range, (std::array<float, 2>{0.0F, 0.0F}));
    for (std::size_t i = 0; i < raster->values.size(); ++i)
        EXPECT_EQ(std::isnan(difference->values[i]), std::isnan(raster->values[i]));
}

TEST(SliceRaster, MinusAnotherTimeIsTheDifferenceOfTheClosedForms) {
    const auto flow = make_analytic_flow("double-gyre").value();
    const Plane plane{{1, 0.5, 0.05}, {0, 0, 1}};
    const auto exact = [](const Vec3& x, double time) {
        const double pi = std::numbers::pi;
        const double sway = 0.25 * std::sin(0.2 * pi * time);
        const double f = sway * x.x * x.x + (1.0 - 2.0 * sway) * x.x;
        return -0.1 * pi * std::sin(pi * f) * std::cos(pi * x.y);
    };
    const VelocityAlong along_x{{1, 0, 0}};
    const auto late = sample_slice({plane, along_x, 3.0, 60}, *flow, {});
    const auto difference = slice_minus(*late, {plane, along_x, 1.0, 60}, *flow, {});
    ASSERT_TRUE(difference);
    EXPECT_LT(
        largest_error(*difference, [&](const Vec3& x) { return exact(x, 3.0) - exact(x, 1.0); }),
        1e-6);
    EXPECT_LT((*difference->range)[0], 0.0F);
    EXPECT_GT((*difference->range)[1], 0.0F);
}

TEST(SliceRaster, MinusSmallerDataHasNoValueOutsideOfThem) {
    const auto linear = [](const Vec3& x, double) { return x.x + 2.0 * x.y; };
    const Data large(cube(9), linear);
    const Data small(UniformGrid{Vec3(-0.5), Vec3(0.125), {9, 9, 9}}, linear);
    const Plane plane{{0, 0, 0}, {0, 0, 1}};
    const auto difference =
        slice_minus(*large.slice(plane), {plane, StoredScalar{small.scalar.get(), 0}, 0.0, 90},
                    *small.flow, {});
    ASSERT_TRUE(difference);
    EXPECT_EQ(difference->columns, 90u) << "the window is that of what is subtracted from";
    EXPECT_LT(largest_error(*difference,
                            [](const Vec3& x) {
                                const double away = std::max(std::abs(x.x), std::abs(x.y));
                                return away <= 0.5 ? 0.0 : std::numeric_limits<double>::quiet_NaN();
                            }),
              1e-6);
    const auto never =
        slice_minus(*large.slice(plane), {plane, StoredScalar{small.scalar.get(), 0}, 5.0, 90},
                    *small.flow, {});
    ASSERT_FALSE(never);
    EXPECT_EQ(never.error().code, Error::Code::OutOfTime);
}

TEST(SliceRaster, StopsWhenItIsNotWantedAnyMore) {
    const auto flow = make_analytic_flow("abc").value();
    std::stop_source stop;
    stop.request_stop();
    const auto raster = sample_slice({oblique, SpeedField{}, 0.0, 100}, *flow, stop.get_token());
    ASSERT_FALSE(raster);
    EXPECT_EQ(raster.error().code, Error::Code::Cancelled);
}

} // namespace wakesurf::core::slice_raster_test
