#include "store/store_reader.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace wakesurf::store::store_reader_test {
namespace {

using namespace core;

using namespace tests;

constexpr std::size_t nodes = 3 * 2 * 2;

StoreLayout small_layout(const TemporaryFolder& folder) {
    StoreLayout layout;
    layout.folder = folder.path();
    layout.grid = stored_grid(UniformGrid{{0, 0, 0}, {1, 1, 1}, {3, 2, 2}});
    layout.times = {0.5, 1.0, 4.0};
    return layout;
}

std::vector<float> rising(float first, std::size_t count = 3 * nodes) {
    std::vector<float> values(count);
    std::iota(values.begin(), values.end(), first);
    return values;
}

std::vector<float> velocity_of(const TimeStep& step) {
    return {step.velocity().begin(), step.velocity().end()};
}

std::string velocity_file(std::size_t index) {
    return step_file_name(velocity_stem, index, Precision::Single);
}

std::shared_ptr<const StoreReader> open(const StoreLayout& layout) {
    return open_layout(layout).value();
}

Error::Code open_error(const StoreLayout& layout) {
    return open_layout(layout).error().code;
}

/// Of the first load of a reader of its own, which knows nothing from before.
Error first_load_error(const StoreLayout& layout, std::size_t index = 0) {
    const auto loaded = open(layout)->load(index, {});
    return loaded ? Error{Error::Code::Cancelled, "it loaded", ""} : loaded.error();
}

TEST(StoreReader, GivesBackTheValuesOfTheFile) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    put_step(layout, 0, rising(-5.0f));
    put_step(layout, 1, rising(100.0f));
    const auto reader = open(layout);
    EXPECT_TRUE(reader->ready(0));
    EXPECT_TRUE(reader->ready(1));
    EXPECT_FALSE(reader->ready(2));
    EXPECT_FALSE(reader->ready(3));
    for (int reading = 0; reading < 2; ++reading) { // checked, then without
        const auto step = reader->load(1, {}).value();
        EXPECT_EQ(step->index, 1u);
        EXPECT_EQ(step->time, 1.0);
        EXPECT_FALSE(step->gaps);
        EXPECT_EQ(velocity_of(*step), rising(100.0f));
        EXPECT_GE(reader->bytes_per_step(), step->slab.reserved());
    }
    EXPECT_EQ(reader->load(3, {}).error().code, Error::Code::InvalidArgument);
}

TEST(StoreReader, AStepIsReadyWithItsChecksumsAndNotBefore) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    const auto reader = open(layout);
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::NotFound);
    const std::uint32_t sum = put_values(layout, velocity_stem, 0, rising(1.0f));
    EXPECT_FALSE(reader->ready(0)) << "its file is whole, but nothing vouches for it yet";
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::NotFound);
    write_file(folder / checksums_file_name, bytes_of(std::vector{sum}).substr(0, 3));
    EXPECT_FALSE(reader->ready(0)) << "a record cut off is none";
    write_file(folder / checksums_file_name, bytes_of(std::vector{sum}));
    EXPECT_TRUE(reader->ready(0));
    EXPECT_TRUE(reader->load(0, {}).has_value());
}

TEST(StoreReader, AStepWithScalarsIsReadyWithTheLastOfThem) {
    const TemporaryFolder folder;
    auto layout = small_layout(folder);
    layout.scalars = {{"p", "p"}, {"T (K)", "t-k"}};
    const auto reader = open(layout);
    const std::vector sums{put_values(layout, velocity_stem, 0, rising(1.0f)),
                           put_values(layout, "p", 0, rising(2.0f, nodes)),
                           put_values(layout, "t-k", 0, rising(3.0f, nodes))};
    append_checksums(layout, {sums[0], sums[1]});
    EXPECT_FALSE(reader->ready(0));
    append_checksums(layout, {sums[2]});
    EXPECT_TRUE(reader->ready(0));
    EXPECT_EQ(velocity_of(*reader->load(0, {}).value()), rising(1.0f));
    for (std::size_t scalar = 0; scalar < 2; ++scalar) {
        const Slab slab = reader->load_scalar(scalar, 0, {}).value();
        const auto* values = reinterpret_cast<const float*>(slab.bytes().data());
        EXPECT_EQ(std::vector<float>(values, values + nodes),
                  rising(2.0f + static_cast<float>(scalar), nodes));
    }
    flip_bit(folder / "t-k_000000.f32", 77);
    EXPECT_EQ(open(layout)->load_scalar(1, 0, {}).error().code, Error::Code::Corrupt);
    EXPECT_TRUE(open(layout)->load_scalar(0, 0, {}).has_value());
}

