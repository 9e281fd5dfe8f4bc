#include "server/sessions/journal/start_guard.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::start_guard_test {

using tests::TemporaryFolder;

TEST(StartGuard, IsCarefulAfterThreeStartsThatDied) {
    const TemporaryFolder folder;
    for (unsigned died = 0; died < 3; ++died) {
        const StartGuard start(folder.path());
        EXPECT_EQ(start.died(), died);
        EXPECT_FALSE(start.careful());
    }
    EXPECT_TRUE(StartGuard(folder.path()).careful());
    EXPECT_TRUE(StartGuard(folder.path()).careful()) << "and stays so until one is good";
}

TEST(StartGuard, ForgetsThemOnceOneWasGood) {
    const TemporaryFolder folder;
    for (int i = 0; i < 5; ++i)
        StartGuard(folder.path()).died();
    {
        StartGuard start(folder.path());
        EXPECT_TRUE(start.careful());
        start.good();
        EXPECT_TRUE(start.careful()) << "of this one nothing changes";
    }
    EXPECT_EQ(StartGuard(folder.path()).died(), 0U);
}

TEST(StartGuard, CountsNothingThatMakesNoSense) {
    const TemporaryFolder folder;
    for (const char* text : {"", "-1", "many", "2.5e300", "99999999999999999999999"}) {
        tests::write_file(folder / "starts", text);
        const StartGuard start(folder.path());
        EXPECT_FALSE(start.careful()) << text;
    }
}

TEST(StartGuard, CountsNothingWhereItCannotWrite) {
    const TemporaryFolder folder;
    for (int i = 0; i < 5; ++i)
        EXPECT_FALSE(StartGuard(folder / "gone").careful());
}

} // namespace wakesurf::server::start_guard_test
