#include "core/field/sample_scalar.hpp"
#include "server/data/dataset_argument.hpp"
#include "server/data/mean_making.hpp"
#include "store/store_generation.hpp"
#include "tests/support/brick_store.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace wakesurf::server::mean_making_test {
namespace {

using namespace tests;

using core::Error;

constexpr float none = std::numeric_limits<float>::quiet_NaN();
constexpr std::array<std::uint32_t, 3> nodes{40, 36, 34};
constexpr std::size_t steps = 9;

std::size_t count() {
    return std::size_t{nodes[0]} * nodes[1] * nodes[2];
}

// A scalar and a velocity that swing with a period of 4 round a mean of their own at each node; the scalar is
// missing at node 5, and at node 6 from time 4 on.
StoreValues swinging(core::Precision precision = core::Precision::Single) {
    StoreValues what;
    what.grid = core::UniformGrid{{0, 0, 0}, {1, 1, 1}, nodes};
    what.precision = precision;
    for (std::size_t step = 0; step < steps; ++step) {
        const auto swing = static_cast<float>(std::sin(0.5 * std::numbers::pi * double(step)));
        std::vector<float> u(3 * count()), p(count());
        for (std::size_t i = 0; i < count(); ++i) {
            const auto at = static_cast<float>(i % 97);
            u[3 * i] = 1.0f + 2.0f * swing;
            u[3 * i + 1] = at;
            u[3 * i + 2] = -swing;
            p[i] = 100.0f + at + 4.0f * swing;
        }
        p[5] = none;
        if (step >= 4)
            p[6] = none;
        what.values.push_back({std::move(u), std::move(p)});
    }
    return what;
}

LoadedDataset opened(const std::filesystem::path& path) {
    return open_store(path, {}).value();
}

std::vector<float>
kept(const LoadedDataset& dataset, const std::string& name, std::size_t step = 0) {
    const auto now = with_kept_fields(dataset, {});
    const auto slab = now.scalars->scalar_values(now.scalars->find(name).value(), step, {}).value();
    const auto* begin = reinterpret_cast<const float*>(slab->bytes().data());
    return {begin, begin + slab->bytes().size() / sizeof(float)};
}

MeanWish of(std::vector<std::string> fields) {
    return {std::move(fields)};
}

std::vector<std::uint32_t> bits(const std::vector<float>& values) {
    std::vector<std::uint32_t> out;
    for (const float value : values)
        out.push_back(std::bit_cast<std::uint32_t>(value));
    return out;
}

TEST(MeanMaking, HasTheMeanAndTheRmsOfASwingAtEachNode) {
    const TemporaryFolder folder;
    write_whole_store(folder / "store", swinging(), 0);
    const auto dataset = opened(folder / "store");
    const auto made = make_means(dataset, of({"s1", "U"}), {});
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->size(), 2u);
    EXPECT_EQ(made->front().steps, steps);
    EXPECT_EQ(made->front().to, 8.0);
    const auto mean = kept(dataset, "s1_mean"), rms = kept(dataset, "s1_rms", 3);
    EXPECT_NEAR(mean[98], 101.0, 1e-5);
    EXPECT_NEAR(rms[98], 4.0 / std::numbers::sqrt2, 1e-5);
    EXPECT_NEAR(made->front().fields[0].range[1], 196.0, 1e-4);
    EXPECT_TRUE(std::isnan(mean[5])) << "it has no value at any time";
    EXPECT_NEAR(mean[6], 106.0 + 4.0 * (1.0 - 1.0) / 3.5, 1e-5)
        << "of the times at which it has one";
    EXPECT_NEAR(kept(dataset, "U_mean_x")[7], 1.0, 1e-6);
    EXPECT_NEAR(kept(dataset, "U_mean")[7], std::hypot(1.0, 7.0), 1e-5);
    EXPECT_NEAR(kept(dataset, "U_rms_z")[7], std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(kept(dataset, "U_rms")[7], std::sqrt(2.5), 1e-6);
    EXPECT_NEAR(kept(dataset, "U_k")[7], 1.25, 1e-6);
}

TEST(MeanMaking, HasTheSameBitsInBricksAndWithLittleMemory) {
    const TemporaryFolder folder;
    write_whole_store(folder / "whole", swinging(), 0);
    write_whole_store(folder / "bricks", swinging(), 16);
    const auto whole = opened(folder / "whole"), bricks = opened(folder / "bricks");
    const core::MemoryAccount account(std::size_t{24} << 20);
    core::WorkMemory memory(account, {}, std::chrono::milliseconds(1), "this mean");
    ASSERT_TRUE(make_means(whole, of({"s1", "U"}), {}));
    const auto made = make_means(bricks, of({"s1", "U"}), {}, {nullptr, &memory});
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(memory.bytes(), 0u) << "given back";
    for (const std::string name : {"s1_mean", "s1_rms", "U_mean", "U_rms_x", "U_k"})
        EXPECT_EQ(bits(kept(bricks, name)), bits(kept(whole, name))) << name;
    // Sampled brick by brick, as where a time-step does not fit.
    StoreOptions few;
    few.cache.by_brick = true;
    const auto paged = open_store(folder / "bricks", few).value();
    const std::vector<core::Vec3> places{{3.5, 4.5, 5.5}, {31.9, 20.25, 33}, {39, 35, 0}};
    const std::vector<double> times(places.size(), 2.25);
    for (const std::string name : {"s1_mean", "U_rms_x"}) {
        const auto sampled_in = [&](const LoadedDataset& dataset) {
            const auto now = with_kept_fields(dataset, {});
            const auto field = now.scalars->find(name).value();
            return core::sample_scalar(*now.flow, *now.scalars, field, places, times, {}).value();
        };
        EXPECT_EQ(bits(sampled_in(paged)), bits(sampled_in(whole))) << name;
    }
}

TEST(MeanMaking, OfValuesInHalfPrecisionIsInSinglePrecision) {
    const TemporaryFolder folder;
    write_whole_store(folder / "whole", swinging(core::Precision::Half), 0);
    write_whole_store(folder / "bricks", swinging(core::Precision::Half), 16);
    const auto whole = opened(folder / "whole"), bricks = opened(folder / "bricks");
    ASSERT_TRUE(make_means(whole, of({"U"}), {}));
    ASSERT_TRUE(make_means(bricks, of({"U"}), {}));
    EXPECT_EQ(bits(kept(bricks, "U_rms")), bits(kept(whole, "U_rms")));
    EXPECT_NEAR(kept(whole, "U_rms")[7], std::sqrt(2.5), 1e-6) << "which halves do not have";
}

TEST(MeanMaking, ByPhaseIsTheMeanOfTheTimesOfEachPhase) {
    const TemporaryFolder folder;
    write_whole_store(folder / "store", swinging(), 16);
    const auto dataset = opened(folder / "store");
    auto wish = of({"s1"});
    wish.period = 4.0;
    const auto made = make_means(dataset, wish, {});
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->front().phases, 4u) << "as many as time-steps";
    for (std::size_t step = 0; step < steps; ++step)
        EXPECT_NEAR(kept(dataset, "s1_phase", step)[98],
                    101.0 + 4.0 * std::sin(0.5 * std::numbers::pi * double(step)), 1e-4)
            << step;
    wish.phases = 16;
    wish.label = "fine";
    const auto refused = make_means(dataset, wish, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "no time-step falls into phase 1 of 16");
}

