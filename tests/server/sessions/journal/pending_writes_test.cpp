// Changes in memory against their definition: applied to a map, coalesced ones do what one after the other did.
#include "server/sessions/journal/pending_writes.hpp"
#include "tests/support/server/record_script.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace wakesurf::tests::pending_writes_test {

using server::PendingWrites;

namespace {

void carry_out(const PendingWrites& changes, RecordMap& records) {
    std::erase_if(records, [&](const auto& each) {
        return changes.removed.contains(std::get<0>(each.first));
    });
    for (const auto& [key, json] : changes.records)
        if (json)
            records[{key.session, key.type, key.id}] = *json;
        else
            records.erase({key.session, key.type, key.id});
}

void add(PendingWrites& changes, const ScriptedEdit& edit) {
    if (edit.entries.empty())
        changes.remove(edit.session);
    else
        changes.write(edit.session, edit.entries);
}

} // namespace

TEST(PendingWrites, DoWhatTheEditsDidOneAfterTheOther) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        RecordScript script(seed);
        RecordMap records;
        PendingWrites changes;
        for (int edit = 0; edit < 60; ++edit) {
            add(changes, script.next());
            if (script.random()() % 4 == 0)
                carry_out(std::exchange(changes, {}), records);
        }
        carry_out(changes, records);
        ASSERT_EQ(records, script.now()) << "seed " << seed;
    }
}

TEST(PendingWrites, TakeUpOlderOnesThatWereNotWritten) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        RecordScript script(seed);
        PendingWrites older;
        PendingWrites newer;
        for (int edit = 0; edit < 30; ++edit)
            add(edit < 15 ? older : newer, script.next());
        newer.follow(std::move(older));
        RecordMap records;
        carry_out(newer, records);
        ASSERT_EQ(records, script.now()) << "seed " << seed;
    }
}

TEST(PendingWrites, AreAsLargeAsTheRecordsHoweverManyEdits) {
    RecordScript script(7);
    PendingWrites changes;
    for (int edit = 0; edit < 10'000; ++edit)
        add(changes, script.next());
    EXPECT_LE(changes.records.size(), 4u * (3 * 8 + 1));
    EXPECT_LE(changes.removed.size(), 4u);
    changes.drop_needless({});
    for (const auto& [key, json] : changes.records)
        EXPECT_TRUE(json) << key.id;
}

} // namespace wakesurf::tests::pending_writes_test
