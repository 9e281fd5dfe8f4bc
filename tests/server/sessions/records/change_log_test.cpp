// What is replayed to somebody who comes back, applied to what they had, is what the session has now.
#include "server/base/limits.hpp"
#include "server/sessions/records/change_log.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace wakesurf::server::change_log_test {

namespace {

using Revisions = std::map<std::string, std::uint64_t>; ///< of records, by id

void apply(Revisions& to, const Patch& patch) {
    if (const auto* rake = std::get_if<protocol::RakeRecord>(&patch))
        to[rake->rake] = rake->rev;
    if (const auto* surface = std::get_if<protocol::SurfaceRecord>(&patch))
        to[surface->surface] = surface->rev;
    if (const auto* gone = std::get_if<DeletedRecord>(&patch))
        to.erase(gone->id);
}

Patch rake(const std::string& id, std::uint64_t rev) {
    protocol::RakeRecord record;
    record.rake = id;
    record.rev = rev;
    return record;
}

Patch surface(const std::string& id, std::uint64_t rev) {
    protocol::SurfaceRecord record;
    record.surface = id;
    record.rev = rev;
    return record;
}

} // namespace

TEST(ChangeLog, GivesWhoeverComesBackWhatTheOthersHave) {
    std::mt19937 random(11);
    ChangeLog log;
    Revisions now;
    std::vector<Revisions> history{now};
    for (std::uint64_t seq = 1; seq <= 600; ++seq) {
        std::vector<Patch> patches;
        for (std::size_t i = 0; i <= random() % 3; ++i) {
            const std::string number = std::to_string(random() % 20);
            switch (random() % 4) {
            case 0:
                patches.emplace_back(DeletedRecord{"rake", "r" + number});
                break;
            case 1:
                patches.push_back(surface("s" + number, seq));
                break;
            default:
                patches.push_back(rake("r" + number, seq));
            }
        }
        log.add(seq, patches);
        for (const Patch& each : patches)
            apply(now, each);
        history.push_back(now);
        const std::uint64_t since = random() % (seq + 1);
        Revisions resumed = history[since];
        const auto missed = log.since(since);
        ASSERT_TRUE(missed);
        EXPECT_LE(missed->size(), 40u) << "one change of each record";
        for (const Patch& each : *missed)
            apply(resumed, each);
        EXPECT_EQ(resumed, now) << since << " to " << seq;
    }
    EXPECT_TRUE(log.since(600)->empty());
    EXPECT_FALSE(log.since(601)) << "a number of another run";
}

TEST(ChangeLog, SaysWhenItDoesNotReachBackFarEnough) {
    ChangeLog log;
    for (std::uint64_t seq = 1; seq <= limits::changes + 10; ++seq)
        log.add(seq, std::vector{rake("r" + std::to_string(seq), 1)});
    EXPECT_FALSE(log.since(0));
    EXPECT_FALSE(log.since(9));
    ASSERT_TRUE(log.since(10));
    EXPECT_EQ(log.since(10)->size(), limits::changes);
}

TEST(ChangeLog, ReachesBackToItsStartOnly) {
    ChangeLog log;
    log.start(100);
    log.add(101, std::vector{rake("r1", 1)});
    EXPECT_FALSE(log.since(99)) << "of before a restart";
    EXPECT_EQ(log.since(100)->size(), 1u);
    EXPECT_TRUE(log.since(101)->empty());
}

} // namespace wakesurf::server::change_log_test
