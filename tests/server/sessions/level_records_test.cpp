// Level surfaces as records of a session: what is checked before they are kept, that they hang on no rake, and that they come back.
#include "core/surface/level/level_source.hpp"
#include "tests/support/server/session_bench.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::level_records_test {
namespace {

using core::Error;

/// Has one field, p, that is 0.
class OneField final : public core::LevelSource {
  public:
    const core::Grid& grid() const override { return grid_; }

    core::Result<std::shared_ptr<const core::NodeValues>>
    values(const std::string&, double, const std::stop_token&) const override {
        return std::make_shared<const core::NodeValues>(
            core::NodeValues{std::vector<float>(8), {0.0, 0.0}});
    }

    core::Result<void> check_field(const std::string& name) const override {
        if (name == "p")
            return {};
        return core::fail(Error::Code::NotFound,
                          "`field` names a field the dataset does not have: " + name);
    }

  private:
    core::Grid grid_ = core::UniformGrid{core::Vec3(0.0), core::Vec3(1.0), {2, 2, 2}};
};

/// The flow `abc` as data with a field.
class WithField final : public Datasets {
  public:
    std::vector<std::string> ids() const override { return {"abc"}; }

    core::Result<OpenDataset> open(const std::string& id) const override {
        return flow_.open(id).map([&](OpenDataset open) {
            open.levels = levels_;
            return open;
        });
    }

  private:
    tests::OneFlow flow_;
    std::shared_ptr<const core::LevelSource> levels_ = std::make_shared<OneField>();
};

struct Bench {
    WithField data;
    tests::HandLoop loop;
    ComputePool pool{1};
    SystemEntropy entropy;
    tests::MemoryJournal journal;
    SessionDirectory sessions{services(data)};
    std::shared_ptr<Session> session = *sessions.find("main");
    const Author ada{"p1", "Ada"};
    std::string rake = session->set_rake(tests::rake_at(1), ada)->record.rake;

    SessionServices services(const Datasets& datasets) {
        SessionServices out{loop, pool, datasets, entropy};
        out.journal = &journal;
        out.clock = &loop;
        return out;
    }

    protocol::SurfaceSetting level(double value, std::optional<std::string> id = {}) const {
        auto setting = tests::surface_on(rake, std::move(id));
        setting.rake.reset();
        setting.parameters.kind = core::SurfaceKind::Level;
        setting.parameters.field = "p";
        setting.parameters.level = value;
        return setting;
    }
};

TEST(LevelRecords, HoldTheirFieldAndLevelThroughUndoAndARestart) {
    Bench bench;
    const auto made = bench.session->set_surface(bench.level(0.25), bench.ada);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->parameters.field, "p");
    EXPECT_EQ(made->parameters.level, 0.25);
    ASSERT_TRUE(bench.session->set_surface(bench.level(0.5, made->surface), bench.ada));
    (void)bench.session->move_in_history(HistoryMove::Undo, bench.ada);
    EXPECT_EQ(
        bench.session->records().get<protocol::SurfaceRecord>(made->surface)->parameters.level,
        0.25);
    const StoredRecords kept = read_entries(bench.journal.entries("main"));
    EXPECT_TRUE(kept.report.refused.empty());
    EXPECT_EQ(kept.records.find<protocol::SurfaceRecord>(made->surface)->parameters,
              made->parameters);
}

TEST(LevelRecords, NeedAFieldThatThereIsAndALevel) {
    const Bench bench;
    auto setting = bench.level(0.25);
    setting.parameters.field = "q";
    EXPECT_EQ(bench.session->set_surface(setting, bench.ada).error().code, Error::Code::NotFound);
    setting.parameters.field.reset();
    EXPECT_EQ(bench.session->set_surface(setting, bench.ada).error().code,
              Error::Code::InvalidArgument);
    setting = bench.level(0.25);
    setting.parameters.level.reset();
    EXPECT_EQ(bench.session->set_surface(setting, bench.ada).error().code,
              Error::Code::InvalidArgument);
    EXPECT_TRUE(bench.session->records().all<protocol::SurfaceRecord>().empty())
        << "nothing was made";
    tests::SessionBench formula;
    setting = bench.level(0.25);
    EXPECT_EQ(formula.session->set_surface(setting, formula.ada).error().code,
              Error::Code::Unsupported);
}

