#include "server/data/open_dataset.hpp"
#include "server/data/served_dataset.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace wakesurf::server::source_watch_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

store::SourceFile file_in(const TemporaryFolder& folder, const std::string& name) {
    return {name, fs::file_size(folder / name), 1}; // begin() looks at it again
}

std::string step_name(std::size_t step) {
    return "f_" + std::to_string(step) + ".vti";
}

/// f_0.vti, ... as the files of an import.
class Series {
  public:
    explicit Series(std::size_t steps) {
        for (std::size_t i = 0; i < steps; ++i)
            write_file(folder / step_name(i), "x");
        for (std::size_t i = 0; i < steps; ++i)
            source.steps.push_back({file_in(folder, step_name(i))});
        watch.begin();
        watch.made_from(source);
        watch.begin();
    }

    TemporaryFolder folder;
    store::StoreSource source;
    SourceWatch watch{folder / "f_0.vti", false};
};

TEST(SourceWatch, NoticesAStepThatIsWrittenAgainAndOneThatComes) {
    for (const std::size_t step : {0, 3, 7}) {
        Series series(8);
        EXPECT_FALSE(series.watch.changed());
        write_file(series.folder / step_name(step), "other");
        EXPECT_TRUE(series.watch.changed()) << step;
    }
    Series series(8);
    write_file(series.folder / "f_8.vti", "x");
    EXPECT_TRUE(series.watch.changed());
    series.watch.begin();
    EXPECT_FALSE(series.watch.changed());
}

// Everybody is told within 5 s: the time between two looks, and that of an import's first time-step.
TEST(SourceWatch, NoticesAnyOfHundredsOfStepsByTheNextLook) {
    constexpr std::size_t steps = 900;
    std::size_t most = 0;
    for (const std::size_t step : {0, 1, 449, 450, 898, 899}) {
        Series series(steps);
        EXPECT_FALSE(series.watch.changed());
        write_file(series.folder / step_name(step), "other");
        std::size_t looks = 1;
        while (!series.watch.changed() && looks < 100)
            ++looks;
        most = std::max(most, looks);
    }
    const auto period = OpenOptions().watch_period;
    std::printf("[ measured ] noticed by look %zu, one every %lld ms\n", most,
                static_cast<long long>(period.count()));
    EXPECT_EQ(most, 1u);
    EXPECT_LT(most * period, std::chrono::milliseconds(2500));
}

TEST(SourceWatch, NoticesAnIndexThatIsWrittenInPlace) {
    Series series(2);
    write_file(series.folder / "run.pvd", "a");
    series.watch.begin();
    series.watch.made_from(series.source);
    EXPECT_FALSE(series.watch.changed());
    std::ofstream(series.folder / "run.pvd", std::ios::app) << "b";
    EXPECT_TRUE(series.watch.changed());
}

TEST(SourceWatch, NeighboursCostNothing) {
    Series series(8);
    const auto cost = [&] {
        const auto before = series.watch.files_checked();
        EXPECT_FALSE(series.watch.changed());
        return series.watch.files_checked() - before;
    };
    const auto alone = cost();
    for (int i = 0; i < 2000; ++i)
        write_file(series.folder / ("log" + std::to_string(i)), "");
    series.watch.begin();
    EXPECT_EQ(cost(), alone);
    std::ofstream(series.folder / "log7", std::ios::app) << "a solver's log grows";
    EXPECT_FALSE(series.watch.changed());
}

TEST(SourceWatch, OfALongSeriesAPartIsLookedAtInTurns) {
    constexpr std::size_t steps = 3000;
    Series series(steps);
    const auto before = series.watch.files_checked();
    EXPECT_FALSE(series.watch.changed());
    EXPECT_LE(series.watch.files_checked() - before, SourceWatch::most_files_checked);
    write_file(series.folder / step_name(steps - 1), "the newest");
    EXPECT_TRUE(series.watch.changed());
    series.watch.begin();
    write_file(series.folder / step_name(steps / 2), "one amid them");
    std::size_t looks = 1;
    while (!series.watch.changed() && looks < 100)
        ++looks;
    EXPECT_LE(looks, steps / (SourceWatch::most_files_checked - 64) + 1);
}

TEST(SourceWatch, WithoutKnownFilesTheWholeFolderCounts) {
    const TemporaryFolder folder;
    write_file(folder / "bad.vti", "nonsense");
    SourceWatch watch(folder / "bad.vti", false);
    watch.begin();
    EXPECT_FALSE(watch.changed());
    fs::create_directory(folder / "deeper");
    watch.begin();
    write_file(folder / "deeper/file", "x");
    EXPECT_TRUE(watch.changed());
}

TEST(SourceWatch, OfAStoreItsManifestAndItsChecksumsCount) {
    const TemporaryFolder folder;
    write_file(folder / store::manifest_file_name, "{}");
    write_file(folder / "checksums.u32", "1234");
    SourceWatch watch(folder.path(), true);
    watch.begin();
    EXPECT_FALSE(watch.changed());
    write_file(folder / "checksums.u32", "12345678");
    EXPECT_TRUE(watch.changed());
}

} // namespace
} // namespace wakesurf::server::source_watch_test