TEST(StoreReader, RefusesAStepCutAnywhere) {
    const TemporaryFolder folder;
    auto layout = small_layout(folder);
    layout.grid = stored_grid(UniformGrid{{0, 0, 0}, {1, 1, 1}, {20, 20, 10}});
    put_step(layout, 0, rising(1.0f, 3 * 20 * 20 * 10));
    const std::string whole = read_file(folder / velocity_file(0));
    std::vector<std::size_t> sizes{1, whole.size() / 2, whole.size() - 1};
    for (std::size_t page = 0; page < whole.size(); page += 4096)
        sizes.push_back(page);
    const auto reader = open(layout);
    for (const std::size_t size : sizes) {
        write_file(folder / velocity_file(0), whole.substr(0, size));
        for (const Error& error : {first_load_error(layout), reader->load(0, {}).error()}) {
            EXPECT_EQ(error.code, Error::Code::Corrupt) << size;
            EXPECT_NE(error.message.find("time-step 0 (velocity_000000.f32) has " +
                                         std::to_string(size) + " bytes instead of 48000"),
                      std::string::npos)
                << error.message;
        }
    }
    write_file(folder / velocity_file(0), whole + "x");
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::Corrupt);
    write_file(folder / velocity_file(0), whole);
    EXPECT_TRUE(reader->load(0, {}).has_value()) << "nothing of the failures is remembered";
}

TEST(StoreReader, RefusesEveryFlippedBit) {
    for (const Precision precision : {Precision::Single, Precision::Half}) {
        const TemporaryFolder folder;
        auto layout = small_layout(folder);
        layout.precision = precision;
        put_step(layout, 0, rising(1.0f));
        const auto file = folder / step_file_name(velocity_stem, 0, precision);
        const std::size_t bits = 8 * read_file(file).size();
        for (std::size_t bit = 0; bit < bits; ++bit) {
            flip_bit(file, bit);
            const auto error = first_load_error(layout);
            ASSERT_EQ(error.code, Error::Code::Corrupt) << bit;
            ASSERT_NE(error.message.find("checksum"), std::string::npos) << error.message;
            flip_bit(file, bit);
        }
        for (std::size_t bit = 0; bit < 32; ++bit) { // of the checksum itself
            flip_bit(folder / checksums_file_name, bit);
            ASSERT_EQ(first_load_error(layout).code, Error::Code::Corrupt) << bit;
            flip_bit(folder / checksums_file_name, bit);
        }
        EXPECT_TRUE(open(layout)->load(0, {}).has_value());
    }
}

TEST(StoreReader, AnUnreadableStepLeavesTheOthersReadable) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    for (std::size_t i = 0; i < 3; ++i)
        put_step(layout, i, rising(static_cast<float>(i)));
    flip_bit(folder / velocity_file(1), 200);
    const auto reader = open(layout);
    EXPECT_TRUE(reader->load(0, {}).has_value());
    EXPECT_EQ(reader->load(1, {}).error().code, Error::Code::Corrupt);
    EXPECT_TRUE(reader->load(2, {}).has_value());
}

TEST(StoreReader, RefusesAStepThatVanishedOrWasReplaced) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    put_step(layout, 0, rising(1.0f));
    const auto reader = open(layout);
    ASSERT_TRUE(reader->load(0, {}).has_value());
    ASSERT_TRUE(reader->load(0, {}).has_value());
    write_file(folder / "other", bytes_of(rising(2.0f)));
    std::filesystem::rename(folder / "other", folder / velocity_file(0));
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::Corrupt);
    std::filesystem::remove(folder / velocity_file(0));
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::NotFound);
}

TEST(StoreReader, KeepsVelocitiesThatAreNotFiniteAsGaps) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    const float infinite = std::numeric_limits<float>::infinity();
    std::size_t index = 0;
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinite, -infinite}) {
        auto values = rising(1.0f);
        values[17] = bad;
        put_step(layout, index++, values);
    }
    const auto reader = open(layout);
    for (std::size_t i = 0; i < 3; ++i)
        for (int reading = 0; reading < 2; ++reading) {
            const auto step = reader->load(i, {}).value();
            EXPECT_TRUE(step->gaps) << i << reading;
            EXPECT_FALSE(std::isfinite(step->velocity()[17]));
            EXPECT_EQ(step->velocity()[16], 17.0f);
        }
}