TEST(LevelRecords, StandWithoutAnyRakeAndAreListed) {
    Bench bench;
    ASSERT_TRUE(bench.session->remove({RecordType::Rake, bench.rake}, bench.ada));
    const auto made = bench.session->set_surface(bench.level(0.25), bench.ada);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_EQ(made->rake, std::nullopt);
    EXPECT_EQ(bench.session->records().all<protocol::SurfaceRecord>().count(made->surface), 1U);
    ASSERT_TRUE(bench.session->remove({RecordType::Surface, made->surface}, bench.ada));
    EXPECT_TRUE(bench.session->move_in_history(HistoryMove::Undo, bench.ada).skipped.empty());
    EXPECT_EQ(bench.session->records().all<protocol::SurfaceRecord>().count(made->surface), 1U);
}

TEST(LevelRecords, LeaveOutARakeThatAnOlderClientNamesAlsoWhereItIsGone) {
    const Bench bench;
    auto setting = bench.level(0.25);
    for (const std::string& named : {bench.rake, std::string("r9")}) {
        setting.rake = named;
        const auto made = bench.session->set_surface(setting, bench.ada);
        ASSERT_TRUE(made) << made.error().message;
        EXPECT_EQ(made->rake, std::nullopt);
    }
}

TEST(LevelRecords, AreNotTouchedWhenARakeIsMovedOrDeleted) {
    const Bench bench;
    const auto level = bench.session->set_surface(bench.level(0.25), bench.ada);
    const auto stream = bench.session->set_surface(tests::surface_on(bench.rake), bench.ada);
    const auto epoch = [&](const auto& surface) {
        return bench.session->records().get<protocol::SurfaceRecord>(surface->surface)->epoch;
    };
    const auto before = std::pair(epoch(level), epoch(stream));
    ASSERT_TRUE(bench.session->set_rake(tests::rake_at(2, bench.rake), bench.ada));
    EXPECT_EQ(epoch(level), before.first);
    EXPECT_GT(epoch(stream), before.second);
    ASSERT_TRUE(bench.session->remove({RecordType::Rake, bench.rake}, bench.ada));
    const auto& left = bench.session->records().all<protocol::SurfaceRecord>();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left.begin()->first, level->surface);
}

TEST(LevelRecords, OfAnOlderJournalStandWithoutTheRakeThatTheyHungOn) {
    Bench bench;
    const auto level = bench.session->set_surface(bench.level(0.25), bench.ada);
    for (const bool rake_there : {true, false}) {
        std::vector<JournalEntry> entries = bench.journal.entries("main");
        for (JournalEntry& each : entries)
            if (each.type == "surface")
                each.record->insert(1, "\"rake\":\"" + bench.rake + "\",");
            else if (each.type == "rake" && !rake_there)
                each.record.reset();
        const StoredRecords kept = read_entries(entries);
        EXPECT_TRUE(kept.report.refused.empty());
        const auto* read = kept.records.find<protocol::SurfaceRecord>(level->surface);
        ASSERT_NE(read, nullptr);
        EXPECT_EQ(read->rake, std::nullopt);
    }
}

TEST(LevelRecords, AreTheOnlySurfacesThatNeedNoRake) {
    const Bench bench;
    auto setting = tests::surface_on(bench.rake);
    setting.rake.reset();
    const auto refused = bench.session->set_surface(setting, bench.ada);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Error::Code::InvalidArgument);
    EXPECT_EQ(refused.error().message, "a stream, path, streak or time surface needs `rake`");
}

} // namespace
} // namespace wakesurf::server::level_records_test
