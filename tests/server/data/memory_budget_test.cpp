// How much memory a dataset may take, and what is said when that is too little.
#include "server/data/open_dataset.hpp"
#include "store/store_generation.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::memory_budget_test {
namespace {

constexpr std::size_t mebi = std::size_t{1} << 20;

core::Result<void>
generate(const std::filesystem::path& folder, const std::string& flow, std::vector<double> times) {
    // 1,000,000 nodes: 11.5 MiB a time-step.
    const core::UniformGrid grid{core::Vec3(-2.0), core::Vec3(0.04), {100, 100, 100}};
    return store::generate_store({flow, grid, std::move(times)}, folder,
                                 [](const store::ImportProgress&) {}, {});
}

TEST(MemoryBudget, OfADatasetHoldsFourTimeStepsOrItIsRefusedWithBothNumbers) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(generate(folder / "s", "abc", {0, 1, 2, 3, 4, 5}));
    const auto refused = open_store(folder / "s", {40 * mebi, 1});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, core::Error::Code::OverLimit);
    EXPECT_EQ(refused.error().message,
              "the dataset needs at least 46 MiB of memory, for 4 time-steps of 11.4 MiB and its "
              "grid, but may use only 40 MiB");
    EXPECT_NE(refused.error().hint.find("--memory 46MiB"), std::string::npos);
    const auto opened = open_store(folder / "s", {46 * mebi, 1});
    ASSERT_TRUE(opened) << opened.error().message;
    for (std::size_t i = 0; i < 6; ++i)
        ASSERT_TRUE(opened->cache->acquire(i));
    EXPECT_LE(opened->cache->status().bytes, 46 * mebi);
    EXPECT_GE(opened->cache->status().bytes, 4 * opened->store->bytes_per_step());
}

TEST(MemoryBudget, OfASteadyDatasetHoldsItsOneTimeStep) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(generate(folder / "s", "abc", {0}));
    EXPECT_TRUE(open_store(folder / "s", {12 * mebi, 1}));
    EXPECT_FALSE(open_store(folder / "s", {11 * mebi, 1}));
}

TEST(MemoryBudget, IsForTheMaskAsWell) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(generate(folder / "s", "cylinder", {0}));
    EXPECT_FALSE(open_store(folder / "s", {14 * mebi, 1})) << "three bytes a node more";
    const auto opened = open_store(folder / "s", {15 * mebi, 1});
    ASSERT_TRUE(opened);
    EXPECT_LE(opened->cache->status().budget, 15 * mebi - 3'000'000);
}

/// Claims so many nodes an axis, and has no values.
void claim(const std::filesystem::path& zarr, std::uint64_t nodes) {
    const std::string array = R"({"zarr_format": 2, "shape": [N, N, N], "chunks": [64, 64, 64],
        "dtype": "<f4", "compressor": null, "fill_value": 0, "order": "C", "filters": null})";
    for (const char* name : {"u", "v", "w"}) {
        std::string text = array;
        for (auto at = text.find('N'); at != std::string::npos; at = text.find('N'))
            text.replace(at, 1, std::to_string(nodes));
        std::filesystem::create_directories(zarr / name);
        tests::write_file(zarr / name / ".zarray", text);
    }
    tests::write_file(zarr / ".zgroup", R"({"zarr_format": 2})");
}

TEST(MemoryBudget, RefusesAZarrWhoseMetadataAloneClaimMoreBricksThanItHoldsTablesOf) {
    for (const std::uint64_t nodes : {12'000u, 16'384u, 40'000u}) {
        const tests::TemporaryFolder folder;
        claim(folder / "x.zarr", nodes);
        const core::MemoryAccount account(256 * mebi);
        StoreOptions options;
        options.cache.account = account;
        const auto refused = open_store(folder / "x.zarr", options);
        ASSERT_FALSE(refused) << nodes;
        EXPECT_EQ(refused.error().code, core::Error::Code::OverLimit);
        EXPECT_TRUE(refused.error().message.starts_with("the dataset needs at least "))
            << refused.error().message;
        EXPECT_EQ(account.used(), 0u);
    }
}

TEST(MemoryBudget, IsAskedForAMaskBeforeItsBytesAreRead) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(generate(folder / "s", "cylinder", {0}));
    std::filesystem::resize_file(folder / "s/mask.u8", 1); // would be told as damaged
    const core::MemoryAccount account(mebi);
    StoreOptions options;
    options.cache.account = account;
    const auto refused = open_store(folder / "s", options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message, "the dataset needs at least 2 MiB of memory, for its grid "
                                       "alone, but of the 1 MiB of --memory only 1 MiB are free");
    EXPECT_EQ(account.used(), 0u);
}

} // namespace
} // namespace wakesurf::server::memory_budget_test
