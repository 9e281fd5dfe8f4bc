// Undo and redo within random edits of several authors: an undo returns the records of before, and changes no one else's.
#include "tests/support/server/random_edits.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace wakesurf::tests::random_history_test {

using server::HistoryMove;
using server::RecordType;

TEST(RandomHistory, AfterAnyEditUndoGivesTheRecordsBeforeIt) {
    std::size_t compared = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SessionBench other;
        RandomEdits edits(other, seed);
        for (int i = 0; i < 60; ++i) {
            const server::Author& author = edits.some_author();
            for (int j = 0; j < 3; ++j)
                edits.step();
            const auto before = content(other.session->records(), false);
            const auto made = other.session->set_rake(rake_at(0.1 * i), author);
            ASSERT_TRUE(made);
            const auto after = content(other.session->records(), false);
            ASSERT_EQ(other.session->move_in_history(HistoryMove::Undo, author).changes.size(), 1u);
            ASSERT_EQ(content(other.session->records(), false), before) << "seed " << seed;
            ASSERT_EQ(other.session->move_in_history(HistoryMove::Redo, author).changes.size(), 1u);
            ASSERT_EQ(content(other.session->records(), false), after);
            ASSERT_TRUE(other.session->remove({RecordType::Rake, made->record.rake}, author));
            ASSERT_EQ(content(other.session->records(), false), before);
            other.session->move_in_history(HistoryMove::Undo, author);
            ASSERT_EQ(content(other.session->records(), false), after);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 480u);
}

// Each author has rakes of their own; whatever the others do, an undo changes no record that is not the author's.
TEST(RandomHistory, UndoChangesOnlyWhatItsAuthorChangedLast) {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        std::mt19937_64 random(seed);
        SessionBench other;
        server::Session& shared = *other.session;
        const server::Author* authors[] = {&other.ada, &other.bob, &other.script};
        std::vector<std::string> rakes;
        std::map<std::string, std::string> last;
        for (int i = 0; i < 4; ++i)
            rakes.push_back(shared.set_rake(rake_at(i))->record.rake);
        for (int i = 0; i < 200; ++i) {
            const server::Author& author = *authors[random() % 3];
            const std::string& rake = rakes[random() % rakes.size()];
            if (random() % 3 != 0) {
                ASSERT_TRUE(shared.set_rake(rake_at(0.01 * i, rake), author));
                last[rake] = author.participant;
                continue;
            }
            const auto moved = shared.move_in_history(
                random() % 3 == 0 ? HistoryMove::Redo : HistoryMove::Undo, author);
            for (const server::RecordChange& each : moved.changes)
                ASSERT_EQ(last[each.key.id], author.participant) << "seed " << seed;
        }
    }
}

} // namespace wakesurf::tests::random_history_test
