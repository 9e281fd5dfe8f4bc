// A session without sockets: a loop turned by hand, a flow with a closed form.
#include "core/field/analytic_flow.hpp"
#include "server/base/limits.hpp"
#include "server/sessions/records/colours.hpp"
#include "server/sessions/session_directory.hpp"
#include "tests/support/server/hand_loop.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <set>

namespace wakesurf::server::session_test {

namespace {

class OneFlow final : public Datasets {
  public:
    std::vector<std::string> ids() const override { return {"abc"}; }

    core::Result<OpenDataset> open(const std::string& id) const override {
        if (id != "abc")
            return core::fail(core::Error::Code::NotFound, "no dataset " + id);
        auto info = core::describe_analytic_flow("abc");
        return OpenDataset{*info, protocol::lattice_over(info->bounds), flow_};
    }

  private:
    std::shared_ptr<const core::Flow> flow_ = *core::make_analytic_flow("abc");
};

struct Recorder final : Observer {
    void patched(const std::string&,
                 std::uint64_t seq,
                 std::span<const Patch> patches,
                 Telling& telling) override {
        put_into_words(telling);
        seqs.push_back(seq);
        changed.insert(changed.end(), patches.begin(), patches.end());
    }

    void progress(const SurfaceProgress& progress, Telling& telling) override {
        put_into_words(telling);
        phases.emplace_back(progress.epoch, progress.phase);
    }

    void done(const SurfaceOutcome& outcome, Telling& telling) override {
        put_into_words(telling);
        outcomes.push_back(outcome);
    }

    void put_into_words(Telling& telling) {
        if (!telling.text)
            telling.text = std::make_shared<const std::string>("words");
        texts.push_back(telling.text);
    }

    std::vector<std::uint64_t> seqs;
    std::vector<Patch> changed;
    std::vector<SurfaceOutcome> outcomes;
    std::vector<std::pair<std::uint32_t, protocol::Phase>> phases;
    std::vector<std::shared_ptr<const std::string>> texts; ///< of each event
};

protocol::RakeSetting rake_at(double x, std::optional<std::string> id = {}) {
    protocol::RakeSetting setting;
    setting.rake = std::move(id);
    setting.shape.points = {{x, 0, 0}, {x, 2, 0}};
    setting.shape.seeds = 9;
    return setting;
}

protocol::SurfaceSetting surface_on(const std::string& rake) {
    protocol::SurfaceSetting setting;
    setting.rake = rake;
    setting.dataset = "abc";
    setting.parameters.to = 2.0;
    return setting;
}

class SessionTest : public testing::Test {
  protected:
    tests::HandLoop loop;
    ComputePool pool{2};
    OneFlow datasets;
    SystemEntropy entropy;
    SessionDirectory sessions{{loop, pool, datasets, entropy}};
    std::shared_ptr<Session> session = *sessions.find("main");
    Recorder me;

