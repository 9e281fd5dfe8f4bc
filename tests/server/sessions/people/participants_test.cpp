// Who is in a session: places that outlive connections, and presence that reaches the others gathered, at most every 50 ms.
#include "server/base/limits.hpp"
#include "server/sessions/people/participants.hpp"
#include "server/sessions/records/colours.hpp"
#include "tests/support/server/hand_clock.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <deque>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::server::participants_test {

using nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::seconds;
namespace member = protocol::member;

namespace {

/// A client that keeps what it is told the way the page does.
class Watcher final : public Observer {
  public:
    explicit Watcher(HandClock& clock) : clock_(clock) {}

    void patched(const std::string&, std::uint64_t, std::span<const Patch>, Telling&) override {}

    void progress(const SurfaceProgress&, Telling&) override {}

    void done(const SurfaceOutcome&, Telling&) override {}

    void presence(const std::string& message) override {
        const json told = json::parse(message);
        EXPECT_EQ(told["method"], "presence.patched");
        for (const json& each : told["params"]["participants"])
            others[each["participant"]].update(each);
        for (const json& each : told["params"]["left"])
            others.erase(each.get<std::string>());
        told_at.push_back(clock_.time);
        messages.push_back(told["params"]);
    }

    void sent_away(Farewell why) override { farewells.push_back(why); }

    std::map<std::string, json> others;
    std::vector<json> messages;
    std::vector<std::chrono::steady_clock::time_point> told_at;
    std::vector<Farewell> farewells;

  private:
    HandClock& clock_;
};

class Disk final : public Journal {
  public:
    void write(const std::string&, std::vector<JournalEntry> entries) override {
        for (const JournalEntry& each : entries)
            records[each.id] = each.record;
    }

    void remove(const std::string&) override {}

    void settled(std::function<void(core::Result<void>)> done) override { done({}); }

    std::map<std::string, std::optional<std::string>> records;
};

struct ParticipantsTest : testing::Test {
    Joined join(Watcher& who,
                const std::string& name = {},
                const std::string& token = {},
                const Identity& identity = {}) {
        return *people.join({name, {}, token, identity}, who);
    }

    /// As the answer to session.join has it.
    static json seen(const protocol::ParticipantRecord& record) {
        return protocol::participant_json(record, member::person | protocol::said(record.presence));
    }

    static protocol::PresenceUpdate pointing(double x) {
        protocol::PresenceUpdate update;
        update.pointer = {true, core::Vec3{x, 0.0, 0.0}};
        return update;
    }

    HandClock clock;
    HandLoop loop{clock};
    SystemEntropy entropy;
    Disk disk;
    std::int64_t now = 1'700'000'000;
    UnixTime unix_time = [this] { return now; };
    Participants people{"main", loop, entropy, &disk, unix_time};
    Watcher ada{clock}, bob{clock}, eve{clock};
};

} // namespace

TEST_F(ParticipantsTest, GivesEverybodyANameAndAColourOfTheirOwn) {
    std::deque<Watcher> watchers;
    std::set<std::string> names;
    std::set<std::string> colours;
    for (std::size_t i = 0; i < palette.size(); ++i) {
        const Joined joined = join(watchers.emplace_back(clock), i % 2 == 0 ? "Ada" : "");
        names.insert(joined.you.name);
        colours.insert(joined.you.colour);
        EXPECT_TRUE(is_colour(joined.you.colour));
    }
    EXPECT_EQ(names.size(), palette.size());
    EXPECT_EQ(colours.size(), palette.size());
    EXPECT_TRUE(names.contains("Ada"));
    EXPECT_TRUE(names.contains("Ada 2"));
    people.leave(watchers.front());
    EXPECT_EQ(join(ada, "Ada").you.name, "Ada");
}

TEST_F(ParticipantsTest, TellsTheOthersOfComingAndGoingAndNobodyOfThemselves) {
    const Joined first = join(ada, "Ada");
    const Joined second = join(bob, "Bob", {}, {Role::Viewer, "main", "g1"});
    EXPECT_TRUE(bob.others.empty());
    loop.advance(limits::presence_rest);
    ASSERT_TRUE(ada.others.contains(second.you.id));
    EXPECT_EQ(ada.others[second.you.id]["name"], "Bob");
    EXPECT_EQ(ada.others[second.you.id]["role"], "viewer");
    EXPECT_EQ(ada.others[second.you.id]["connected"], true);
    people.leave(bob);
    loop.advance(limits::presence_rest);
    EXPECT_TRUE(ada.others.empty());
    EXPECT_FALSE(ada.others.contains(first.you.id));
}

