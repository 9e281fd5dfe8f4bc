#include "server/sessions/journal/crash_loop_guard.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::crash_loop_guard_test {

using tests::TemporaryFolder;

TEST(CrashLoopGuard, IsCarefulAfterThreeStartsThatDied) {
    const TemporaryFolder folder;
    for (unsigned died = 0; died < 3; ++died) {
        const CrashLoopGuard start(folder.path());
        EXPECT_EQ(start.died(), died);
        EXPECT_FALSE(start.careful());
    }
    EXPECT_TRUE(CrashLoopGuard(folder.path()).careful());
    EXPECT_TRUE(CrashLoopGuard(folder.path()).careful()) << "and stays so until one is good";
}

TEST(CrashLoopGuard, ForgetsThemOnceOneWasGood) {
    const TemporaryFolder folder;
    for (int i = 0; i < 5; ++i)
        CrashLoopGuard(folder.path()).died();
    {
        CrashLoopGuard start(folder.path());
        EXPECT_TRUE(start.careful());
        start.good();
        EXPECT_TRUE(start.careful()) << "of this one nothing changes";
    }
    EXPECT_EQ(CrashLoopGuard(folder.path()).died(), 0U);
}

TEST(CrashLoopGuard, CountsNothingThatMakesNoSense) {
    const TemporaryFolder folder;
    for (const char* text : {"", "-1", "many", "2.5e300", "99999999999999999999999"}) {
        tests::write_file(folder / "starts", text);
        const CrashLoopGuard start(folder.path());
        EXPECT_FALSE(start.careful()) << text;
    }
}

TEST(CrashLoopGuard, CountsNothingWhereItCannotWrite) {
    const TemporaryFolder folder;
    for (int i = 0; i < 5; ++i)
        EXPECT_FALSE(CrashLoopGuard(folder / "gone").careful());
}

} // namespace wakesurf::server::crash_loop_guard_test
