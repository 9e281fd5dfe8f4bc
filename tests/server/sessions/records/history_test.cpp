// Undo and redo: each author's own edits, one drag at a time, and never somebody else's.
#include "server/base/limits.hpp"
#include "tests/support/server/random_edits.hpp"

#include <gtest/gtest.h>

namespace wakesurf::tests::history_test {

using protocol::AnnotationRecord;
using protocol::RakeRecord;
using protocol::SurfaceRecord;
using server::HistoryMove;
using server::HistoryMoveResult;
using server::RecordType;

class HistoryTest : public testing::Test {
  protected:
    SessionBench bench;
    server::Session& session = *bench.session;
    const server::SessionRecords& records = session.records();

    std::string make_rake(const server::Author& author, double x = 0) {
        return session.set_rake(rake_at(x), author)->record.rake;
    }

    void move(const server::Author& author, const std::string& rake, double x) {
        ASSERT_TRUE(session.set_rake(rake_at(x, rake), author));
    }

    static server::Author in_gesture(server::Author author, std::string gesture) {
        author.gesture = std::move(gesture);
        return author;
    }

    static std::vector<server::Record> shown(const server::Session& session) {
        return content(session.records(), false);
    }

    double x_of(const std::string& rake) const {
        return records.get<RakeRecord>(rake)->shape.points[0].x;
    }

    HistoryMoveResult undo(const server::Author& author) {
        return session.move_in_history(HistoryMove::Undo, author);
    }

    HistoryMoveResult redo(const server::Author& author) {
        return session.move_in_history(HistoryMove::Redo, author);
    }
};

TEST_F(HistoryTest, WalksBackAndForthThroughAChainOfEdits) {
    const auto rake = make_rake(bench.ada, 0);
    for (int x = 1; x <= 5; ++x)
        move(bench.ada, rake, x);
    for (int round = 0; round < 3; ++round) {
        for (int x = 4; x >= 0; --x) {
            EXPECT_EQ(undo(bench.ada).changes.size(), 1u);
            EXPECT_EQ(x_of(rake), x);
        }
        EXPECT_EQ(undo(bench.ada).left.undo, 0u);
        EXPECT_TRUE(records.all<RakeRecord>().empty());
        EXPECT_TRUE(undo(bench.ada).changes.empty()) << "nothing left";
        for (int x = 0; x <= 5; ++x) {
            EXPECT_EQ(redo(bench.ada).changes.size(), 1u);
            EXPECT_EQ(x_of(rake), x);
        }
        EXPECT_TRUE(redo(bench.ada).changes.empty());
    }
    undo(bench.ada);
    undo(bench.ada);
    move(bench.ada, rake, 9);
    EXPECT_EQ(redo(bench.ada).left.redo, 0u) << "a new edit leaves nothing to do again";
    EXPECT_EQ(x_of(rake), 9);
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 3);
}

TEST_F(HistoryTest, ADeletedRakeComesBackWithItsSurfaces) {
    const auto rake = make_rake(bench.ada);
    const auto surface = session.set_surface(surface_on(rake), bench.ada)->surface;
    for (int i = 0; i < 7; ++i)
        move(bench.bob, rake, i);
    const auto before = content(session.records(), false);
    const auto epoch = records.get<SurfaceRecord>(surface)->epoch;
    const auto number = (*session.live(surface))->number();
    ASSERT_TRUE(session.remove({RecordType::Rake, rake}, bench.ada));
    EXPECT_TRUE(session.records().empty());
    EXPECT_EQ(undo(bench.ada).changes.size(), 2u);
    EXPECT_EQ(content(session.records(), false), before);
    EXPECT_GT(records.get<SurfaceRecord>(surface)->epoch, epoch) << "an epoch never comes again";
    EXPECT_NE((*session.live(surface))->number(), number) << "nor a number on the wire";
    redo(bench.ada);
    EXPECT_TRUE(session.records().empty());
    undo(bench.ada);
    EXPECT_EQ(content(session.records(), false), before);
}

TEST_F(HistoryTest, EpochsGoOnWhenACreationIsUndoneAndDoneAgain) {
    const auto rake = make_rake(bench.bob);
    const auto surface = session.set_surface(surface_on(rake), bench.ada)->surface;
    for (int i = 0; i < 9; ++i)
        move(bench.bob, rake, i);
    const auto epoch = records.get<SurfaceRecord>(surface)->epoch;
    undo(bench.ada);
    EXPECT_TRUE(records.all<SurfaceRecord>().empty());
    redo(bench.ada);
    EXPECT_GT(records.get<SurfaceRecord>(surface)->epoch, epoch);
}