TEST_F(ParticipantsTest, TellsWhoeverIsGivenAnotherRole) {
    join(ada, "Ada");
    const Joined second = join(bob, "Bob", {}, {Role::Editor, "main", "g1"});
    loop.advance(seconds(1));
    bob.messages.clear();
    people.set_role(second.you.id, Role::Viewer);
    loop.advance(limits::presence_rest);
    ASSERT_EQ(bob.messages.size(), 1u);
    EXPECT_EQ(bob.messages[0]["participants"],
              json::array({{{"participant", second.you.id}, {"role", "viewer"}}}));
    EXPECT_EQ(ada.others[second.you.id]["role"], "viewer");
}

TEST_F(ParticipantsTest, TellsTheNewestPresenceAtMostEveryFiftyMilliseconds) {
    join(ada);
    const std::string bob_id = join(bob).you.id;
    loop.advance(seconds(1));
    ada.messages.clear();
    ada.told_at.clear();
    const std::size_t told_to_bob = bob.messages.size();
    for (int i = 1; i <= 1000; ++i) { // a second of a thousand updates
        people.update(bob, pointing(i));
        loop.advance(milliseconds(1));
    }
    loop.advance(limits::presence_rest);
    EXPECT_EQ(ada.others[bob_id]["pointer"], (json{1000.0, 0.0, 0.0}));
    EXPECT_LE(ada.messages.size(), 21u);
    EXPECT_GE(ada.messages.size(), 20u) << "and no less often than it may";
    for (std::size_t i = 1; i < ada.told_at.size(); ++i)
        EXPECT_GE(ada.told_at[i] - ada.told_at[i - 1], limits::presence_rest);
    EXPECT_EQ(bob.messages.size(), told_to_bob) << "no echo";
    EXPECT_EQ(ada.messages.back()["participants"][0].size(), 2u) << "only what changed";
}

TEST_F(ParticipantsTest, SaysAtOnceWhatComesAfterASilence) {
    join(ada);
    const std::string bob_id = join(bob).you.id;
    loop.advance(seconds(1));
    people.update(bob, pointing(7.0));
    EXPECT_EQ(ada.others[bob_id]["pointer"][0], 7.0);
    ada.messages.clear();
    people.update(bob, pointing(7.0));
    loop.advance(seconds(1));
    EXPECT_TRUE(ada.messages.empty()) << "the same again is no news";
}

TEST_F(ParticipantsTest, KeepsEverybodysViewOfTheOthersTheSame) {
    std::deque<Watcher> watchers;
    std::map<Watcher*, std::string> ids;
    std::mt19937 random(7);
    for (int round = 0; round < 2000; ++round) {
        const auto what = random() % 10;
        if (ids.size() < 2 || (what == 0 && ids.size() < 12)) {
            Watcher& fresh = watchers.emplace_back(clock);
            ids[&fresh] = join(fresh, "w").you.id;
            for (const auto& each : people.shown()) // as the answer to session.join does
                if (each.participant != ids[&fresh])
                    fresh.others[each.participant] = seen(each);
        } else {
            auto one = ids.begin();
            std::advance(one, static_cast<std::ptrdiff_t>(random() % ids.size()));
            if (what == 1) {
                random() % 2 == 0 ? people.leave(*one->first) : people.lose(*one->first);
                ids.erase(one);
            } else {
                people.update(*one->first, pointing(static_cast<double>(random() % 5)));
            }
        }
        loop.advance(milliseconds(random() % 40));
    }
    loop.advance(seconds(11));
    for (const auto& [watcher, id] : ids) {
        std::map<std::string, json> others;
        for (const auto& each : people.shown())
            if (each.participant != id)
                others[each.participant] = seen(each);
        EXPECT_EQ(watcher->others, others) << id;
    }
}