TEST(MeanMaking, IsMadeOnceForTheSameTimesAndNeedsALabelForOthers) {
    const TemporaryFolder folder;
    write_whole_store(folder / "store", swinging(), 0);
    auto dataset = opened(folder / "store");
    ASSERT_TRUE(make_means(dataset, of({"s1"}), {}));
    const auto file = folder / "store/mean_1_0_000000.f32";
    const auto written = std::filesystem::last_write_time(file);
    ASSERT_TRUE(make_means(dataset, of({"s1"}), {})) << "as another program sees it";
    dataset = with_kept_fields(dataset, {});
    ASSERT_TRUE(make_means(dataset, of({"s1"}), {}));
    EXPECT_EQ(std::filesystem::last_write_time(file), written);
    EXPECT_FALSE(std::filesystem::exists(folder / "store/mean_2_0_000000.f32"));
    auto late = of({"s1"});
    late.from = 3.5;
    const auto refused = make_means(dataset, late, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "there is a s1_mean already, over 0 to 8");
    late.label = "late";
    const auto made = make_means(dataset, late, {});
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->front().from, 4.0);
    EXPECT_EQ(made->front().fields.front().name, "s1_mean_late");
    ASSERT_TRUE(remove_mean(dataset, "s1_rms"));
    dataset = with_kept_fields(dataset, {});
    EXPECT_FALSE(dataset.scalars->find("s1_mean"));
    EXPECT_TRUE(dataset.scalars->find("s1_mean_late"));
}

