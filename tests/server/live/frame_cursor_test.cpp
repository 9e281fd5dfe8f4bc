// Subscriptions reading one ring: fast ones, slow ones, ones that come back.
#include "server/base/limits.hpp"
#include "server/live/frame_cursor.hpp"
#include "tests/server/live/sample_updates.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>

#include <random>

namespace wakesurf::server::frame_cursor_test {

namespace {

class Cursors : public testing::Test {
  protected:
    /// A ring whose keyframes are made at once, and counted.
    std::shared_ptr<UpdateRing> make_ring() {
        auto made = std::make_shared<UpdateRing>(7, clock, [this] {
            ++keys_made;
            if (make_keys)
                make_key();
        });
        made->begin(1);
        return made;
    }

    void make_key() {
        const auto& newest = ring->newest()->wire;
        ring->add_key(make_update({newest.epoch, newest.seq, true, 2}));
    }

    FrameCursor cursor(std::optional<UpdatePosition> from = {}) {
        return FrameCursor(
            ring, from, [this](bool behind) { notices.push_back(behind); },
            [this](std::uint64_t frames) { left_out += frames; });
    }

    void add(std::uint32_t seq, bool key = false, std::size_t frames = 1, std::size_t bytes = 3) {
        ring->add(make_update({ring->epoch(), seq, key, frames, bytes}));
    }

    /// Everything there is to read.
    static std::vector<Seen> drain(FrameCursor& cursor) {
        std::vector<Seen> all;
        for (int idle = 0; idle < 2; ++idle) // the first look may have asked for a keyframe
            while (const auto frame = cursor.next())
                all.push_back(seen(frame));
        return all;
    }