TEST_F(HistoryTest, ADragIsOneStep) {
    const auto rake = make_rake(bench.ada, 0);
    for (int x = 1; x <= 60; ++x) {
        ASSERT_TRUE(session.set_rake(dragged(0.1 * x, rake), bench.ada));
        bench.loop.pass(std::chrono::milliseconds(16));
    }
    ASSERT_TRUE(session.set_rake(dragged(7, rake, false), bench.ada));
    EXPECT_EQ(undo(bench.ada).left.undo, 1u);
    EXPECT_EQ(x_of(rake), 0);
    redo(bench.ada);
    EXPECT_EQ(x_of(rake), 7);
    // A lease that ran out between makes two of it.
    ASSERT_TRUE(session.set_rake(dragged(1, rake), bench.ada));
    bench.loop.pass(2 * server::limits::lease);
    ASSERT_TRUE(session.set_rake(dragged(2, rake), bench.ada));
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 1);
    EXPECT_FALSE(records.get<RakeRecord>(rake)->dragging);
}

TEST_F(HistoryTest, AGestureIsOneStepAndPushesNoOlderOneOut) {
    const auto rake = make_rake(bench.ada, -3);
    move(bench.ada, rake, -2);
    for (int i = 1; i <= 300; ++i)
        move(in_gesture(bench.ada, "slide"), rake, 0.01 * i);
    EXPECT_EQ(undo(bench.ada).left.undo, 2u);
    EXPECT_EQ(x_of(rake), -2);
    EXPECT_EQ(redo(bench.ada).left.redo, 0u);
    EXPECT_EQ(x_of(rake), 3);
    undo(bench.ada);
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), -3);
}

TEST_F(HistoryTest, GesturesOfAnotherNameOrAuthorAreOtherSteps) {
    const auto rake = make_rake(bench.ada, 0);
    move(in_gesture(bench.ada, "one"), rake, 1);
    move(in_gesture(bench.ada, "two"), rake, 2);
    const auto other = make_rake(in_gesture(bench.bob, "two"), 3);
    EXPECT_EQ(undo(bench.bob).left.undo, 0u);
    EXPECT_EQ(x_of(rake), 2);
    EXPECT_FALSE(records.get<RakeRecord>(other));
    EXPECT_EQ(undo(bench.ada).left.undo, 2u);
    EXPECT_EQ(x_of(rake), 1);
    EXPECT_EQ(undo(bench.ada).left.undo, 1u);
    EXPECT_EQ(x_of(rake), 0);
}

TEST_F(HistoryTest, AnEditBetweenEndsAGesture) {
    const auto rake = make_rake(bench.ada, 0);
    move(in_gesture(bench.ada, "g"), rake, 1);
    const auto note_id = session.set_annotation(note("look"), bench.ada)->annotation;
    move(in_gesture(bench.ada, "g"), rake, 2);
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 1);
    undo(bench.ada);
    EXPECT_FALSE(records.get<AnnotationRecord>(note_id));
    // The edit from before is on top again: it is of the past all the same.
    move(in_gesture(bench.ada, "g"), rake, 3);
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 1);
}

TEST_F(HistoryTest, WhatSomebodyElseChangesAmidAGestureIsNotUndoneWithIt) {
    const auto rake = make_rake(bench.ada, 0);
    move(in_gesture(bench.ada, "g"), rake, 1);
    move(bench.bob, rake, 2);
    move(in_gesture(bench.ada, "g"), rake, 3);
    move(in_gesture(bench.ada, "g"), rake, 4);
    EXPECT_EQ(undo(bench.ada).changes.size(), 1u);
    EXPECT_EQ(x_of(rake), 2) << "to where Bob left it";
    EXPECT_EQ(undo(bench.ada).skipped.size(), 1u);
    EXPECT_EQ(x_of(rake), 2);
}

