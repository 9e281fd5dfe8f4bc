// What sessions leave behind in the memory of the process once they are gone for good: nothing.
#include "tests/support/server/counted_heap.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace wakesurf::tests::session_heap_test {

namespace {

using namespace std::chrono_literals;
using core::SurfaceKind;

/// A person makes a session, edits, takes an edit back, and deletes the session for good.
void use_a_session(SessionBench& bench) {
    const auto session = *bench.sessions.create("used");
    const std::string id = session->id();
    Onlooker onlooker;
    const auto joined = session->join({}, onlooker);
    ASSERT_TRUE(joined);
    const auto rake = session->set_rake(rake_at(0), bench.ada);
    ASSERT_TRUE(rake);
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Streak}) {
        auto setting = surface_on(rake->record.rake);
        setting.parameters.kind = kind;
        const auto surface = session->set_surface(setting, bench.ada);
        ASSERT_TRUE(surface);
        const auto live = *session->live(surface->surface);
        bool complete = false;
        live->wait(live->epoch(), 1min, [&](const auto& outcome) { complete = outcome->complete; });
        bench.loop.turn_until([&] { return complete; });
    }
    ASSERT_TRUE(session->set_bookmark(bookmark_of("{}"), bench.ada));
    session->move_in_history(server::HistoryMove::Undo, bench.ada);
    session->leave(onlooker);
    ASSERT_TRUE(bench.sessions.remove(id));
    ASSERT_TRUE(bench.sessions.erase(id));
    bench.loop.pass(1min); // for timers
}

} // namespace

TEST(SessionHeap, KeepsNothingOfSessionsThatWereErased) {
    SessionBench bench;
    for (int i = 0; i < 10; ++i)
        use_a_session(bench);
    const std::size_t before = held_on_heap();
    constexpr std::size_t sessions = 50;
    for (std::size_t i = 0; i < sessions; ++i)
        use_a_session(bench);
    const std::size_t after = held_on_heap();
    // How long each computed lately is remembered for some minutes, for its turn among others.
    EXPECT_LT(after - std::min(after, before), sessions * 1024) << "bytes, of so many sessions";
}

} // namespace wakesurf::tests::session_heap_test
