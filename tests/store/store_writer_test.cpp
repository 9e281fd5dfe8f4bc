#include "store/store_writer.hpp"
#include "store/stored_families.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <stdexcept>

namespace wakesurf::store::store_writer_test {
namespace {

using Record = std::array<std::uint32_t, 2>;

StoreWriter writer_in(const tests::TemporaryFolder& folder) {
    return StoreWriter::open(folder / "store", [] { return core::Result<void>(); }).value();
}

TEST(StoreWriter, FinishesTimeStepsOneAfterTheOther) {
    const tests::TemporaryFolder folder;
    auto writer = writer_in(folder);
    EXPECT_FALSE(writer.finished_step(0, 2));
    ASSERT_TRUE(writer.finish_step(0, Record{1, 2}));
    ASSERT_TRUE(writer.finish_step(1, Record{3, 4}));
    ASSERT_TRUE(writer.finish_step(0, Record{5, 6})) << "written again";
    EXPECT_EQ(writer.finished_step(0, 2), (std::vector<std::uint32_t>{5, 6}));
    EXPECT_EQ(writer.finished_step(1, 2), (std::vector<std::uint32_t>{3, 4}));
    EXPECT_FALSE(writer.finished_step(2, 2));
}

TEST(StoreWriter, NeverMakesTimeStepsReadyThatWereSkipped) {
    const tests::TemporaryFolder folder;
    auto writer = writer_in(folder);
    ASSERT_TRUE(writer.finish_step(0, Record{1, 2}));
    EXPECT_THROW((void)writer.finish_step(2, Record{3, 4}), std::logic_error);
    EXPECT_FALSE(writer.finished_step(1, 2));
    EXPECT_FALSE(writer.finished_step(2, 2));
}

TEST(StoreWriter, LeavesSomeOfTheDiskFree) {
    const tests::TemporaryFolder folder;
    auto writer = writer_in(folder);
    const auto fill = [](const PutBytes&) -> core::Result<void> { return {}; };
    const auto free = std::filesystem::space(folder.path()).available;
    ASSERT_GT(free, disk_reserve);
    const auto refused = writer.write_in_place("x.f64", free - disk_reserve / 2, fill);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().hint.find("free some disk space"), std::string::npos);
    EXPECT_TRUE(writer.write_in_place("x.f64", 8, fill));
}

TEST(StoreWriter, GoesOnAfterARecordThatWasCutOff) {
    const tests::TemporaryFolder folder;
    auto writer = writer_in(folder);
    tests::write_file(folder / "store/checksums.u32", std::string(11, 'x')); // a record and a bit
    EXPECT_TRUE(writer.finished_step(0, 2));
    EXPECT_FALSE(writer.finished_step(1, 2));
    ASSERT_TRUE(writer.finish_step(1, Record{3, 4}));
    EXPECT_EQ(writer.finished_step(1, 2), (std::vector<std::uint32_t>{3, 4}));
}

} // namespace
} // namespace wakesurf::store::store_writer_test
