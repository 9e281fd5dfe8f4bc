// The time that an import may be without progress: what counts as progress begins it anew.
#include "importer/base/reading_bounds.hpp"
#include "importer/base/watched_process.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <vector>

namespace wakesurf::importer::watched_process_timing_test {
namespace {

using std::chrono::seconds;

constexpr std::size_t mebi = std::size_t{1} << 20;
/// A second for the survey: half of it passes between two signs of progress, and twice as much in all.
constexpr ImportBounds bounds{std::uint64_t{4} << 30, seconds(1), seconds(60)};
constexpr useconds_t half_of_it = 500'000;

TEST(WatchedProcessTiming, GivesEveryFileOfASurveyItsOwnTime) {
    const auto ended = run_watched("a.vti", bounds, [] {
        for (int file = 0; file < 4; ++file) {
            ::usleep(half_of_it);
            made_progress();
        }
        return 0;
    });
    EXPECT_EQ(ended.value_or(-1), 0);
}

TEST(WatchedProcessTiming, CountsReadingOfALargeFileAsProgress) {
    const auto ended = run_watched("a.vti", bounds, [] {
        std::ifstream zeros("/dev/zero", std::ios::binary);
        std::vector<char> piece(20 * mebi);
        for (int i = 0; i < 4; ++i) {
            zeros.read(piece.data(), static_cast<std::streamsize>(piece.size()));
            ::usleep(half_of_it);
        }
        return 0;
    });
    EXPECT_EQ(ended.value_or(-1), 0);
}

} // namespace
} // namespace wakesurf::importer::watched_process_timing_test