TEST_F(HistoryTest, WhatFollowsAnUndoAmidAGestureIsAnotherStep) {
    const auto rake = make_rake(bench.ada, 0);
    const auto slide = in_gesture(bench.ada, "g");
    move(slide, rake, 1);
    move(slide, rake, 2);
    undo(bench.ada);
    move(slide, rake, 3);
    move(slide, rake, 4);
    EXPECT_EQ(undo(bench.ada).left.undo, 1u);
    EXPECT_EQ(x_of(rake), 0);
    EXPECT_EQ(redo(bench.ada).left.redo, 0u);
    EXPECT_EQ(x_of(rake), 4);
    move(slide, rake, 5);
    redo(bench.ada);
    move(slide, rake, 6);
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 5) << "a redo ends it as well, also of nothing";
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 4);
}

TEST_F(HistoryTest, AGestureGathersTheRecordsItMakes) {
    const auto press = in_gesture(bench.ada, "new rake");
    const auto before = content(session.records(), false);
    const auto rake = make_rake(press);
    const auto surface = session.set_surface(surface_on(rake), press)->surface;
    const auto after = content(session.records(), false);
    EXPECT_EQ(undo(bench.ada).changes.size(), 2u);
    EXPECT_EQ(content(session.records(), false), before);
    EXPECT_EQ(redo(bench.ada).changes.size(), 2u);
    EXPECT_EQ(content(session.records(), false), after);
    undo(bench.ada);
    redo(bench.ada);
    move(bench.bob, rake, 3);
    EXPECT_EQ(undo(bench.ada).skipped.size(), 1u) << "Bob has moved a part of it";
    EXPECT_TRUE(records.get<SurfaceRecord>(surface));
}

TEST_F(HistoryTest, WhatAGestureMadeAndDeletedNeverWas) {
    const auto kept = make_rake(bench.ada, 5);
    const auto press = in_gesture(bench.ada, "g");
    const auto rake = make_rake(press);
    ASSERT_TRUE(session.set_surface(surface_on(rake), press));
    ASSERT_TRUE(session.remove({RecordType::Rake, rake}, press));
    EXPECT_EQ(undo(bench.ada).changes[0].key.id, kept);
    EXPECT_TRUE(records.all<RakeRecord>().empty());
}

TEST_F(HistoryTest, WhatOthersMadeOfItComesBackAllTheSame) {
    const auto press = in_gesture(bench.ada, "g");
    const auto rake = make_rake(press);
    const auto surface = session.set_surface(surface_on(rake), bench.bob)->surface;
    const auto before = content(session.records(), false);
    ASSERT_TRUE(session.remove({RecordType::Rake, rake}, press));
    undo(bench.ada);
    EXPECT_EQ(content(session.records(), false), before);
    EXPECT_TRUE(records.get<SurfaceRecord>(surface));
}

TEST_F(HistoryTest, WhatAGestureDeletedComesBackAtALaterRevisionThanItEverHad) {
    const auto rake = make_rake(bench.ada, 0);
    const auto press = in_gesture(bench.ada, "g");
    for (int x = 1; x <= 5; ++x)
        move(press, rake, x);
    const auto last = records.get<RakeRecord>(rake)->rev;
    ASSERT_TRUE(session.remove({RecordType::Rake, rake}, press));
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 0);
    EXPECT_GT(records.get<RakeRecord>(rake)->rev, last);
}

TEST_F(HistoryTest, AGestureGathersABoundedNumberOfRecords) {
    const auto press = in_gesture(bench.ada, "g");
    for (std::size_t i = 0; i < server::limits::gesture_records + 5; ++i)
        ASSERT_TRUE(session.set_annotation(note("n"), press));
    EXPECT_EQ(undo(bench.ada).changes.size(), 5u);
    EXPECT_EQ(undo(bench.ada).changes.size(), server::limits::gesture_records);
}

TEST_F(HistoryTest, ANamedDragIsOneStepHoweverLongTheHandRests) {
    const auto rake = make_rake(bench.ada, 0);
    const auto hand = in_gesture(bench.ada, "drag 1");
    for (int x = 1; x <= 3; ++x) {
        ASSERT_TRUE(session.set_rake(dragged(x, rake), hand));
        bench.loop.pass(2 * server::limits::lease);
    }
    ASSERT_TRUE(session.set_rake(dragged(4, rake, false), hand));
    ASSERT_TRUE(session.set_rake(dragged(5, rake), bench.ada));
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 4) << "a drag without a name is never taken for it";
    undo(bench.ada);
    EXPECT_EQ(x_of(rake), 0);
}

