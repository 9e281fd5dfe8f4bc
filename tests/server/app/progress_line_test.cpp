#include "server/app/progress_line.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wakesurf::server::progress_line_test {

namespace {

/// Goes evenly for 40 s, to time 20, with 100 quads a second.
std::string at(ProgressText& text, core::WorkDone& work, double seconds) {
    work.reached(seconds / 40.0);
    work.came_to(seconds / 2.0, 0.0);
    work.has(static_cast<std::uint64_t>(100.0 * seconds));
    return text.at(seconds);
}

} // namespace

TEST(ProgressText, IsOneLineOnATerminalThatTellsTimeQuadsAndSecondsLeftFromThreeSecondsOn) {
    core::WorkDone work;
    ProgressText text("building", &work, 20.0, {.terminal = true});
    EXPECT_EQ(text.at(0.0), "\rbuilding ... 0 %, 0.0 s\033[K");
    EXPECT_EQ(at(text, work, 2.0), "\rbuilding ... 5 %, 2.0 s, about 38 s left\033[K");
    EXPECT_EQ(at(text, work, 4.0),
              "\rbuilding ... 10 %, t = 2 of 20, 400 quads, 4.0 s, about 36 s left\033[K");
    EXPECT_EQ(text.last(), "\r\033[K");
}

TEST(ProgressText, NeverIsLongerThanTheTerminalIsWide) {
    core::WorkDone work;
    ProgressText text("building a streak surface of a case", &work, 20.0,
                      {.terminal = true, .columns = 70});
    EXPECT_EQ(at(text, work, 4.0), "\r10 %, t = 2 of 20, 400 quads, 4.0 s, about 36 s left\033[K");
}

TEST(ProgressText, IsPlainLinesIntoAFileEachAfterTwiceAsLongAndEveryMinuteAtLeast) {
    core::WorkDone work;
    ProgressText text("building", &work, 20.0, {});
    std::vector<double> written;
    for (int tenths = 0; tenths <= 2000; ++tenths) {
        const std::string line = at(text, work, tenths / 10.0);
        if (line.empty())
            continue;
        written.push_back(tenths / 10.0);
        EXPECT_EQ(line.find('\r'), std::string::npos);
        EXPECT_EQ(line.find('\n'), line.size() - 1);
        if (tenths == 60) {
            EXPECT_EQ(line, "building: 15 %, t = 3 of 20, 600 quads, 6.0 s, about 34 s left\n");
        }
    }
    EXPECT_EQ(written, (std::vector<double>{0, 3, 6, 12, 24, 48, 96, 156}));
}

TEST(ProgressText, TellsTheSecondsAloneWhereNothingElseIsKnown) {
    ProgressText text("reading", nullptr, std::nullopt, {.terminal = true});
    EXPECT_EQ(text.at(7.25), "\rreading ... 7.2 s\033[K");
}

} // namespace wakesurf::server::progress_line_test
