#include "server/base/limits.hpp"
#include "server/net/methods/import_waiters.hpp"
#include "tests/support/programs.hpp"
#include "tests/support/server/hand_loop.hpp"
#include "tests/support/slow_series.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <vector>

namespace wakesurf::server::import_waiters_test {
namespace {

using namespace std::chrono_literals;
using Status = core::Result<DatasetStatus>;

class ImportWaiting : public testing::Test {
  protected:
    ImportWaiters::Waiter keep() {
        return [this](const Status& status) { answers.push_back(status); };
    }

    tests::TemporaryFolder folder;
    std::unique_ptr<DatasetCatalogue> catalogue =
        DatasetCatalogue::open({tests::write_slow_series(folder.path()), "flow:abc"},
                               {folder / "cache", {}, tests::importer_program()},
                               [](const std::string&) {})
            .value();
    tests::HandLoop loop;
    ImportWaiters waiters{*catalogue, loop};
    std::vector<Status> answers;
};

TEST_F(ImportWaiting, OnlyThoseWhoWaitCountAgainstTheLimit) {
    std::uint64_t last = 0;
    for (std::size_t i = 0; i < limits::import_waiters; ++i)
        last = waiters.wait("u_00", 600s, keep());
    ASSERT_TRUE(answers.empty()) << "all of them wait";
    EXPECT_EQ(waiters.wait("abc", 600s, keep()), 0u);
    EXPECT_EQ(waiters.wait("u_00", 0s, keep()), 0u);
    EXPECT_EQ(waiters.wait("u_00", 600s, keep()), 0u);
    ASSERT_EQ(answers.size(), 3u);
    EXPECT_EQ(answers[0]->state, DatasetState::Ready);
    EXPECT_EQ(answers[1]->state, DatasetState::Importing);
    EXPECT_EQ(answers[2].error().code, core::Error::Code::OverLimit);
    waiters.leave(last, ImportWaiters::Leaving::Alone);
    EXPECT_NE(waiters.wait("u_00", 600s, keep()), 0u) << "a place is free";
}

TEST_F(ImportWaiting, AnImportThatWasStoppedGoesOnWhetherOrNotItIsWaitedFor) {
    const auto ticket = waiters.wait("u_00", 600s, keep());
    waiters.leave(ticket, ImportWaiters::Leaving::AndStop);
    ASSERT_EQ(waiters.status("u_00")->state, DatasetState::Stopped);
    waiters.wait("u_00", 0s, keep());
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0]->state, DatasetState::Importing);
}

TEST_F(ImportWaiting, WhoseImportIsStoppedByAnotherIsAnsweredAndWhosePatienceEndsToo) {
    waiters.wait("u_00", 100ms, keep());
    loop.pass(100ms);
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0]->state, DatasetState::Importing);
    waiters.wait("u_00", 600s, keep());
    catalogue->stop_import("u_00");
    waiters.changed("u_00");
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_EQ(answers[1]->state, DatasetState::Stopped);
}

} // namespace
} // namespace wakesurf::server::import_waiters_test