    std::shared_ptr<LiveSurface> build(const std::string& rake) {
        const auto record = session->set_surface(surface_on(rake));
        EXPECT_TRUE(record.has_value()) << record.error().message;
        return *session->live(record->surface);
    }
};

} // namespace

TEST_F(SessionTest, TellsEveryChangeInOrderWithTheNewRecords) {
    ASSERT_TRUE(session->participants().join({"me", "", "", {}}, me));
    const auto rake = session->set_rake(rake_at(0.0));
    ASSERT_TRUE(rake);
    EXPECT_EQ(rake->record.rev, 1u);
    const auto live = build(rake->record.rake);
    const auto moved = session->set_rake(rake_at(1.0, rake->record.rake));
    EXPECT_EQ(moved->record.rev, 2u);
    ASSERT_EQ(moved->surfaces.size(), 1u);
    EXPECT_EQ(moved->surfaces[0].second, 2u) << "the edit begins an epoch";
    ASSERT_TRUE(session->remove({RecordType::Rake, rake->record.rake}));
    EXPECT_EQ(me.seqs, (std::vector<std::uint64_t>{1, 2, 3, 4}));
    ASSERT_EQ(me.changed.size(), 6u);
    EXPECT_EQ(std::get<protocol::SurfaceRecord>(me.changed[3]).epoch, 2u);
    EXPECT_EQ(std::get<DeletedRecord>(me.changed[4]).type, "surface");
    EXPECT_EQ(std::get<DeletedRecord>(me.changed[5]).id, rake->record.rake);
    EXPECT_TRUE(session->records().all<protocol::SurfaceRecord>().empty());
}

TEST_F(SessionTest, BuildsTheSurfaceOfTheNewestEditAndDropsTheOthers) {
    ASSERT_TRUE(session->participants().join({"me", "", "", {}}, me));
    const std::string rake = session->set_rake(rake_at(0.0))->record.rake;
    const auto live = build(rake);
    for (int i = 1; i <= 20; ++i)
        ASSERT_TRUE(session->set_rake(rake_at(0.1 * i, rake)));
    loop.turn_until([&] { return !me.outcomes.empty(); });
    ASSERT_EQ(me.outcomes.size(), 1u);
    EXPECT_EQ(me.outcomes[0].epoch, 21u);
    EXPECT_TRUE(me.outcomes[0].complete);
    for (const auto& [epoch, phase] : me.phases)
        EXPECT_EQ(epoch, 21u);
    EXPECT_EQ(me.phases.back().second, protocol::Phase::Final);
    ASSERT_TRUE(live->newest());
    EXPECT_EQ(live->newest()->wire.epoch, 21u);
    EXPECT_EQ(me.outcomes[0].state_sum, live->newest()->wire.state_sum);
}

TEST_F(SessionTest, GivesRakesTheColoursOfThePaletteInTurnUntilTheyHaveTheirOwn) {
    const Author ada{"p1", "Ada"};
    std::vector<std::string> ids;
    for (std::size_t i = 0; i < palette.size() + 2; ++i) {
        const auto rake = session->set_rake(rake_at(0.1 * static_cast<double>(i)), ada)->record;
        EXPECT_EQ(rake.colour, palette[i % palette.size()]);
        EXPECT_EQ(rake.author, "Ada");
        ids.push_back(rake.rake);
    }
    auto setting = rake_at(0.5, ids[2]);
    setting.colour = "#123456";
    EXPECT_EQ(session->set_rake(setting, {"p2", "Bob"})->record.colour, "#123456");
    const auto moved = session->set_rake(rake_at(0.6, ids[2]), {"p2", "Bob"})->record;
    EXPECT_EQ(moved.colour, "#123456") << "left out, it stays";
    EXPECT_EQ(moved.author, "Ada") << "who made it";
    EXPECT_EQ(session->set_rake(rake_at(0.7))->record.colour, palette[2]) << "no one has it now";
    setting = rake_at(0.8);
    setting.colour = "#E69F00";
    EXPECT_EQ(session->set_rake(setting)->record.colour, "#E69F00");
    EXPECT_EQ(session->set_rake(rake_at(0.9))->record.colour, palette[2])
        << "counts as the palette's";
}

TEST_F(SessionTest, ColouringOrNamingARakeBuildsNothingAnew) {
    const std::string rake = session->set_rake(rake_at(0.0))->record.rake;
    const auto live = build(rake);
    auto setting = rake_at(0.0, rake);
    setting.colour = "#123456";
    const auto coloured = session->set_rake(setting);
    EXPECT_TRUE(coloured->surfaces.empty());
    EXPECT_EQ(coloured->record.rev, 2u);
    EXPECT_EQ(live->epoch(), 1u);
    setting.name = "inlet";
    EXPECT_TRUE(session->set_rake(setting)->surfaces.empty());
    setting.shape.points[0].x = 0.5;
    setting.colour = "#654321";
    EXPECT_EQ(session->set_rake(setting)->surfaces.size(), 1u);
    EXPECT_EQ(live->epoch(), 2u);
}

TEST_F(SessionTest, HangsATimeSurfaceOnBothItsRakes) {
    ASSERT_TRUE(session->participants().join({"me", "", "", {}}, me));
    const std::string one = session->set_rake(rake_at(0.0))->record.rake;
    const std::string two = session->set_rake(rake_at(1.0))->record.rake;
    const std::string other = session->set_rake(rake_at(2.0))->record.rake;
    auto between = surface_on(one);
    between.parameters.kind = core::SurfaceKind::Time;
    between.rake2 = two;
    const auto record = session->set_surface(between);
    ASSERT_TRUE(record) << record.error().message;
    EXPECT_EQ(record->rake2, two);
    EXPECT_FALSE(record->parameters.rake2) << "the record names the rake, the job has its shape";
    const auto live = *session->live(record->surface);
    EXPECT_EQ(live->wanted().plan.parameters.rake2->points.front(), core::Vec3(1, 0, 0));
    EXPECT_TRUE(session->set_rake(rake_at(3.0, other))->surfaces.empty());
    EXPECT_EQ(session->set_rake(rake_at(0.5, one))->surfaces.size(), 1U);
    const auto moved = session->set_rake(rake_at(1.5, two));
    ASSERT_EQ(moved->surfaces.size(), 1U);
    EXPECT_EQ(moved->surfaces[0].second, 3U);
    EXPECT_EQ(live->wanted().plan.rake.points.front(), core::Vec3(0.5, 0, 0));
    EXPECT_EQ(live->wanted().plan.parameters.rake2->points.front(), core::Vec3(1.5, 0, 0));
    loop.turn_until([&] { return !me.outcomes.empty(); });
    EXPECT_FALSE(me.outcomes[0].error);
    EXPECT_TRUE(me.outcomes[0].complete);
    ASSERT_TRUE(session->remove({RecordType::Rake, two}));
    EXPECT_TRUE(session->records().all<protocol::SurfaceRecord>().empty());
    EXPECT_EQ(session->records().all<protocol::RakeRecord>().size(), 2U);
}

TEST_F(SessionTest, CutsTheSecondRakeToTheDomainToo) {
    const std::string one = session->set_rake(rake_at(0.0))->record.rake;
    auto wide = rake_at(0.0);
    wide.shape.points = {{1, 0, 0}, {1, 30, 0}};
    const auto two = session->set_rake(wide)->record;
    EXPECT_TRUE(two.clipped);
    auto between = surface_on(one);
    between.parameters.kind = core::SurfaceKind::Time;
    between.rake2 = two.rake;
    const auto record = session->set_surface(between);
    ASSERT_TRUE(record) << record.error().message;
    const auto live = *session->live(record->surface);
    EXPECT_EQ(live->wanted().plan.parameters.rake2->points.back(), core::Vec3(1, 20, 0));
}

TEST_F(SessionTest, WaitsForTheSurfaceOrForTheTimeToRunOut) {
    const std::string rake = session->set_rake(rake_at(0.0))->record.rake;
    const auto live = build(rake);
    std::vector<core::Result<SurfaceOutcome>> answers;
    const auto keep = [&](core::Result<SurfaceOutcome> outcome) {
        answers.push_back(std::move(outcome));
    };
    live->wait(1, std::chrono::seconds(1), keep);
    loop.turn_until([&] { return !answers.empty(); });
    EXPECT_TRUE(answers[0]->complete);
    live->wait(1, std::chrono::seconds(1), keep);
    ASSERT_EQ(answers.size(), 2u) << "what is complete is answered at once";
    live->wait(7, std::chrono::seconds(1), keep);
    EXPECT_EQ(answers.size(), 2u);
    loop.pass(std::chrono::seconds(1));
    ASSERT_EQ(answers.size(), 3u);
    EXPECT_FALSE(answers[2]->complete) << "epoch 7 is not there";
    live->wait(8, std::chrono::seconds(1), keep);
    ASSERT_TRUE(session->remove({RecordType::Rake, rake}));
    ASSERT_EQ(answers.size(), 4u);
    EXPECT_EQ(answers[3].error().code, core::Error::Code::NotFound);
}

TEST_F(SessionTest, RefusesWhatItHasNotAndWhatIsTooMuch) {
    using Code = core::Error::Code;
    EXPECT_EQ(session->set_rake(rake_at(0.0, "r9")).error().code, Code::NotFound);
    EXPECT_EQ(session->set_surface(surface_on("r9")).error().code, Code::NotFound);
    EXPECT_EQ(session->set_rake(rake_at(100.0)).error().code, Code::OutOfDomain);
    const std::string rake = session->set_rake(rake_at(0.0))->record.rake;
    auto between = surface_on(rake);
    between.parameters.kind = core::SurfaceKind::Time;
    between.rake2 = "r9";
    EXPECT_EQ(session->set_surface(between).error().code, Code::NotFound);
    between.rake2 = rake;
    EXPECT_EQ(session->set_surface(between).error().code, Code::InvalidArgument);
    auto elsewhere = surface_on(rake);
    elsewhere.dataset = "none";
    EXPECT_EQ(session->set_surface(elsewhere).error().code, Code::NotFound);
    EXPECT_TRUE(session->records().all<protocol::SurfaceRecord>().empty());
    for (std::size_t i = 1; i < limits::rakes; ++i)
        ASSERT_TRUE(session->set_rake(rake_at(0.0)));
    EXPECT_EQ(session->set_rake(rake_at(0.0)).error().code, Code::OverLimit);
}

TEST_F(SessionTest, PutsEachEventIntoWordsOnceForAllWhoAreTold) {
    Recorder other;
    ASSERT_TRUE(session->participants().join({"me", "", "", {}}, me));
    ASSERT_TRUE(session->participants().join({"other", "", "", {}}, other));
    const auto live = build(session->set_rake(rake_at(0.0))->record.rake);
    loop.turn_until([&] { return !me.outcomes.empty(); });
    EXPECT_GE(me.texts.size(), 4U) << "rake, surface, at least one phase, done";
    EXPECT_EQ(me.texts, other.texts);
    EXPECT_EQ(std::set(me.texts.begin(), me.texts.end()).size(), me.texts.size())
        << "and other events with other words";
}

TEST_F(SessionTest, GivesAParticipantItsPlaceAgainForItsToken) {
    Recorder other;
    const auto first = session->participants().join({"Ada", "", "", {}}, me);
    session->participants().leave(me);
    EXPECT_TRUE(session->participants().present().empty());
    const auto again = session->participants().join({"", "", first->resume_token, {}}, other);
    EXPECT_EQ(again->you.id, first->you.id);
    EXPECT_EQ(again->you.name, "Ada");
    const auto taken_over = session->participants().join({"", "", first->resume_token, {}}, me);
    EXPECT_EQ(taken_over->you.id, first->you.id);
    EXPECT_EQ(session->participants().present().size(), 1u)
        << "the old connection's place is the new one's";
    EXPECT_NE(session->participants().join({"", "", "no token of ours", {}}, other)->you.id,
              first->you.id);
}

} // namespace wakesurf::server::session_test