TEST(MeanMaking, IsMadeOfWhatIsDerived) {
    const TemporaryFolder folder;
    const core::UniformGrid grid{{-2, -2, -2}, {0.5, 0.5, 0.5}, {9, 9, 9}};
    ASSERT_TRUE(store::generate_store({"double-gyre", grid, {0.0, 1.0, 2.0}}, folder / "store",
                                      [](const store::ImportProgress&) {}, {}));
    const auto dataset = opened(folder / "store");
    const auto made = make_means(dataset, of({"vorticity"}), {});
    ASSERT_TRUE(made) << made.error().message;
    const auto mean = kept(dataset, "vorticity_mean");
    std::vector<float> expected;
    for (const double time : {0.0, 1.0, 2.0})
        expected.push_back(dataset.levels->values("vorticity", time, {}).value()->values[333]);
    EXPECT_NEAR(mean[333], 0.25 * expected[0] + 0.5 * expected[1] + 0.25 * expected[2], 1e-6);
}

TEST(MeanMaking, EndsWhenItIsStoppedAndKeepsNothing) {
    const TemporaryFolder folder;
    write_whole_store(folder / "store", swinging(), 0);
    const auto dataset = opened(folder / "store");
    std::stop_source stop;
    stop.request_stop();
    const auto made = make_means(dataset, of({"s1"}), stop.get_token());
    ASSERT_FALSE(made);
    EXPECT_EQ(made.error().code, Error::Code::Cancelled);
    EXPECT_FALSE(with_kept_fields(dataset, {}).scalars->find("s1_mean"));
}

TEST(MeanMaking, RefusesInWordsWhatHasNoMean) {
    const TemporaryFolder folder;
    auto values = swinging();
    write_whole_store(folder / "store", values, 0);
    values.values.resize(1);
    write_whole_store(folder / "one", values, 0);
    const auto dataset = opened(folder / "store");
    const auto refusal = [](const LoadedDataset& of, const MeanWish& wish) {
        const auto made = make_means(of, wish, {});
        return made ? std::string("made") : made.error().message;
    };
    EXPECT_EQ(refusal(opened(folder / "one"), of({"s1"})),
              "the dataset has one time-step only, so there is nothing to average");
    EXPECT_EQ(refusal(dataset, of({"T"})), "`fields` names a field the dataset does not have: T");
    auto wish = of({"s1"});
    wish.from = 7.5;
    EXPECT_EQ(refusal(dataset, wish),
              "there are fewer than two time-steps from 7.5 to 8: a mean needs two");
    wish = of({"s1"});
    wish.period = 9.0;
    EXPECT_EQ(refusal(dataset, wish), "the period 9 is longer than the time that is averaged, 8");
    wish = of({"s1"});
    wish.phases = 4;
    EXPECT_EQ(refusal(dataset, wish), "`phases` are those of a `period`");
    wish = of({"s1"});
    wish.label = "so/so";
    EXPECT_EQ(refusal(dataset, wish), "`label` must be letters, digits, or _ - .");
    const auto flow =
        resolve_dataset("flow:abc")
            .and_then([](const DatasetArgument& argument) { return open_flow(argument); })
            .value();
    EXPECT_EQ(refusal(flow, of({"velocity"})),
              "a built-in flow has no stored time-steps to average");
    ASSERT_TRUE(make_means(dataset, of({"s1"}), {}));
    EXPECT_NE(refusal(with_kept_fields(dataset, {}), of({"s1_mean"})).find("was made here"),
              std::string::npos);
}

TEST(MeanMaking, RefusesANameThatAFieldOfTheFilesHas) {
    const TemporaryFolder folder;
    write_whole_store(folder / "store", swinging(), 0);
    auto dataset = opened(folder / "store");
    core::FieldInfo theirs;
    theirs.name = "s1_rms";
    dataset.info.fields.push_back(std::move(theirs));
    const auto refused = make_means(dataset, of({"s1"}), {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the dataset has a field s1_rms already");
    auto labelled = of({"s1"});
    labelled.label = "ours";
    EXPECT_TRUE(make_means(dataset, labelled, {}));
}

} // namespace
} // namespace wakesurf::server::mean_making_test