// The twin makes each gesture's last edit alone: after every undo and redo both hold the same.
TEST_F(HistoryTest, AGestureIsWorthItsLastEdit) {
    std::size_t turns = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        std::mt19937_64 random(seed);
        SessionBench slid;
        SessionBench direct;
        server::Session* const both[] = {slid.session.get(), direct.session.get()};
        for (server::Session* each : both)
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(each->set_rake(rake_at(i)));
        for (int i = 0; i < 60; ++i) {
            const std::string rake = "r" + std::to_string(1 + random() % 3);
            if (random() % 2 == 0) {
                const auto move = random() % 3 == 0 ? HistoryMove::Redo : HistoryMove::Undo;
                const auto one = both[0]->move_in_history(move, slid.ada);
                const auto other = both[1]->move_in_history(move, direct.ada);
                ASSERT_EQ(one.left.undo, other.left.undo) << "seed " << seed;
                ASSERT_EQ(one.left.redo, other.left.redo);
                ASSERT_EQ(one.changes.size(), other.changes.size());
                turns += one.changes.size();
            } else {
                const auto slide = in_gesture(slid.ada, "g" + std::to_string(i));
                const std::size_t moves = 1 + random() % 150;
                for (std::size_t j = 1; j < moves; ++j)
                    ASSERT_TRUE(
                        both[0]->set_rake(rake_at(0.05 * static_cast<double>(j), rake), slide));
                ASSERT_TRUE(both[0]->set_rake(rake_at(-0.1 * i, rake), slide));
                ASSERT_TRUE(both[1]->set_rake(rake_at(-0.1 * i, rake), direct.ada));
            }
            ASSERT_EQ(shown(*both[0]), shown(*both[1])) << "seed " << seed;
        }
    }
    EXPECT_GT(turns, 40u);
}

// A person alone, against a list of what there was before each step.
TEST_F(HistoryTest, AfterAnyEditAndTurnTheDepthIsThatOfTheStepsAPersonCounts) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        std::mt19937_64 random(seed);
        SessionBench other;
        server::Session& mine = *other.session;
        std::vector<std::string> rakes;
        for (int i = 0; i < 3; ++i)
            rakes.push_back(mine.set_rake(rake_at(i))->record.rake);
        std::vector<std::vector<server::Record>> before;
        std::vector<std::vector<server::Record>> undone;
        std::string open; // the gesture that goes on
        for (int i = 0; i < 250; ++i) {
            const auto now = shown(mine);
            if (random() % 5 == 0) {
                const bool back = random() % 3 != 0;
                auto& from = back ? before : undone;
                const auto moved =
                    mine.move_in_history(back ? HistoryMove::Undo : HistoryMove::Redo, other.ada);
                ASSERT_EQ(moved.changes.empty(), from.empty());
                if (!from.empty()) {
                    ASSERT_EQ(shown(mine), from.back()) << "seed " << seed;
                    (back ? undone : before).push_back(now);
                    from.pop_back();
                }
                open.clear();
                ASSERT_EQ(moved.left.undo, before.size());
                ASSERT_EQ(moved.left.redo, undone.size());
                continue;
            }
            const std::string gesture =
                random() % 3 == 0 ? std::string{} : "g" + std::to_string(random() % 2);
            const auto author = in_gesture(other.ada, gesture);
            ASSERT_TRUE(mine.set_rake(rake_at(0.03 * i, rakes[random() % 3]), author));
            undone.clear();
            if (gesture.empty() || gesture != open)
                before.push_back(now);
            if (before.size() > server::limits::undo_steps)
                before.erase(before.begin());
            open = gesture;
        }
    }
}

TEST_F(HistoryTest, SkipsWhatSomebodyElseHasChangedSince) {
    const auto rake = make_rake(bench.ada, 0);
    move(bench.ada, rake, 1);
    move(bench.bob, rake, 2);
    const auto skipped = undo(bench.ada);
    EXPECT_TRUE(skipped.changes.empty());
    ASSERT_EQ(skipped.skipped.size(), 1u);
    EXPECT_EQ(skipped.skipped[0].key.id, rake);
    EXPECT_EQ(skipped.left.undo, 1u) << "the edit is forgotten, the one before is not";
    EXPECT_EQ(x_of(rake), 2);
    EXPECT_EQ(undo(bench.ada).skipped.size(), 1u) << "nor is a rake Bob has moved undone";
    EXPECT_EQ(undo(bench.bob).changes.size(), 1u);
    EXPECT_EQ(x_of(rake), 1);
}

