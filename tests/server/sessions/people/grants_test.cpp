// Share links: how long they are good for, who is told of their end, and what of them is kept.
#include "server/base/limits.hpp"
#include "server/sessions/people/grants.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace wakesurf::server::grants_test {

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class Disk final : public Journal {
  public:
    void write(const std::string&, std::vector<JournalEntry> entries) override {
        for (JournalEntry& each : entries)
            if (each.record)
                records[each.id] = *each.record;
            else
                records.erase(each.id);
    }

    void remove(const std::string&) override {}

    void settled(std::function<void(core::Result<void>)> done) override { done({}); }

    std::map<std::string, std::string> records;
};

struct Holder final : GrantHolder {
    void grant_ended(const std::string& reason) override { reasons.push_back(reason); }

    std::vector<std::string> reasons;
};

struct GrantsTest : testing::Test {
    GrantServices services() {
        return {loop, clock, entropy, [this] { return wall; }, &disk};
    }

    std::int64_t wall = 1'800'000'000;
    HandClock clock;
    HandLoop loop{clock};
    SystemEntropy entropy;
    Disk disk;
    Grants grants{services()};
    Holder holder;
};

} // namespace

TEST_F(GrantsTest, LetsInByItsKeyOnlyAndInItsRoleAndSessionOnly) {
    const auto viewer = grants.make("main", Role::Viewer, {});
    const auto host = grants.make("session-1", Role::Host, {});
    EXPECT_EQ(viewer->key.size(), 64u) << "256 random bits";
    EXPECT_EQ(grants.find(viewer->key), (Identity{Role::Viewer, "main", viewer->grant.id}));
    EXPECT_EQ(grants.find(host->key), (Identity{Role::Host, "session-1", host->grant.id}));
    for (const std::string& wrong : {std::string(), viewer->grant.id, viewer->key.substr(1),
                                     viewer->key + "0", digest_text(secret_digest(viewer->key))})
        EXPECT_EQ(grants.find(wrong), std::nullopt) << wrong;
}

