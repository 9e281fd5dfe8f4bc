#include "store/value_marks.hpp"
#include "tests/support/small_store.hpp"

#include <gtest/gtest.h>

namespace wakesurf::store::value_marks_test {
namespace {

using namespace tests;

StoreLayout layout_of(const TemporaryFolder& folder, std::vector<double> times = {0, 1, 2, 3}) {
    StoreLayout layout;
    layout.folder = folder.path();
    layout.grid = stored_grid(core::UniformGrid{{0, 0, 0}, {1, 1, 1}, {3, 2, 2}});
    layout.times = std::move(times);
    return layout;
}

/// Of time-steps with these checksums.
ValueMarks marks(const StoreLayout& layout, const std::vector<std::uint32_t>& checksums) {
    write_file(layout.folder / checksums_file_name, bytes_of(checksums));
    return ValueMarks::read(layout, core::PosixDisk()).value();
}

TEST(ValueMarks, ASeriesThatGrowsHasTheMarksOfBefore) {
    const TemporaryFolder folder;
    const auto before = marks(layout_of(folder), {7, 8});
    const auto after = marks(layout_of(folder, {0, 1, 2, 3, 4}), {7, 8, 9});
    EXPECT_EQ(after.steps(), 3u);
    EXPECT_EQ(after.checksum(2, 0), 9u);
    EXPECT_TRUE(after.continues(before));
    EXPECT_FALSE(before.continues(after));
    EXPECT_FALSE(after.contradicts(before.text()));
    EXPECT_FALSE(before.contradicts(after.text())) << "what is not known is not contradicted";
}

TEST(ValueMarks, AnyOtherValueTimeFieldOrGridIsNoticed) {
    const TemporaryFolder folder;
    const auto before = marks(layout_of(folder), {7, 8, 9});
    auto scalars = layout_of(folder);
    scalars.scalars = {{"p", "p"}};
    auto grid = layout_of(folder);
    grid.grid = stored_grid(core::UniformGrid{{0, 0, 0}, {1, 1, 1}, {3, 2, 3}});
    auto mask = layout_of(folder);
    mask.checksums["mask.u8"] = 5;
    for (const auto& other :
         {marks(layout_of(folder), {7, 8, 10}), marks(layout_of(folder), {6, 8, 9, 9}),
          marks(layout_of(folder, {0, 1, 2.5, 3}), {7, 8, 9}), marks(scalars, {7, 0, 8, 0, 9, 0}),
          marks(grid, {7, 8, 9}), marks(mask, {7, 8, 9})}) {
        EXPECT_FALSE(other.continues(before)) << other.text();
        EXPECT_TRUE(other.contradicts(before.text())) << other.text();
    }
}

TEST(ValueMarks, FewerStepsContradictOnlyByTheFirst) {
    const TemporaryFolder folder;
    const auto whole = marks(layout_of(folder), {7, 8, 9});
    EXPECT_FALSE(marks(layout_of(folder), {7}).contradicts(whole.text()));
    EXPECT_TRUE(marks(layout_of(folder), {6}).contradicts(whole.text()));
    EXPECT_FALSE(marks(layout_of(folder), {}).contradicts("nonsense 12 -1 99999999999999999999-0"));
}

} // namespace
} // namespace wakesurf::store::value_marks_test