    HandClock clock;
    int keys_made = 0;
    bool make_keys = true;
    std::vector<bool> notices;
    std::uint64_t left_out = 0; ///< frames
    std::shared_ptr<UpdateRing> ring = make_ring();
};

using Frames = std::vector<Seen>;

} // namespace

TEST_F(Cursors, ReadsEveryUpdateOnceAndInOrder) {
    FrameCursor reader = cursor();
    EXPECT_EQ(seen(reader.next()), Seen{});
    add(0, true, 2);
    EXPECT_EQ(drain(reader), (Frames{{0, 0, true}, {0, 1, true}}));
    add(1);
    add(2, false, 2);
    EXPECT_EQ(drain(reader), (Frames{{1, 0, false}, {2, 0, false}, {2, 1, false}}));
    EXPECT_TRUE(notices.empty());
    EXPECT_EQ(keys_made, 0);
}

TEST_F(Cursors, SkipsToTheNewestKeyButShowsANewEpochsFirst) {
    FrameCursor reader = cursor();
    add(0, true);
    drain(reader);
    ring->begin(2);
    add(0, true);
    add(1, true);
    add(2, true);
    EXPECT_EQ(drain(reader), (Frames{{0, 0, true}, {2, 0, true}}))
        << "the coarse state, then the final one";
    EXPECT_TRUE(notices.empty());
}

TEST_F(Cursors, LeavesTheRestOfAnUpdateWhenTheEpochIsOver) {
    FrameCursor reader = cursor();
    add(0, true, 3);
    EXPECT_EQ(seen(reader.next()), (Seen{0, 0, true}));
    ring->begin(2);
    EXPECT_EQ(seen(reader.next()), Seen{});
    add(0, true);
    EXPECT_EQ(drain(reader), (Frames{{0, 0, true}}));
}

TEST_F(Cursors, FinishesAnUpdateThatHasLeftTheRingMeanwhile) {
    FrameCursor reader = cursor();
    add(0, true, 3);
    reader.next();
    add(1);
    clock.time += 2 * limits::ring_age;
    add(2);
    EXPECT_EQ(seen(reader.next()), (Seen{0, 1, true}));
    EXPECT_EQ(seen(reader.next()), (Seen{0, 2, true}));
    EXPECT_EQ(drain(reader), (Frames{{2, 0, true}, {2, 1, true}})) << "update 1 is gone: a key";
}

TEST_F(Cursors, GivesOneKeyframeToAllWhoseNextUpdateIsGone) {
    FrameCursor fast = cursor(), slow = cursor(), stalled = cursor();
    add(0, true);
    for (FrameCursor* each : {&fast, &slow, &stalled})
        drain(*each);
    for (std::uint32_t seq = 1; seq <= 20; ++seq) {
        clock.time += std::chrono::seconds(1);
        add(seq);
        EXPECT_EQ(drain(fast), (Frames{{static_cast<int>(seq), 0, false}}));
    }
    EXPECT_TRUE(notices.empty()) << "the fast one notices nothing";
    const Frames key{{20, 0, true}, {20, 1, true}};
    EXPECT_EQ(drain(slow), key);
    EXPECT_EQ(drain(stalled), key);
    EXPECT_EQ(keys_made, 1);
    EXPECT_EQ(notices, (std::vector<bool>{true, false, true, false}));
    add(21);
    for (FrameCursor* each : {&fast, &slow, &stalled})
        EXPECT_EQ(drain(*each), (Frames{{21, 0, false}}));
}

TEST_F(Cursors, WaitsForItsKeyframeAndIsWokenByIt) {
    make_keys = false;
    add(0, true);
    add(1, false, 1, limits::behind_bytes + 1);
    int woken = 0;
    FrameCursor reader = cursor();
    reader.wake_by([&] { ++woken; });
    EXPECT_EQ(drain(reader), Frames{});
    EXPECT_EQ(drain(reader), Frames{});
    EXPECT_EQ(keys_made, 1) << "asked for once";
    add(2);
    EXPECT_EQ(woken, 1);
    make_key();
    EXPECT_EQ(woken, 2);
    EXPECT_EQ(drain(reader), (Frames{{2, 0, true}, {2, 1, true}}));
    EXPECT_TRUE(notices.empty()) << "who has just come has not fallen behind";
}

TEST_F(Cursors, FollowsUpdatesThatCameWhileItsKeyframeWasMade) {
    make_keys = false;
    add(0, true);
    for (std::uint32_t seq = 1; seq <= 12; ++seq)
        add(seq);
    FrameCursor reader = cursor();
    EXPECT_EQ(drain(reader), Frames{});
    make_key();
    for (std::uint32_t seq = 13; seq <= 30; ++seq)
        add(seq); // encoding took long: the key is far behind, but it has only just come
    const Frames got = drain(reader);
    ASSERT_EQ(got.size(), 20U);
    EXPECT_EQ(got.front(), (Seen{12, 0, true}));
    EXPECT_EQ(got.back(), (Seen{30, 0, false}));
    EXPECT_EQ(keys_made, 1);
}

TEST_F(Cursors, NeverSendsTheSameKeyframeAgainWhenItIsFarBehindAtOnce) {
    add(0, true);
    FrameCursor reader = cursor();
    drain(reader);
    add(1, false, 1, limits::behind_bytes + 1);
    make_keys = false;
    EXPECT_EQ(drain(reader), Frames{});
    make_key();
    add(2, false, 1, limits::behind_bytes + 1);
    EXPECT_EQ(drain(reader), (Frames{{1, 0, true}, {1, 1, true}}));
    EXPECT_EQ(keys_made, 2) << "one of a newer state";
    make_key();
    EXPECT_EQ(drain(reader), (Frames{{2, 0, true}, {2, 1, true}}));
}

TEST_F(Cursors, FallsBehindWhenMoreBytesWaitThanAKeyframeHas) {
    FrameCursor reader = cursor();
    add(0, true);
    drain(reader);
    add(1, false, 1, limits::behind_bytes / 2);
    add(2, false, 1, limits::behind_bytes / 2);
    FrameCursor other = reader;
    EXPECT_EQ(drain(other).size(), 2U);
    add(3, false, 1, 100);
    EXPECT_EQ(drain(reader), (Frames{{3, 0, true}, {3, 1, true}}));
    EXPECT_EQ(notices, (std::vector<bool>{true, false}));
}

TEST_F(Cursors, SendsNoMoreThanTheWindowToWhoAcknowledges) {
    FrameCursor reader = cursor();
    add(0, true);
    drain(reader);
    reader.acknowledge({1, 0});
    std::size_t sent = 0;
    for (std::uint32_t seq = 1; seq <= 20; ++seq) {
        add(seq);
        sent += drain(reader).size();
    }
    EXPECT_EQ(sent, limits::window);
    EXPECT_EQ(notices, std::vector<bool>{true});
    reader.acknowledge({1, limits::window / 2});
    EXPECT_EQ(drain(reader), Frames{}) << "a keyframe is worth it only with room to go on";
    reader.acknowledge({1, limits::window / 2 + 1});
    EXPECT_EQ(drain(reader), (Frames{{20, 0, true}, {20, 1, true}}));
    EXPECT_EQ(notices, (std::vector<bool>{true, false}));
}

TEST_F(Cursors, GoesOnWhereAnEarlierConnectionEnded) {
    add(0, true);
    for (std::uint32_t seq = 1; seq <= 3; ++seq)
        add(seq);
    FrameCursor back = cursor(UpdatePosition{1, 1});
    EXPECT_TRUE(back.resumed());
    EXPECT_EQ(drain(back), (Frames{{2, 0, false}, {3, 0, false}}));
    FrameCursor up_to_date = cursor(UpdatePosition{1, 3});
    EXPECT_TRUE(up_to_date.resumed());
    EXPECT_EQ(drain(up_to_date), Frames{});
    for (const UpdatePosition stranger : {UpdatePosition{2, 1}, UpdatePosition{1, 4}}) {
        FrameCursor anew = cursor(stranger);
        EXPECT_FALSE(anew.resumed());
        EXPECT_TRUE(drain(anew).front().key);
    }
    clock.time += 2 * limits::ring_age;
    add(4);
    FrameCursor late = cursor(UpdatePosition{1, 1});
    EXPECT_FALSE(late.resumed());
    EXPECT_EQ(drain(late), (Frames{{4, 0, true}, {4, 1, true}}));
}

TEST_F(Cursors, CountTheStaleFramesThatAKeyframeReplaces) {
    FrameCursor fast = cursor(), slow = cursor();
    add(0, true, 2);
    drain(fast);
    drain(slow);
    for (std::uint32_t seq = 1; seq <= 20; ++seq) {
        clock.time += std::chrono::seconds(1);
        add(seq, false, 3);
        drain(fast);
    }
    EXPECT_EQ(left_out, 0U) << "the fast one has had all";
    EXPECT_EQ(drain(slow).size(), 2U);
    EXPECT_EQ(left_out, 20U * 3U) << "all that lead to the state of the keyframe";
    FrameCursor late = cursor();
    drain(late);
    EXPECT_EQ(left_out, 20U * 3U) << "who has just come has missed nothing";
    FrameCursor back = cursor(UpdatePosition{1, 18});
    drain(back);
    EXPECT_EQ(left_out, 20U * 3U) << "nor has who comes back in time";
}

TEST_F(Cursors, CountTheStaleFramesThatANewerEditReplaces) {
    FrameCursor reader = cursor();
    add(0, true, 4);
    reader.next();
    add(1, false, 2);
    ring->begin(2);
    reader.next();
    EXPECT_EQ(left_out, 3U) << "the rest of the update that was being sent";
    add(0, true);
    drain(reader);
    EXPECT_EQ(left_out, 5U) << "and the next one";
}

TEST_F(Cursors, SendOrLeaveOutEveryFrame) {
    std::mt19937 random(5);
    for (int run = 0; run < 100; ++run) {
        ring = make_ring();
        left_out = 0;
        FrameCursor reader = cursor();
        add(0, true);
        std::uint64_t added = 1, sent = drain(reader).size();
        for (std::uint32_t epoch = 2; epoch < 12; ++epoch) {
            ring->begin(epoch);
            for (std::uint32_t seq = 0; seq < 5; ++seq) {
                const std::size_t frames = 1 + random() % 3;
                add(seq, seq == 0 || random() % 4 == 0, frames);
                added += frames;
                for (auto turns = random() % 6; turns > 0; --turns)
                    sent += reader.next() ? 1 : 0;
            }
        }
        sent += drain(reader).size();
        EXPECT_EQ(sent + left_out, added) << "run " << run;
    }
    EXPECT_EQ(keys_made, 0) << "one made on request would be one more";
}

TEST_F(Cursors, ReadsNothingOfAClosedRing) {
    FrameCursor reader = cursor();
    add(0, true, 2);
    reader.next();
    ring->close();
    EXPECT_EQ(seen(reader.next()), Seen{});
    add(1, true);
    EXPECT_EQ(seen(reader.next()), Seen{});
}

TEST_F(Cursors, AlwaysSendsWhatCanBeFoldedAndEndsAtTheNewest) {
    std::mt19937 random(11);
    for (int run = 0; run < 200; ++run) {
        ring = make_ring();
        FrameCursor reader = cursor();
        std::uint32_t seq = 0;
        int state = -1; // the client's: which update it holds
        bool first = true;
        for (int step = 0; step < 200; ++step) {
            switch (random() % 8) {
            case 0:
                ring->begin(ring->epoch() + 1);
                seq = 0;
                state = -1;
                break;
            case 1:
                clock.time += std::chrono::milliseconds(random() % 3000);
                break;
            case 2:
                if (state >= 0 && run % 2 == 0)
                    reader.acknowledge({ring->epoch(), static_cast<std::uint32_t>(state)});
                break;
            case 3:
            case 4:
                add(seq, seq == 0 || random() % 6 == 0, 1 + random() % 3, 3 + random() % 999'999);
                ++seq;
                break;
            default:
                if (const Seen got = seen(reader.next()); got.seq >= 0) {
                    if (got.frame == 0) {
                        ASSERT_TRUE(got.key || got.seq == state + 1);
                        ASSERT_GE(got.seq, state);
                    }
                    state = got.seq; // by the next first frame it is whole, or the epoch is over
                    first = false;
                }
            }
        }
        if (!first && ring->newest()) {
            for (std::uint32_t each = 0; run % 2 == 0 && each <= ring->newest()->wire.seq; ++each)
                reader.acknowledge({ring->epoch(), each});
            const Frames rest = drain(reader);
            const int end = rest.empty() ? state : rest.back().seq;
            EXPECT_EQ(end, static_cast<int>(ring->newest()->wire.seq));
        }
    }
}

TEST_F(Cursors, KeepsTheRingWithinItsBytesAndAge) {
    for (std::uint32_t seq = 0; seq < 100; ++seq)
        add(seq, seq == 0, 1, 1U << 20);
    EXPECT_LE(ring->bytes(), limits::ring_bytes);
    EXPECT_GT(ring->bytes(), limits::ring_bytes - (2U << 20));
    clock.time += 2 * limits::ring_age;
    ring->trim();
    EXPECT_EQ(ring->bytes(), 1U << 20) << "the newest stays";
    ring->begin(2);
    EXPECT_EQ(ring->bytes(), 0U);
}

} // namespace wakesurf::server::frame_cursor_test