TEST_F(HistoryTest, EvenWhereSomebodyElsePutItBackAsItWas) {
    const auto rake = make_rake(bench.ada, 0);
    move(bench.ada, rake, 1);
    move(bench.bob, rake, 2);
    move(bench.bob, rake, 1);
    EXPECT_TRUE(undo(bench.ada).changes.empty());
    EXPECT_EQ(x_of(rake), 1);
}

TEST_F(HistoryTest, DoesNotTakeARakeFromUnderSomebodyElsesSurface) {
    const auto rake = make_rake(bench.ada);
    const auto surface = session.set_surface(surface_on(rake), bench.bob)->surface;
    const auto skipped = undo(bench.ada);
    ASSERT_EQ(skipped.skipped.size(), 1u);
    EXPECT_NE(skipped.skipped[0].why.find(surface), std::string::npos);
    EXPECT_TRUE(records.get<SurfaceRecord>(surface));
    undo(bench.bob);
    EXPECT_TRUE(records.all<SurfaceRecord>().empty());
    EXPECT_TRUE(records.get<RakeRecord>(rake));
}

TEST_F(HistoryTest, DoesNotHangASurfaceOnARakeThatIsGone) {
    const auto one = make_rake(bench.ada, 0);
    const auto two = make_rake(bench.ada, 1);
    const auto surface = session.set_surface(surface_on(one), bench.ada)->surface;
    ASSERT_TRUE(session.set_surface(surface_on(two, surface), bench.ada));
    ASSERT_TRUE(session.remove({RecordType::Rake, one}, bench.bob));
    EXPECT_EQ(undo(bench.ada).skipped.size(), 1u);
    EXPECT_EQ(records.get<SurfaceRecord>(surface)->rake, two);
}

TEST_F(HistoryTest, IsBoundedInSteps) {
    const auto rake = make_rake(bench.ada, 0);
    for (int i = 0; i < 250; ++i)
        move(bench.ada, rake, 0.01 * i);
    std::size_t undone = 0;
    while (!undo(bench.ada).changes.empty())
        ++undone;
    EXPECT_EQ(undone, server::limits::undo_steps);
    EXPECT_DOUBLE_EQ(x_of(rake), 0.01 * (249 - 100));
}

TEST_F(HistoryTest, IsBoundedInBytesAndTheOldestGoFirst) {
    const std::string view = "{\"v\":\"" + std::string(4000, 'x') + "\"}";
    const std::size_t fit = server::limits::undo_bytes / (2 * view.size());
    std::vector<server::Author> authors;
    for (std::size_t i = 0; i < 2 + 2 * fit / server::limits::undo_steps; ++i)
        authors.push_back({"p" + std::to_string(i), ""});
    for (const auto& author : authors) {
        const auto id = session.set_bookmark(bookmark_of(view))->bookmark;
        for (std::size_t i = 0; i < server::limits::undo_steps; ++i)
            ASSERT_TRUE(session.set_bookmark(bookmark_of(view, id), author));
    }
    std::size_t kept = 0;
    for (const auto& author : authors)
        while (!undo(author).changes.empty())
            ++kept;
    EXPECT_LE(kept, fit);
    EXPECT_GT(kept, fit / 2);
    EXPECT_EQ(redo(authors.front()).left.redo, 0u) << "its edits were the oldest";
    EXPECT_GT(redo(authors.back()).left.redo, 90u);
}

TEST_F(HistoryTest, IsBoundedInAuthors) {
    const auto rake = make_rake(bench.ada);
    for (std::size_t i = 0; i < server::limits::undo_authors; ++i)
        make_rake({"q" + std::to_string(i), ""});
    EXPECT_TRUE(undo(bench.ada).changes.empty());
    EXPECT_EQ(undo({"q0", ""}).changes.size(), 1u);
}

TEST_F(HistoryTest, TheServersOwnDoingIsNobodysToUndo) {
    ASSERT_TRUE(session.set_rake(rake_at(0)));
    EXPECT_TRUE(session.move_in_history(HistoryMove::Undo, {}).changes.empty());
    EXPECT_EQ(records.all<RakeRecord>().size(), 1u);
}

} // namespace wakesurf::tests::history_test