TEST(StoreReader, ReadsHalfPrecisionAsTheNearestFloats) {
    const TemporaryFolder folder;
    auto layout = small_layout(folder);
    layout.precision = Precision::Half;
    auto values = rising(1.0f / 3.0f);
    values[5] = 1e6f; // too large for a half: a gap
    put_step(layout, 0, values);
    EXPECT_EQ(read_file(folder / "velocity_000000.f16").size(), 2 * values.size());
    const auto reader = open(layout);
    const auto step = reader->load(0, {}).value();
    EXPECT_TRUE(step->gaps);
    EXPECT_EQ(step->velocity()[5], std::numeric_limits<float>::infinity());
    for (std::size_t i = 6; i < values.size(); ++i)
        EXPECT_NEAR(step->velocity()[i], values[i], values[i] / 2048.0f);
}

TEST(StoreReader, ChecksTheMask) {
    const TemporaryFolder folder;
    auto layout = small_layout(folder);
    layout.mask = true;
    EXPECT_EQ(open_error(layout), Error::Code::Corrupt) << "the layout has no checksum of it";
    layout.checksums["mask.u8"] = 0;
    EXPECT_EQ(open_error(layout), Error::Code::NotFound);
    put_fixed(layout, "mask.u8", std::string(nodes - 1, '\1'));
    EXPECT_EQ(open_error(layout), Error::Code::Corrupt);
    put_fixed(layout, "mask.u8", std::string(nodes, '\2'));
    EXPECT_EQ(open_error(layout), Error::Code::Corrupt);
    std::string mask(nodes, '\1');
    mask[5] = '\0';
    put_fixed(layout, "mask.u8", mask);
    const auto reader = open(layout);
    EXPECT_EQ(reader->mask().fluid[4], 1);
    EXPECT_EQ(reader->mask().fluid[5], 0);
    flip_bit(folder / "mask.u8", 8 * 3); // a fluid node becomes solid: still a mask
    EXPECT_EQ(open_error(layout), Error::Code::Corrupt);
}

TEST(StoreReader, ChecksTheWalls) {
    const TemporaryFolder folder;
    auto layout = small_layout(folder);
    EXPECT_TRUE(open(layout)->load_walls().value().points.empty());
    layout.walls = true;
    layout.checksums["walls.f32"] = 0;
    EXPECT_EQ(open(layout)->load_walls().error().code, Error::Code::NotFound);
    put_fixed(layout, "walls.f32", bytes_of(rising(0.0f, 9)));
    put_fixed(layout, "walls.u32", bytes_of(std::vector<std::uint32_t>{0, 1, 2}));
    const auto walls = open(layout)->load_walls().value();
    ASSERT_EQ(walls.points.size(), 3u);
    EXPECT_EQ(walls.points[1].y, 4.0f);
    EXPECT_EQ(walls.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
    const auto error = [&] { return open(layout)->load_walls().error().code; };
    flip_bit(folder / "walls.f32", 100);
    EXPECT_EQ(error(), Error::Code::Corrupt);
    put_fixed(layout, "walls.f32", bytes_of(rising(0.0f, 8))); // two points and two thirds
    EXPECT_EQ(error(), Error::Code::Corrupt);
    put_fixed(layout, "walls.f32", bytes_of(rising(0.0f, 6)));
    EXPECT_EQ(error(), Error::Code::Corrupt) << "there is no point 2";
}

TEST(StoreReader, RefusesGridsAndTimesThatMakeNoSense) {
    const TemporaryFolder folder;
    const auto bad = [&](auto change) {
        auto layout = small_layout(folder);
        change(layout);
        return open_error(layout);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto invalid = Error::Code::InvalidArgument;
    EXPECT_EQ(bad([](auto& l) { l.times = {}; }), invalid);
    EXPECT_EQ(bad([](auto& l) { l.times = {1.0, 1.0}; }), invalid);
    EXPECT_EQ(bad([&](auto& l) { l.times = {nan}; }), invalid);
    EXPECT_EQ(bad([](auto& l) { l.grid.uniform.dimensions[1] = 1; }), invalid);
    EXPECT_EQ(bad([](auto& l) { l.grid.uniform.spacing.z = 0; }), invalid);
    EXPECT_EQ(bad([](auto& l) { l.grid.uniform.spacing.z = 1e200; }), invalid);
    EXPECT_EQ(bad([&](auto& l) { l.grid.uniform.origin.x = nan; }), invalid);
    EXPECT_EQ(bad([](auto& l) {
                  l.grid.uniform.dimensions = {0xffffffffu, 0xffffffffu, 0xffffffffu};
              }),
              invalid);
    EXPECT_EQ(bad([](auto& l) {
                  l.grid.kind = GridKind::Rectilinear;
                  l.grid.dimensions = {4, 1, 4};
              }),
              invalid);
    EXPECT_EQ(bad([](auto& l) { l.grid.kind = GridKind::Unstructured; }), invalid);
    EXPECT_EQ(bad([](auto& l) {
                  l.grid.kind = GridKind::Curvilinear;
                  l.grid.points = l.grid.cells = std::uint64_t{1} << 32;
              }),
              invalid);
    EXPECT_EQ(bad([](auto& l) { l.grid.kind = GridKind::Analytic; }), invalid);
}

TEST(StoreReader, UsesTheMemoryOfAStepThatIsGivenUpAgain) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    for (std::size_t i = 0; i < 3; ++i)
        put_step(layout, i, rising(10.0f * static_cast<float>(i)));
    auto reader = open(layout);
    auto first = reader->load(0, {}).value();
    auto second = reader->load(1, {}).value();
    const float* memory = first->velocity().data();
    EXPECT_NE(second->velocity().data(), memory);
    first.reset();
    const auto third = reader->load(2, {}).value();
    EXPECT_EQ(third->velocity().data(), memory);
    EXPECT_EQ(velocity_of(*third), rising(20.0f));
    reader.reset();
    EXPECT_EQ(velocity_of(*second), rising(10.0f)) << "it outlives its reader";
}

TEST(StoreReader, StopsLoadingWhenAsked) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    put_step(layout, 0, rising(1.0f));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(open(layout)->load(0, stop.get_token()).error().code, Error::Code::Cancelled);
}