TEST_F(GrantsTest, EndsALinkWhenItExpiresAndTellsWhoeverCameByIt) {
    const auto made = grants.make("main", Role::Editor, seconds(60));
    EXPECT_EQ(made->grant.expires, wall + 60);
    grants.attend(made->grant.id, holder);
    loop.advance(milliseconds(59'999));
    EXPECT_TRUE(grants.find(made->key));
    EXPECT_TRUE(holder.reasons.empty());
    loop.advance(milliseconds(1));
    EXPECT_EQ(grants.find(made->key), std::nullopt);
    EXPECT_EQ(grants.identity(made->grant.id), std::nullopt);
    EXPECT_EQ(holder.reasons, std::vector<std::string>{"the share link has expired"});
    EXPECT_TRUE(grants.of("main").empty());
    EXPECT_TRUE(disk.records.empty());
}

TEST_F(GrantsTest, LetsNobodyInAfterTheEndEvenWhereTheTimerIsLate) {
    const auto made = grants.make("main", Role::Editor, seconds(60));
    clock.time += seconds(60);
    EXPECT_EQ(grants.find(made->key), std::nullopt);
    EXPECT_EQ(grants.identity(made->grant.id), std::nullopt);
    EXPECT_TRUE(grants.of("main").empty());
}

TEST_F(GrantsTest, KeepsLinksOfManyDaysUntilTheirTime) {
    const auto made = grants.make("main", Role::Viewer, std::chrono::hours(24 * 40));
    grants.attend(made->grant.id, holder);
    loop.advance(std::chrono::hours(24 * 40 - 1));
    EXPECT_TRUE(holder.reasons.empty());
    loop.advance(std::chrono::hours(1));
    EXPECT_EQ(holder.reasons.size(), 1u);
}

TEST_F(GrantsTest, TakesALinkBackForItsOwnSessionOnly) {
    const auto made = grants.make("main", Role::Viewer, {});
    const auto other = grants.make("main", Role::Viewer, {});
    grants.attend(made->grant.id, holder);
    EXPECT_EQ(grants.revoke("session-1", made->grant.id).error().code, core::Error::Code::NotFound);
    EXPECT_TRUE(grants.find(made->key));
    EXPECT_TRUE(grants.revoke("main", made->grant.id));
    EXPECT_EQ(holder.reasons, std::vector<std::string>{"the share link was revoked"});
    EXPECT_EQ(grants.find(made->key), std::nullopt);
    EXPECT_TRUE(grants.find(other->key));
    EXPECT_FALSE(grants.revoke("main", made->grant.id));
}

TEST_F(GrantsTest, TellsNobodyWhoHasLeft) {
    const auto made = grants.make("main", Role::Viewer, {});
    grants.attend(made->grant.id, holder);
    grants.leave(made->grant.id, holder);
    ASSERT_TRUE(grants.revoke("main", made->grant.id));
    EXPECT_TRUE(holder.reasons.empty());
}

TEST_F(GrantsTest, LimitsTheLinksOfASessionAndMakesRoomAsTheyEnd) {
    for (std::size_t i = 0; i < limits::grants; ++i)
        ASSERT_TRUE(grants.make("main", Role::Viewer, seconds(10)));
    EXPECT_EQ(grants.make("main", Role::Viewer, {}).error().code, core::Error::Code::OverLimit);
    EXPECT_TRUE(grants.make("session-1", Role::Viewer, {}));
    loop.advance(seconds(10));
    EXPECT_TRUE(grants.make("main", Role::Viewer, {}));
}

TEST_F(GrantsTest, ComesBackFromTheJournalWhichNeverHoldsAKey) {
    const auto forever = grants.make("main", Role::Host, {});
    const auto an_hour = grants.make("main", Role::Viewer, std::chrono::hours(1));
    const auto a_minute = grants.make("main", Role::Editor, seconds(60));
    for (const auto& [id, record] : disk.records)
        for (const std::string& key : {forever->key, an_hour->key, a_minute->key})
            EXPECT_EQ(record.find(key), std::string::npos) << id;
    const auto kept = disk.records;
    wall += 600; // the server was down, and its steady clock starts again
    Grants after(services());
    for (const auto& [id, record] : kept)
        EXPECT_TRUE(after.restore("main", id, record)) << record;
    EXPECT_EQ(after.find(forever->key), (Identity{Role::Host, "main", forever->grant.id}));
    EXPECT_EQ(after.find(an_hour->key)->role, Role::Viewer);
    EXPECT_EQ(after.find(a_minute->key), std::nullopt);
    EXPECT_FALSE(disk.records.contains(a_minute->grant.id)) << "struck: it expired meanwhile";
    clock.time += std::chrono::minutes(50);
    EXPECT_EQ(after.find(an_hour->key), std::nullopt);
    const auto next = after.make("main", Role::Viewer, {});
    EXPECT_FALSE(kept.contains(next->grant.id)) << "no id is given twice";
}

TEST_F(GrantsTest, ALinkIntoACopyEndsWithItsMakersAndCountsForThat) {
    const auto made = grants.make("main", Role::Viewer, seconds(60));
    const auto copy = grants.make_for_copy("session-1", {made->grant.id, "Ada"});
    const Identity own{Role::Editor, "session-1", copy->grant.id, made->grant.id};
    EXPECT_EQ(grants.find(copy->key), own);
    EXPECT_EQ(own.account(), made->grant.id);
    const auto further = grants.make_for_copy("session-2", {copy->grant.id, "Ada"});
    EXPECT_EQ(grants.find(further->key)->account(), made->grant.id) << "a copy of a copy";
    EXPECT_EQ(grants.copies(made->grant.id).size(), 2u);
    EXPECT_EQ(grants.descendants(made->grant.id).size(), 2u);
    Grants after(services());
    EXPECT_TRUE(after.restore("session-1", copy->grant.id, disk.records[copy->grant.id]));
    EXPECT_EQ(after.find(copy->key), own);
    loop.advance(seconds(60));
    EXPECT_EQ(grants.find(copy->key), std::nullopt);
    EXPECT_TRUE(grants.copies().empty());
}

TEST_F(GrantsTest, LinksIntoCopiesEndWithTheRevokedLinkAndOtherLinksOnlyWhereThatIsAsked) {
    const auto made = grants.make("main", Role::Host, {});
    const auto child = grants.make("main", Role::Viewer, {}, {made->grant.id, "Ada"});
    const auto copy = grants.make_for_copy("session-1", {made->grant.id, "Ada"});
    const auto further = grants.make_for_copy("session-2", {copy->grant.id, "Ada"});
    const auto childs = grants.make_for_copy("session-3", {child->grant.id, "Bob"});
    ASSERT_TRUE(grants.revoke("main", made->grant.id));
    EXPECT_EQ(grants.find(copy->key), std::nullopt);
    EXPECT_EQ(grants.find(further->key), std::nullopt) << "a copy of a copy";
    EXPECT_TRUE(grants.find(child->key));
    EXPECT_TRUE(grants.find(childs->key)) << "a copy by a link that is still good";
}

TEST_F(GrantsTest, RefusesRecordsThatAreNoLinks) {
    const std::string digest(64, 'a');
    const auto record = [&](const std::string& members) { return "{" + members + "}"; };
    const std::string good = R"("role":"viewer","sha256":")" + digest + "\"";
    EXPECT_TRUE(grants.restore("main", "g4", record(good)));
    EXPECT_TRUE(grants.restore("main", "g5", record(good + R"(,"expires":9223372036854775807)")));
    EXPECT_TRUE(grants.identity("g5")) << "cut to what times can hold";
    for (const std::string& bad :
         {std::string(), std::string("[]"), record(""), record(R"("role":"viewer")"),
          record(R"("role":"owner","sha256":")" + digest + "\""),
          record(R"("role":"viewer","sha256":")" + digest + "0\""),
          record(R"("role":"viewer","sha256":"short")"), record(good + R"(,"expires":"soon")"),
          record(good + R"(,"lineage":"g1")"), record(good + R"(,"lineage":[1])"),
          record(good + R"(,"maker":7)"), record(good + R"(,"copier":7)"),
          record(good + R"(,"lowered":{"p1":1})"), record(good + R"(,"lowered":{"p1":"king"})"),
          record(good + R"(,"lowered":["viewer"])"), record(good + R"(,"expires":1e99)")})
        EXPECT_EQ(grants.restore("main", "g6", bad).error().code, core::Error::Code::Corrupt)
            << bad;
    for (const char* id : {"", "g", "7", "x7", "g7x", "g-7"})
        EXPECT_FALSE(grants.restore("main", id, record(good))) << id;
}

