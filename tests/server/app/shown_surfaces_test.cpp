// A picture's surfaces are made again from the recipes in it, whatever was shown before the picture was taken.
#include "core/surface/playback/evolution.hpp"
#include "protocol/wire/lattice.hpp"
#include "server/app/shown_surfaces.hpp"
#include "server/live/surface_build.hpp"
#include "server/live/surface_file.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace wakesurf::server::shown_surfaces_test {

namespace {

using core::SurfaceKind;

LoadedDataset flow(const std::string& text) {
    DatasetArgument argument;
    argument.kind = DatasetArgument::Kind::Flow;
    argument.flow = text;
    return open_flow(argument).value();
}

core::SurfacePlan plan_in(const LoadedDataset& dataset, SurfaceKind kind) {
    core::SurfaceParameters p{.kind = kind, .from = 0.0, .to = 4.0, .separation = 0.25};
    if (kind == SurfaceKind::Time)
        p.sweep = core::Vec3(0, 0, 0.5);
    return core::plan_surface(dataset.flow,
                              {core::Rake::Kind::Line, {{0.3, 0.3, 0}, {0.8, 0.7, 0}}, 9}, p)
        .value();
}

/// The recipes of the final states at these times, of one surface that is shown at one after the other.
std::vector<protocol::FoundRecipe> pictures(const LoadedDataset& dataset,
                                            const core::SurfacePlan& plan,
                                            const std::vector<double>& times) {
    const core::SteadyClock clock;
    SurfaceBuild build(
        {1, 1, plan, nullptr, nullptr, {}, protocol::lattice_over(dataset.info.bounds)}, clock);
    std::string file;
    for (const double time : times) {
        const auto shown = build.run({.phase = Phase::Final, .time = time}, {});
        EXPECT_TRUE(shown) << shown.error().message;
        protocol::Recipe recipe = recipe_of(plan, dataset);
        if (core::moves(recipe.parameters))
            recipe.time = shown->time;
        recipe.shape = shown->shape;
        file += protocol::recipe_text(recipe) + "\n";
    }
    return protocol::find_recipes(file).sound;
}

std::vector<double> differing(const ShownSurface& shown, const LoadedDataset& dataset) {
    const core::MemoryAccount account(std::size_t{1} << 30);
    return times_that_differ(shown, dataset, account, {}).value();
}

} // namespace

TEST(ShownSurfaces, AreTheSameInWhateverOrderTheTimesWereShown) {
    const LoadedDataset dataset = flow("double-gyre");
    for (const SurfaceKind kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time}) {
        const auto found =
            pictures(dataset, plan_in(dataset, kind), {1.0, 3.0, 2.5, 4.0, 0.7, 4.0});
        ASSERT_EQ(found.size(), 6u);
        const auto shown = shown_surfaces(found);
        ASSERT_EQ(shown.size(), 1u);
        EXPECT_EQ(shown.front().states.size(), 6u);
        EXPECT_EQ(differing(shown.front(), dataset), std::vector<double>{}) << int(kind);
    }
}

TEST(ShownSurfaces, AreOthersWhereARecipeStatesAnotherShape) {
    const LoadedDataset dataset = flow("double-gyre");
    auto found = pictures(dataset, plan_in(dataset, SurfaceKind::Streak), {1.0, 3.0});
    found[1].recipe.shape = found[0].recipe.shape;
    EXPECT_EQ(differing(shown_surfaces(found).front(), dataset), std::vector<double>{3.0});
}

TEST(ShownSurfaces, OfOneFilmAreToldApartByWhatTheyWereMadeFrom) {
    const LoadedDataset dataset = flow("double-gyre");
    auto found = pictures(dataset, plan_in(dataset, SurfaceKind::Streak), {1.0, 3.0});
    const auto others = pictures(dataset, plan_in(dataset, SurfaceKind::Path), {1.0, 3.0});
    found.insert(found.begin() + 1, others.begin(), others.end());
    const auto shown = shown_surfaces(found);
    ASSERT_EQ(shown.size(), 2u);
    for (const ShownSurface& each : shown)
        EXPECT_EQ(each.states.size(), 2u);
}

} // namespace wakesurf::server::shown_surfaces_test
