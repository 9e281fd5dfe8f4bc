#include "core/dataset/store_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace wakesurf::core {
namespace {

using tests::TemporaryFolder;
using tests::write_file;

constexpr std::size_t nodes = 3 * 2 * 2;

StoreLayout small_layout(const TemporaryFolder& folder) {
    return {folder.path(), {{0, 0, 0}, {1, 1, 1}, {3, 2, 2}}, {0.5, 1.0, 4.0}, ""};
}

std::string step_bytes(float first) {
    std::vector<float> values(3 * nodes);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = first + static_cast<float>(i);
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

std::shared_ptr<const StoreReader> open(const StoreLayout& layout) {
    return StoreReader::open(layout, std::make_shared<PosixDisk>()).value();
}

Error::Code open_error(const StoreLayout& layout) {
    return StoreReader::open(layout, std::make_shared<PosixDisk>()).error().code;
}

TEST(StoreReader, GivesBackTheValuesOfTheFile) {
    const TemporaryFolder folder;
    write_file(folder / velocity_file_name(1), step_bytes(100.0f));
    const auto reader = open(small_layout(folder));
    EXPECT_FALSE(reader->ready(0));
    EXPECT_TRUE(reader->ready(1));
    EXPECT_FALSE(reader->ready(3));
    const auto step = reader->load(1, {}).value();
    EXPECT_EQ(step->index, 1u);
    EXPECT_EQ(step->time, 1.0);
    ASSERT_EQ(step->velocity().size(), 3 * nodes);
    for (std::size_t i = 0; i < 3 * nodes; ++i)
        EXPECT_EQ(step->velocity()[i], 100.0f + static_cast<float>(i));
    EXPECT_GE(reader->bytes_per_step(), step->slab.reserved());
}

TEST(StoreReader, AStepIsReadyAsSoonAsItsFileAppears) {
    const TemporaryFolder folder;
    const auto reader = open(small_layout(folder));
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::NotFound);
    write_file(folder / velocity_file_name(0), step_bytes(1.0f));
    EXPECT_TRUE(reader->ready(0));
    EXPECT_TRUE(reader->load(0, {}).has_value());
}

TEST(StoreReader, RefusesAStepCutAnywhere) {
    const TemporaryFolder folder;
    const auto reader = open(small_layout(folder));
    const std::string whole = step_bytes(1.0f);
    for (const std::size_t size :
         {std::size_t{0}, std::size_t{1}, whole.size() / 2, whole.size() - 1}) {
        write_file(folder / velocity_file_name(0), whole.substr(0, size));
        EXPECT_FALSE(reader->ready(0)) << size;
        EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::Corrupt) << size;
    }
    write_file(folder / velocity_file_name(0), whole + "x");
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::Corrupt);
}

TEST(StoreReader, RefusesAStepThatVanishedOrWasReplaced) {
    const TemporaryFolder folder;
    write_file(folder / velocity_file_name(0), step_bytes(1.0f));
    const auto reader = open(small_layout(folder));
    ASSERT_TRUE(reader->load(0, {}).has_value());
    ASSERT_TRUE(reader->load(0, {}).has_value());
    write_file(folder / "other", step_bytes(2.0f));
    std::filesystem::rename(folder / "other", folder / velocity_file_name(0));
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::Corrupt);
    std::filesystem::remove(folder / velocity_file_name(0));
    EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::NotFound);
}

TEST(StoreReader, RefusesVelocitiesThatAreNotFinite) {
    const TemporaryFolder folder;
    const auto reader = open(small_layout(folder));
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
        std::string bytes = step_bytes(1.0f);
        bytes.replace(4 * 17, 4, reinterpret_cast<const char*>(&bad), 4);
        write_file(folder / velocity_file_name(0), bytes);
        EXPECT_EQ(reader->load(0, {}).error().code, Error::Code::Corrupt) << bad;
    }
}

TEST(StoreReader, ChecksTheMask) {
    const TemporaryFolder folder;
    auto layout = small_layout(folder);
    layout.mask = "mask.u8";
    EXPECT_EQ(open_error(layout), Error::Code::NotFound);
    write_file(folder / "mask.u8", std::string(nodes - 1, '\1'));
    EXPECT_EQ(open_error(layout), Error::Code::Corrupt);
    write_file(folder / "mask.u8", std::string(nodes, '\2'));
    EXPECT_EQ(open_error(layout), Error::Code::Corrupt);
    std::string mask(nodes, '\1');
    mask[5] = '\0';
    write_file(folder / "mask.u8", mask);
    const auto reader = open(layout);
    EXPECT_EQ(reader->mask().fluid[4], 1);
    EXPECT_EQ(reader->mask().fluid[5], 0);
}

TEST(StoreReader, RefusesGridsAndTimesThatMakeNoSense) {
    const TemporaryFolder folder;
    const auto bad = [&](auto change) {
        auto layout = small_layout(folder);
        change(layout);
        return open_error(layout);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(bad([](auto& l) { l.times = {}; }), Error::Code::InvalidArgument);
    EXPECT_EQ(bad([](auto& l) { l.times = {1.0, 1.0}; }), Error::Code::InvalidArgument);
    EXPECT_EQ(bad([&](auto& l) { l.times = {nan}; }), Error::Code::InvalidArgument);
    EXPECT_EQ(bad([](auto& l) { l.grid.dimensions[1] = 1; }), Error::Code::InvalidArgument);
    EXPECT_EQ(bad([](auto& l) { l.grid.spacing.z = 0; }), Error::Code::InvalidArgument);
    EXPECT_EQ(bad([](auto& l) { l.grid.spacing.z = 1e200; }), Error::Code::InvalidArgument);
    EXPECT_EQ(bad([&](auto& l) { l.grid.origin.x = nan; }), Error::Code::InvalidArgument);
    EXPECT_EQ(bad([](auto& l) {
                  l.grid.dimensions = {0xffffffffu, 0xffffffffu, 0xffffffffu};
              }),
              Error::Code::InvalidArgument);
}

TEST(StoreReader, StopsLoadingWhenAsked) {
    const TemporaryFolder folder;
    write_file(folder / velocity_file_name(0), step_bytes(1.0f));
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(open(small_layout(folder))->load(0, stop.get_token()).error().code,
              Error::Code::Cancelled);
}

} // namespace
} // namespace wakesurf::core