TEST_F(ParticipantsTest, ShowsALostConnectionForTenSecondsAndAQuickReturnIsNoNews) {
    join(ada);
    const Joined before = join(bob, "Bob");
    people.update(bob, pointing(3.0));
    loop.advance(seconds(1));
    people.lose(bob);
    loop.advance(milliseconds(9'900));
    EXPECT_EQ(ada.others.at(before.you.id)["connected"], false);
    EXPECT_EQ(people.present().size(), 1u);
    EXPECT_EQ(people.shown().size(), 2u);
    const Joined again = join(eve, {}, before.resume_token);
    EXPECT_TRUE(again.returned);
    EXPECT_EQ(again.you.id, before.you.id);
    EXPECT_EQ(again.you.name, "Bob");
    EXPECT_EQ(again.you.colour, before.you.colour);
    loop.advance(seconds(1));
    EXPECT_EQ(ada.others.at(before.you.id)["connected"], true);
    EXPECT_EQ(ada.others.at(before.you.id)["pointer"][0], 3.0);
    people.lose(eve);
    loop.advance(milliseconds(10'100));
    EXPECT_TRUE(ada.others.empty());
    EXPECT_TRUE(join(bob, {}, before.resume_token).returned) << "its place is kept for longer";
    EXPECT_FALSE(people.shown().back().presence.pointer);
}

TEST_F(ParticipantsTest, LetsTheNewerOfTwoConnectionsWinAndTellsTheOlder) {
    join(ada);
    const Joined before = join(bob);
    loop.advance(seconds(1));
    const Joined again = join(eve, {}, before.resume_token);
    EXPECT_EQ(again.you.id, before.you.id);
    EXPECT_EQ(bob.farewells, std::vector{Farewell::Displaced});
    people.lose(bob); // its connection closes now; that is not the end of the newer one
    EXPECT_EQ(people.present().size(), 2u);
    loop.advance(seconds(20));
    EXPECT_EQ(ada.others.at(before.you.id)["connected"], true);
    join(eve, {}, again.resume_token);
    EXPECT_TRUE(eve.farewells.empty()) << "no one displaces themselves";
}

TEST_F(ParticipantsTest, SetsARoleThatStaysWithThePlaceButNotWithAnotherLink) {
    const Identity link{Role::Viewer, "main", "g1"};
    const Joined before = join(bob, {}, {}, link);
    join(ada);
    people.set_role(before.you.id, Role::Editor);
    loop.advance(seconds(1));
    EXPECT_EQ(ada.others.at(before.you.id)["role"], "editor");
    EXPECT_EQ(people.find(bob)->role, Role::Editor);
    people.lose(bob);
    EXPECT_EQ(join(bob, {}, before.resume_token, link).you.role, Role::Editor);
    people.lose(bob);
    const Identity another{Role::Viewer, "main", "g2"};
    EXPECT_EQ(join(eve, {}, before.resume_token, another).you.role, Role::Viewer);
}

TEST_F(ParticipantsTest, BringsARoleThatWasSetThroughARestart) {
    const Identity link{Role::Viewer, "main", "g1"};
    const Joined before = join(bob, "Bob", {}, link);
    join(ada);
    people.set_role(before.you.id, Role::Editor);
    const std::string kept = *disk.records.at(before.you.id);
    EXPECT_EQ(kept.find(before.resume_token), std::string::npos);
    Participants after("main", loop, entropy, &disk);
    ASSERT_TRUE(after.restore(before.you.id, kept));
    EXPECT_TRUE(after.shown().empty());
    const Joined again = *after.join({{}, {}, before.resume_token, link}, eve);
    EXPECT_EQ(again.you.id, before.you.id);
    EXPECT_EQ(again.you.name, "Bob");
    EXPECT_EQ(again.you.role, Role::Editor);
    Watcher fresh(clock);
    EXPECT_NE(after.join({}, fresh)->you.id, before.you.id);
    EXPECT_FALSE(after.restore("p9", "{}"));
    EXPECT_FALSE(after.restore("nine", kept));
}

TEST_F(ParticipantsTest, BringsEverybodysPlaceThroughARestartWithoutKeepingATokenOfIt) {
    const Identity link{Role::Editor, "main", "g1"};
    const Joined first = join(ada, "Ada");
    const Joined second = *people.join({"Bob", "#123456", {}, link}, bob);
    people.lose(bob); // one is connected when the server ends, the other has just gone
    Participants after("main", loop, entropy, &disk, unix_time);
    for (const auto& [id, record] : std::map(disk.records)) {
        ASSERT_TRUE(record);
        for (const Joined* each : {&first, &second})
            EXPECT_EQ(record->find(each->resume_token), std::string::npos);
        EXPECT_TRUE(after.restore(id, *record));
    }
    EXPECT_TRUE(after.shown().empty()) << "no one is here yet";
    Watcher ada_again(clock), bob_again(clock), stranger(clock);
    const Joined back = *after.join({{}, {}, second.resume_token, link}, bob_again);
    EXPECT_TRUE(back.returned);
    EXPECT_EQ(back.you.id, second.you.id) << "and so what is undone, leased and said stays theirs";
    EXPECT_EQ(back.you.name, "Bob");
    EXPECT_EQ(back.you.colour, "#123456");
    EXPECT_EQ(back.you.role, Role::Editor);
    const Identity viewer{Role::Viewer, "main", "g2"};
    EXPECT_EQ(after.join({{}, {}, second.resume_token, viewer}, bob_again)->you.role, Role::Viewer)
        << "the role is the link's, not the place's";
    EXPECT_EQ(after.join({{}, {}, first.resume_token, {}}, ada_again)->you.name, "Ada");
    EXPECT_FALSE(after.join({{}, {}, "guessed", {}}, stranger)->returned);
}

TEST_F(ParticipantsTest, GivesAnotherTokenAfterARestartAndTakesTheOldOneUntilThatIsUsed) {
    const Joined before = join(ada);
    EXPECT_TRUE(join(ada, {}, before.resume_token).same_life);
    const auto restart = [&](Participants& after) {
        for (const auto& [id, record] : std::map(disk.records))
            EXPECT_TRUE(after.restore(id, *record));
    };
    Participants second("main", loop, entropy, &disk, unix_time);
    restart(second);
    const Joined lost = *second.join({{}, {}, before.resume_token, {}}, ada); // its answer is
    EXPECT_NE(lost.resume_token, before.resume_token);
    EXPECT_FALSE(lost.same_life) << "what it remembers was told by another server";
    Participants third("main", loop, entropy, &disk, unix_time);
    restart(third);
    const Joined back = *third.join({{}, {}, before.resume_token, {}}, bob);
    EXPECT_EQ(back.you.id, before.you.id);
    EXPECT_FALSE(back.same_life);
    const Joined again = *third.join({{}, {}, before.resume_token, {}}, eve);
    EXPECT_EQ(again.you.id, before.you.id);
    EXPECT_FALSE(again.same_life) << "it has not got what the one before was told";
    const Joined known = *third.join({{}, {}, again.resume_token, {}}, bob);
    EXPECT_TRUE(known.same_life);
    EXPECT_EQ(known.resume_token, again.resume_token);
    EXPECT_FALSE(third.join({{}, {}, before.resume_token, {}}, ada)->returned)
        << "it has done its duty";
}

TEST_F(ParticipantsTest, ForgetsWhoHasNotComeBackForAWeekAndSoDoesTheDisk) {
    const auto week = limits::place_kept.count();
    const Joined early = join(ada), late = join(bob);
    people.leave(ada);
    now += week / 2;
    people.leave(bob);
    now += week / 2 + 1;
    Participants after("main", loop, entropy, &disk, unix_time);
    for (const auto& [id, record] : std::map(disk.records))
        EXPECT_TRUE(after.restore(id, *record));
    EXPECT_EQ(disk.records.at(early.you.id), std::nullopt);
    EXPECT_TRUE(disk.records.at(late.you.id));
    EXPECT_FALSE(after.join({{}, {}, early.resume_token, {}}, ada)->returned);
    EXPECT_TRUE(after.join({{}, {}, late.resume_token, {}}, bob)->returned);
    now += 2 * week;
    join(eve);
    people.leave(eve);
    EXPECT_FALSE(join(eve, {}, late.resume_token).returned) << "a server that runs forgets as well";
}

TEST_F(ParticipantsTest, KeepsNoMorePlacesOnTheDiskThanTheLimit) {
    for (std::size_t i = 0; i < limits::participants + 50; ++i) {
        join(ada);
        people.leave(ada);
    }
    const auto kept = std::count_if(disk.records.begin(), disk.records.end(),
                                    [](const auto& each) { return each.second.has_value(); });
    EXPECT_EQ(kept, static_cast<std::ptrdiff_t>(limits::participants));
}

TEST_F(ParticipantsTest, LetsWhoComesAndGoesByOneLinkTakeNobodyElsesPlace) {
    const Joined by_other_link = *people.join({"Ada", {}, {}, {Role::Editor, "main", "g2"}}, ada);
    people.leave(ada);
    const Joined by_token = join(bob);
    people.leave(bob);
    Joined first;
    for (std::size_t i = 0; i < limits::participants; ++i) {
        loop.advance(seconds(1));
        const Joined joined = *people.join({{}, {}, {}, {Role::Viewer, "main", "g1"}}, eve);
        if (i == 0)
            first = joined;
        people.leave(eve);
    }
    EXPECT_FALSE(people.find(first.you.id));
    EXPECT_TRUE(people.find(by_other_link.you.id));
    EXPECT_TRUE(people.find(by_token.you.id));
}

TEST_F(ParticipantsTest, KeepsTheLastPlacesForThoseWithTheServersToken) {
    std::deque<Watcher> watchers;
    const auto come = [&](const std::string& grant) {
        return people.join({{}, {}, {}, {Role::Host, "main", grant}}, watchers.emplace_back(clock))
            .has_value();
    };
    for (std::size_t i = 0; i < limits::participants - limits::for_hosts.sockets; ++i)
        ASSERT_TRUE(come("g1"));
    EXPECT_FALSE(come("g1"));
    for (std::size_t i = 0; i < limits::for_hosts.sockets; ++i)
        ASSERT_TRUE(come(""));
    EXPECT_FALSE(come(""));
}

TEST_F(ParticipantsTest, RemovesSomebodyForGood) {
    join(ada);
    const Joined before = join(bob);
    people.set_role(before.you.id, Role::Viewer);
    loop.advance(seconds(1));
    people.remove(before.you.id);
    EXPECT_EQ(bob.farewells, std::vector{Farewell::Removed});
    EXPECT_EQ(disk.records.at(before.you.id), std::nullopt);
    loop.advance(seconds(1));
    EXPECT_TRUE(ada.others.empty());
    EXPECT_EQ(people.find(before.you.id).error().code, core::Error::Code::NotFound);
    EXPECT_NE(join(bob, {}, before.resume_token).you.id, before.you.id);
}

TEST_F(ParticipantsTest, LimitsHowManyThereAreAndLetsThoseWhoAreHereComeBackAllTheSame) {
    std::deque<Watcher> watchers;
    Joined last;
    for (std::size_t i = 0; i < limits::participants; ++i)
        last = join(watchers.emplace_back(clock));
    EXPECT_EQ(people.join({}, ada).error().code, core::Error::Code::OverLimit);
    EXPECT_TRUE(people.join({{}, {}, last.resume_token, {}}, ada));
    EXPECT_EQ(people.present().size(), limits::participants);
}

TEST_F(ParticipantsTest, TellsLessOftenWhereManyWouldHaveToBeToldOfMany) {
    std::deque<Watcher> watchers;
    for (std::size_t i = 0; i < 64; ++i)
        join(watchers.emplace_back(clock));
    loop.advance(seconds(2));
    for (Watcher& each : watchers)
        each.messages.clear();
    protocol::PresenceUpdate update; // an entry of 1 KB: told every 50 ms, 80 MB a second
    update.dragging = {true, {{"", std::vector<core::Vec3>(limits::presence_points)}}};
    for (int step = 0; step < 100; ++step) {
        update.dragging.value->rake = "r" + std::to_string(step);
        for (Watcher& each : watchers)
            people.update(each, update);
        loop.advance(milliseconds(10));
    }
    std::size_t bytes = 0;
    for (const Watcher& each : watchers)
        for (const json& message : each.messages)
            bytes += message.dump().size();
    EXPECT_GT(bytes, 0u);
    EXPECT_LT(bytes, 3 * 1000 * limits::presence_bytes_per_ms);
    loop.advance(seconds(3));
    EXPECT_EQ(watchers.front().others.size(), 63u);
    for (const auto& [id, other] : watchers.front().others)
        EXPECT_EQ(other["dragging"]["rake"], "r99") << id;
}

} // namespace wakesurf::server::participants_test