TEST_F(GrantsTest, ForgetsTheLinksOfASessionThatIsGone) {
    const auto made = grants.make("session-1", Role::Viewer, {});
    const auto other = grants.make("main", Role::Viewer, {});
    grants.attend(made->grant.id, holder);
    grants.forget("session-1");
    EXPECT_EQ(holder.reasons.size(), 1u);
    EXPECT_EQ(grants.find(made->key), std::nullopt);
    EXPECT_TRUE(grants.find(other->key));
}

TEST_F(GrantsTest, KnowsWhichLinksALinkHasMadeAndEndsThemWhereThatIsAskedFor) {
    const auto first = grants.make("main", Role::Host, {}, {"", "Ada"});
    const auto child = grants.make("main", Role::Host, {}, {first->grant.id, "Bob"});
    const auto grandchild = grants.make("main", Role::Viewer, {}, {child->grant.id, ""});
    const auto other = grants.make("main", Role::Viewer, {});
    EXPECT_EQ(first->grant.maker, "Ada");
    EXPECT_TRUE(first->grant.lineage.empty());
    EXPECT_EQ(grandchild->grant.lineage,
              (std::vector<std::string>{first->grant.id, child->grant.id}));
    EXPECT_EQ(grants.descendants(first->grant.id).size(), 2u);
    // The one between has gone; what it made is known all the same, also after a restart.
    ASSERT_TRUE(grants.revoke("main", child->grant.id));
    EXPECT_TRUE(grants.find(grandchild->key));
    Grants after(services());
    for (const auto& [id, record] : disk.records)
        ASSERT_TRUE(after.restore("main", id, record));
    ASSERT_EQ(after.descendants(first->grant.id).size(), 1u);
    EXPECT_EQ(after.grant(first->grant.id)->maker, "Ada");
    Holder by_grandchild;
    after.attend(grandchild->grant.id, by_grandchild);
    ASSERT_TRUE(after.revoke("main", first->grant.id, true));
    EXPECT_EQ(by_grandchild.reasons.size(), 1u);
    EXPECT_EQ(after.find(grandchild->key), std::nullopt);
    EXPECT_TRUE(after.find(other->key));
}

