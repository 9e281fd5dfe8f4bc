// What the records of one session, and of all together, may take: one link cannot fill the server's memory with rakes, notes and undo steps.
#include "core/base/memory_account.hpp"
#include "protocol/api/base/json_text.hpp"
#include "protocol/api/session_file.hpp"
#include "server/base/limits.hpp"
#include "server/sessions/session_exchange.hpp"
#include "tests/support/server/hand_clock.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>

namespace wakesurf::server::record_room_test {

namespace {

constexpr std::size_t mebi = std::size_t{1} << 20;

struct RecordRoom : testing::Test {
    RecordRoom() {
        SessionServices services{loop, pool, datasets, entropy};
        services.clock = &clock;
        services.memory = &memory;
        sessions.emplace(services);
    }

    static protocol::RakeSetting long_rake(std::optional<std::string> id = {}) {
        protocol::RakeSetting setting;
        setting.rake = std::move(id);
        for (std::size_t i = 0; i < limits::rake_points; ++i)
            setting.shape.points.emplace_back(0.001 * static_cast<double>(i), 1.0 / 3.0, 0.0);
        setting.shape.kind = core::Rake::Kind::Polyline;
        setting.shape.seeds = 5;
        return setting;
    }

    /// Adds rakes, notes and bookmarks, as large as they may be, until they are refused: why.
    static core::Error fill(Session& session) {
        const std::string text(limits::annotation_bytes, 'n');
        const std::string view = "{\"v\":\"" + std::string(limits::view_bytes - 10, 'v') + "\"}";
        for (int i = 0; i < 2000; ++i) {
            if (auto made = session.set_rake(long_rake(), ada); !made)
                return made.error();
            if (auto made = session.set_annotation(tests::note(text), ada); !made)
                return made.error();
            if (auto made = session.set_bookmark(tests::bookmark_of(view), ada); !made)
                return made.error();
        }
        return {core::Error::Code::Io, "never refused", {}};
    }

    std::size_t taken() const { return memory.used(core::MemoryUse::Records); }

    inline static const Author ada{"p1", "Ada"};
    inline static const Author bob{"p2", "Bob"};