/// Writes a whole series in the place of another.
void put_series(const StoreLayout& layout, const std::vector<float>& first) {
    std::filesystem::remove(layout.folder / checksums_file_name);
    for (std::size_t i = 0; i < first.size(); ++i)
        put_step(layout, i, rising(first[i]));
}

TEST(StoreReader, NeverReadsAnotherSeriesInThePlaceOfTheOneThatIsOpen) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    put_series(layout, {0, 1, 2});
    const auto reader = open(layout);
    EXPECT_TRUE(reader->load(0, {}).has_value());
    put_series(layout, {10, 11, 12}); // also what was not read yet
    for (const std::size_t index : {0, 1, 2}) {
        const auto loaded = reader->load(index, {});
        ASSERT_FALSE(loaded.has_value()) << index;
        EXPECT_NE(loaded.error().message.find("was replaced while in use"), std::string::npos)
            << loaded.error().message;
    }
    EXPECT_FALSE(reader->refresh().value());
    EXPECT_EQ(velocity_of(**open(layout)->load(1, {}))[0], 11.0f);
}

TEST(StoreReader, OneStepThatWasReplacedEndsTheUseOfAllThatWereNotReadYet) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    put_series(layout, {0, 1, 2});
    const auto reader = open(layout);
    put_series(layout, {0, 11, 2});
    EXPECT_FALSE(reader->load(2, {}).has_value()) << "of which series it is cannot be told";
}

TEST(StoreReader, ReadsTheSameValuesWrittenAgain) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    put_series(layout, {0, 1, 2});
    const auto reader = open(layout);
    const auto before = velocity_of(**reader->load(1, {}));
    put_series(layout, {0, 1, 2});
    EXPECT_EQ(velocity_of(**reader->load(1, {})), before);
    EXPECT_TRUE(reader->refresh().value());
}

TEST(StoreReader, KnowsTheMarksOfStepsThatCome) {
    const TemporaryFolder folder;
    const auto layout = small_layout(folder);
    put_step(layout, 0, rising(0));
    const auto reader = open(layout);
    EXPECT_EQ(reader->marks().steps(), 1u);
    put_step(layout, 1, rising(1));
    EXPECT_TRUE(reader->load(1, {}).has_value());
    EXPECT_EQ(reader->marks().steps(), 2u);
}

} // namespace
} // namespace wakesurf::store::store_reader_test
