// The table of surface_stage.hpp, row by row: every event in every stage.
#include "tests/server/live/live_surface_fixture.hpp"

#include <functional>
#include <map>
#include <string>
#include <tuple>

namespace wakesurf::server::surface_stage_test {

using std::chrono::milliseconds;

namespace {

using Stage = SurfaceStage;

/// Says of a row of the table in surface_stage.hpp what happens and where it leads. Stages without a row
/// stay as they are.
struct Event {
    const char* name;
    std::function<void(LiveSurface&)> happen;
    std::map<Stage, Stage> leads;
};

constexpr Stage all_stages[]{Stage::Withheld, Stage::Refused,     Stage::Failed,
                             Stage::Resting,  Stage::Interrupted, Stage::Begun,
                             Stage::Coarse,   Stage::Refined,     Stage::Full};

std::map<Stage, Stage> from_any(Stage to) {
    std::map<Stage, Stage> leads;
    for (const Stage stage : all_stages)
        leads[stage] = to;
    return leads;
}

SurfaceJob slow_job() {
    return job_of(core::SurfaceKind::Stream, 0.02);
}

const core::Error stopped{core::Error::Code::Cancelled, "stopped", ""};
const core::Error missing{core::Error::Code::NotFound, "the data are missing", ""};

const Event events[]{
    {"rebuild", [](LiveSurface& it) { it.rebuild(slow_job()); }, from_any(Stage::Begun)},
    {"rebuild_at_rest", [](LiveSurface& it) { it.rebuild(slow_job(), true); },
     from_any(Stage::Resting)},
    {"refuse", [](LiveSurface& it) { it.refuse(core::SurfaceKind::Stream, missing); },
     from_any(Stage::Refused)},
    {"refuse_at_rest", [](LiveSurface& it) { it.refuse(core::SurfaceKind::Stream, missing, true); },
     from_any(Stage::Withheld)},
    {"begin_now",
     [](LiveSurface& it) { it.begin_now(); },
     {{Stage::Resting, Stage::Begun},
      {Stage::Interrupted, Stage::Begun},
      {Stage::Failed, Stage::Begun},
      {Stage::Withheld, Stage::Refused}}},
    {"resume", [](LiveSurface& it) { it.resume(); }, {{Stage::Interrupted, Stage::Begun}}},
    {"fall_back",
     [](LiveSurface& it) { it.fall_back(); },
     {{Stage::Begun, Stage::Resting},
      {Stage::Coarse, Stage::Resting},
      {Stage::Refined, Stage::Resting},
      {Stage::Full, Stage::Resting}}},
    {"put_to_rest",
     [](LiveSurface& it) { it.put_to_rest(); },
     {{Stage::Begun, Stage::Interrupted},
      {Stage::Coarse, Stage::Interrupted},
      {Stage::Refined, Stage::Interrupted},
      {Stage::Full, Stage::Resting}}},
    {"stop",
     [](LiveSurface& it) { it.stop(stopped); },
     {{Stage::Resting, Stage::Refused},
      {Stage::Interrupted, Stage::Refused},
      {Stage::Begun, Stage::Refused},
      {Stage::Coarse, Stage::Refused},
      {Stage::Refined, Stage::Refused}}},
    {"retire", [](LiveSurface& it) { it.retire(); }, from_any(Stage::Refused)},
};

class SurfaceStages : public LiveSurfaceTest,
                      public testing::WithParamInterface<std::tuple<Stage, Event>> {
  protected:
    /// Leads the surface, which is new, to a stage.
    void lead_to(Stage stage) {
        wall.each = milliseconds(10);
        if (stage == Stage::Failed)
            surface = std::make_shared<LiveSurface>(
                "s1", 3, "main",
                LiveSurface::Services{loop, pool, wall, nullptr, {&no_memory, &no_histories}},
                LiveSurface::Events{[](const auto&) {}, [](const auto&) {}});
        if (stage <= Stage::Refused)
            surface->refuse(core::SurfaceKind::Stream, missing, stage == Stage::Withheld);
        else
            surface->rebuild(slow_job(), stage == Stage::Resting);
        if (stage == Stage::Interrupted)
            surface->put_to_rest();
        const int passes = stage >= Stage::Begun
                               ? static_cast<int>(stage) - static_cast<int>(Stage::Begun)
                           : stage == Stage::Failed ? 3
                                                    : 0;
        for (int pass = 0; pass < passes; ++pass)
            turn();
    }

    /// Returns the stage by what clients can see of it. Begins those that rest or failed: asked for last.
    Stage seen_stage() {
        const auto error = surface->outcome().error;
        if (surface->resting() && error)
            return Stage::Withheld;
        if (surface->resting()) {
            surface->resume();
            return surface->resting() ? Stage::Resting : Stage::Interrupted;
        }
        if (error) {
            surface->begin_now();
            return surface->busy() ? Stage::Failed : Stage::Refused;
        }
        if (surface->outcome().complete)
            return Stage::Full;
        if (!surface->busy())
            return Stage::Refused;
        return surface->early() ? stage_after(surface->early()->phase) : Stage::Begun;
    }

    core::MemoryAccount no_memory{1024};
    HistoryBudget no_histories{0, 0, &no_memory};
};

} // namespace

TEST_P(SurfaceStages, ChangeAsTheTableSays) {
    const auto& [stage, event] = GetParam();
    lead_to(stage);
    event.happen(*surface);
    const auto row = event.leads.find(stage);
    EXPECT_EQ(seen_stage(), row == event.leads.end() ? stage : row->second);
}

INSTANTIATE_TEST_SUITE_P(Table,
                         SurfaceStages,
                         testing::Combine(testing::ValuesIn(all_stages), testing::ValuesIn(events)),
                         [](const auto& row) {
                             return std::get<1>(row.param).name + std::string("_in_") +
                                    std::to_string(static_cast<int>(std::get<0>(row.param)));
                         });

} // namespace wakesurf::server::surface_stage_test
