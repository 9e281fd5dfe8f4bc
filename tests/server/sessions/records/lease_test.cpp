// Who may drag a rake: leases taken, renewed, let go, run out, taken over.
#include "server/base/limits.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>

namespace wakesurf::tests::lease_test {

using std::chrono::milliseconds;

class LeaseTest : public testing::Test {
  protected:
    SessionBench bench;
    server::Session& session = *bench.session;
    const std::string rake = session.set_rake(rake_at(0), bench.ada)->record.rake;

    protocol::RakeRecord drag(const server::Author& author, std::optional<bool> flag = true) {
        return session.set_rake(dragged(1, rake, flag), author)->record;
    }

    std::string holder() const {
        const auto lease = session.lease(rake);
        const auto record = session.records().get<protocol::RakeRecord>(rake);
        EXPECT_EQ(record->dragging, lease.has_value()) << "the record shows the lease";
        EXPECT_EQ(record->leased_by, lease ? lease->by.participant : "");
        return lease ? lease->by.participant : "";
    }
};

TEST_F(LeaseTest, IsTakenRenewedAndEndedByItsHoldersEdits) {
    EXPECT_EQ(holder(), "");
    const auto record = drag(bench.ada);
    EXPECT_TRUE(record.dragging);
    EXPECT_EQ(record.leased_by, "p1");
    EXPECT_EQ(holder(), "p1");
    EXPECT_EQ(session.lease(rake)->left, server::limits::lease);
    bench.loop.pass(milliseconds(3000));
    EXPECT_EQ(session.lease(rake)->left, milliseconds(2000));
    drag(bench.ada);
    bench.loop.pass(milliseconds(4999));
    EXPECT_EQ(holder(), "p1") << "renewed";
    drag(bench.ada, std::nullopt);
    EXPECT_EQ(session.lease(rake)->left, milliseconds(1)) << "left out: as it was";
    EXPECT_FALSE(drag(bench.ada, false).dragging);
    EXPECT_EQ(holder(), "");
}

TEST_F(LeaseTest, RunsOutAndEverybodyIsTold) {
    Onlooker onlooker;
    ASSERT_TRUE(session.participants().join({"onlooker", "", "", {}}, onlooker));
    const auto rev = drag(bench.ada).rev;
    const auto seq = session.seq();
    bench.loop.pass(server::limits::lease - milliseconds(1));
    EXPECT_EQ(holder(), "p1");
    EXPECT_EQ(session.seq(), seq);
    bench.loop.pass(milliseconds(1));
    EXPECT_EQ(holder(), "");
    EXPECT_EQ(session.seq(), seq + 1);
    EXPECT_EQ(session.records().get<protocol::RakeRecord>(rake)->rev, rev) << "no one edited it";
    EXPECT_EQ(onlooker.records.list(), session.records().list());
    session.participants().leave(onlooker);
}

TEST_F(LeaseTest, EndsWhenItsHolderLeavesAndNobodyElsesDoes) {
    const auto other = session.set_rake(rake_at(2), bench.bob)->record.rake;
    drag(bench.ada);
    ASSERT_TRUE(session.set_rake(dragged(2, other), bench.bob));
    session.end_leases("p1");
    EXPECT_EQ(holder(), "");
    EXPECT_EQ(session.records().get<protocol::RakeRecord>(other)->leased_by, "p2");
    session.end_leases("p1");
    EXPECT_EQ(session.records().get<protocol::RakeRecord>(other)->leased_by, "p2");
}

TEST_F(LeaseTest, AnEditOverItTakesItOverOrEndsIt) {
    drag(bench.ada);
    drag(bench.bob);
    EXPECT_EQ(holder(), "p2");
    drag(bench.ada, std::nullopt);
    EXPECT_EQ(holder(), "");
    drag(bench.ada);
    drag(bench.bob, false);
    EXPECT_EQ(holder(), "");
}

TEST_F(LeaseTest, GoesWithItsRake) {
    drag(bench.ada);
    ASSERT_TRUE(session.remove({server::RecordType::Rake, rake}, bench.ada));
    EXPECT_FALSE(session.lease(rake));
    const auto seq = session.seq();
    bench.loop.pass(2 * server::limits::lease);
    EXPECT_EQ(session.seq(), seq) << "no timer is left behind";
    EXPECT_EQ(session.move_in_history(server::HistoryMove::Undo, bench.ada).changes.size(), 1u);
    EXPECT_EQ(holder(), "") << "what comes back is no one's";
}

} // namespace wakesurf::tests::lease_test