    HandClock clock;
    HandLoop loop{clock};
    ComputePool pool{ComputePool::ByHand{}};
    tests::OneFlow datasets;
    SystemEntropy entropy;
    core::MemoryAccount memory{300 * mebi};
    std::optional<SessionDirectory> sessions;
};

} // namespace

TEST_F(RecordRoom, OfASessionIsBoundedWhateverItsRecordsAre) {
    Session& session = **sessions->find("main");
    const core::Error refused = fill(session);
    EXPECT_EQ(refused.code, core::Error::Code::OverLimit);
    EXPECT_EQ(refused.limit, limits::session_bytes);
    EXPECT_NE(refused.message.find("1024 KiB"), std::string::npos) << refused.message;
    EXPECT_FALSE(refused.hint.empty());
    EXPECT_LE(session.records().bytes(), limits::session_bytes);
    EXPECT_GT(session.records().bytes(), limits::session_bytes * 9 / 10);
    EXPECT_LE(taken(), 2 * limits::session_bytes + limits::undo_bytes) << "undo included";
    EXPECT_LT(
        protocol::json_text(protocol::session_file_json(file_of(snapshot_of(session, datasets, 0))))
            .size(),
        limits::outbox_message_bytes)
        << "who joins gets all of it in one message";
}

TEST_F(RecordRoom, ThatIsFullStillLetsRecordsBeMovedMadeSmallerAndDeleted) {
    Session& session = **sessions->find("main");
    fill(session);
    const std::string first = session.records().all<protocol::RakeRecord>().begin()->first;
    EXPECT_TRUE(session.set_rake(long_rake(first), ada)) << "as large as it was";
    EXPECT_TRUE(session.set_rake(tests::rake_at(1, first), ada));
    EXPECT_TRUE(session.set_rake(long_rake(first), ada));
    ASSERT_TRUE(session.remove({RecordType::Rake, first}, ada));
    EXPECT_TRUE(session.set_rake(long_rake(), ada)) << "there is room again";
}

TEST_F(RecordRoom, IsNotExceededByUndo) {
    Session& session = **sessions->find("main");
    fill(session);
    ASSERT_TRUE(session.remove(
        {RecordType::Rake, session.records().all<protocol::RakeRecord>().begin()->first}, ada));
    ASSERT_TRUE(session.set_rake(long_rake(), bob));
    const HistoryMoveResult moved = session.move_in_history(HistoryMove::Undo, ada);
    EXPECT_TRUE(moved.changes.empty());
    ASSERT_EQ(moved.skipped.size(), 1u);
    EXPECT_NE(moved.skipped.front().why.find("KiB"), std::string::npos)
        << moved.skipped.front().why;
    EXPECT_LE(session.records().bytes(), limits::session_bytes);
}

TEST_F(RecordRoom, OfAllSessionsIsAPartOfTheMemoryAndSmallSessionsAlwaysHaveSome) {
    core::Error refused;
    for (int i = 0; i < 100 && refused.limit != memory.budget() / limits::records_part; ++i)
        refused = fill(**sessions->create("busy " + std::to_string(i)));
    EXPECT_EQ(refused.code, core::Error::Code::OverLimit);
    EXPECT_EQ(refused.limit, memory.budget() / limits::records_part);
    EXPECT_NE(refused.message.find("--memory, 37 MiB"), std::string::npos) << refused.message;
    EXPECT_LE(taken(), memory.budget() / limits::records_part + limits::undo_bytes);
    Session& light = **sessions->create("light");
    for (int i = 0; i < 20; ++i)
        EXPECT_TRUE(light.set_rake(tests::rake_at(i), ada));
    const Session& full = **sessions->find("session-1");
    EXPECT_FALSE(sessions->fork(full.id(), "copy"));
}

TEST_F(RecordRoom, OfTheCopiesByOneLinkIsThatOfOneSession) {
    const auto copy = [&](const char* link) {
        return *sessions->fork("main", "copy", false, link);
    };
    Session& full = *copy("g1");
    EXPECT_EQ(fill(full).limit, limits::session_bytes);
    Session& next = *copy("g1");
    const auto refused = next.set_rake(long_rake(), ada);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().limit, limits::session_bytes);
    EXPECT_NE(refused.error().message.find("share link"), std::string::npos)
        << refused.error().message;
    EXPECT_FALSE(sessions->fork(full.id(), "copy", false, "g1"));
    EXPECT_TRUE(copy("g2")->set_rake(long_rake(), ada));
    EXPECT_TRUE((*sessions->find("main"))->set_rake(long_rake(), ada));
    EXPECT_TRUE(sessions->fork(full.id(), "copy"));
}

TEST_F(RecordRoom, OfAllCopiesIsHalfOfThatOfAllSessions) {
    core::Error refused;
    for (int i = 0; i < 100 && refused.limit != memory.budget() / limits::records_part / 2; ++i)
        refused = fill(**sessions->fork("main", "copy", false, "g" + std::to_string(i)));
    EXPECT_EQ(refused.limit, memory.budget() / limits::records_part / 2);
    EXPECT_EQ(fill(**sessions->create("work")).limit, limits::session_bytes)
        << "what is no copy is not refused for them";
}

TEST_F(RecordRoom, IsGivenBackWithTheSessionAndCountedInTheTrash) {
    const std::string id = (*sessions->create("busy"))->id();
    fill(**sessions->find(id));
    const std::size_t open = taken();
    ASSERT_TRUE(sessions->remove(id));
    EXPECT_GT(taken(), mebi) << "as text it waits for session.restore";
    EXPECT_LT(taken(), open + mebi);
    ASSERT_TRUE(sessions->erase(id));
    EXPECT_EQ(taken(), 0u);
}

TEST_F(RecordRoom, RefusesAFileOfMore) {
    Session& session = **sessions->find("main");
    fill(session);
    auto file = protocol::session_file_json(file_of(snapshot_of(session, datasets, 0)));
    ASSERT_TRUE(read_session_text(protocol::json_text(file)));
    auto& rakes = file["records"]["rakes"];
    rakes.push_back(rakes.back());
    rakes.back()["rake"] = "r9999";
    const auto read = read_session_text(protocol::json_text(file));
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().limit, limits::session_bytes);
}

} // namespace wakesurf::server::record_room_test