TEST_F(GrantsTest, LetsNoLinkOutliveTheOneThatMadeIt) {
    const auto parent = grants.make("main", Role::Host, seconds(60));
    const LinkMaker maker{parent->grant.id, {}};
    EXPECT_EQ(grants.longest_of(parent->grant.id), seconds(60));
    EXPECT_EQ(grants.longest_of(""), std::nullopt);
    EXPECT_TRUE(grants.make("main", Role::Viewer, seconds(60), maker));
    EXPECT_EQ(grants.make("main", Role::Viewer, seconds(61), maker).error().code,
              core::Error::Code::InvalidArgument);
    EXPECT_EQ(grants.make("main", Role::Viewer, {}, maker).error().code,
              core::Error::Code::InvalidArgument);
}

TEST_F(GrantsTest, BoundsHowLongAChainOfLinksMayGet) {
    LinkMaker maker;
    for (std::size_t i = 0; i <= limits::grant_depth; ++i) {
        const auto made = grants.make("main", Role::Host, {}, maker);
        ASSERT_TRUE(made) << i;
        maker.grant = made->grant.id;
    }
    EXPECT_EQ(grants.make("main", Role::Host, {}, maker).error().code,
              core::Error::Code::OverLimit);
}

TEST_F(GrantsTest, GivesNewcomersNoMoreThanAnybodyWhoCameByTheLinkWasLeft) {
    const auto made = grants.make("main", Role::Host, {});
    const std::string& id = made->grant.id;
    const auto role = [&](const Grants& of) { return of.find(made->key)->role; };
    grants.set_role(id, "p1", Role::Editor);
    EXPECT_EQ(role(grants), Role::Editor);
    grants.set_role(id, "p2", Role::Viewer);
    EXPECT_EQ(role(grants), Role::Viewer);
    EXPECT_EQ(grants.identity(id)->role, Role::Viewer);
    EXPECT_EQ(grants.of("main").front().role, Role::Host) << "the link is what it was";
    Grants after(services());
    ASSERT_TRUE(after.restore("main", id, disk.records.at(id)));
    EXPECT_EQ(role(after), Role::Viewer) << "a restart lifts nothing";
    after.set_role(id, "p2", Role::Host);
    EXPECT_EQ(role(after), Role::Editor);
    after.set_role(id, "p1", Role::Host);
    EXPECT_EQ(role(after), Role::Host);
    for (std::size_t i = 0; i < 2 * limits::lowered; ++i)
        after.set_role(id, "p" + std::to_string(i), Role::Viewer);
    for (std::size_t i = 0; i < 2 * limits::lowered; ++i)
        after.set_role(id, "p" + std::to_string(i), Role::Host);
    EXPECT_EQ(role(after), Role::Viewer) << "of too many only the least is remembered";
    after.set_role("g99", "p1", Role::Viewer);
}

TEST(Secrets, AreComparedByTheirSha256) {
    EXPECT_EQ(digest_text(secret_digest("abc")),
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(read_digest(digest_text(secret_digest("abc"))), secret_digest("abc"));
    EXPECT_TRUE(same_digest(secret_digest("abc"), secret_digest("abc")));
    EXPECT_FALSE(same_digest(secret_digest("abc"), secret_digest("abd")));
    EXPECT_EQ(read_digest(std::string(64, 'g')), std::nullopt);
}

} // namespace wakesurf::server::grants_test
