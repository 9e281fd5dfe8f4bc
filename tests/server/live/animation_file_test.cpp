// An animation is made again from its recipe alone, with the body of its data, and is refused where nothing moves.
#include "protocol/files/animation_page.hpp"
#include "protocol/files/base64.hpp"
#include "protocol/files/file_difference.hpp"
#include "server/data/series_times.hpp"
#include "server/live/animation_file.hpp"
#include "server/live/body_frames.hpp"
#include "tests/support/value_of.hpp"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <random>

namespace wakesurf::server::animation_file_test {

namespace {

const std::string viewer = R"(<script type="text/plain" id="recipe"></script>)"
                           R"(<script type="application/json" id="description"></script>)"
                           R"(<script type="text/plain" id="body"></script>)"
                           R"(<script type="text/plain" id="frames"></script>)";

LoadedDataset flow(const std::string& text) {
    DatasetArgument argument;
    argument.kind = DatasetArgument::Kind::Flow;
    argument.flow = text;
    return value_of(open_flow(argument));
}

core::SurfacePlan plan_of(const LoadedDataset& dataset, core::SurfaceKind kind) {
    const core::Box& box = dataset.info.bounds;
    const core::Vec3 middle = box.lo + 0.5 * box.extent();
    const core::Vec3 across = 0.2 * box.extent();
    core::SurfaceParameters p{.kind = kind, .to = 1.0};
    p.separation = 0.1 * across.x;
    p.deformation = true;
    if (kind == core::SurfaceKind::Time)
        p.sweep = core::Vec3(0.1, 0, 0);
    return value_of(core::plan_surface(
        dataset.flow, {core::Rake::Kind::Line, {middle - across, middle + across}, 9}, p));
}

protocol::Recipe recipe_for(const core::SurfacePlan& plan, const LoadedDataset& dataset) {
    protocol::Recipe recipe = recipe_of(plan, dataset);
    recipe.format = protocol::animation_extension;
    recipe.times = even_times(plan.parameters, 5);
    recipe.look = R"({"map":"grey"})";
    return recipe;
}

core::Result<AnimationFile> made(const protocol::Recipe& recipe,
                                 const core::SurfacePlan& plan,
                                 const LoadedDataset& dataset,
                                 int threads = 2,
                                 const std::string& text = {}) {
    const core::MemoryAccount account(std::size_t{1} << 30);
    auto share = account.open(core::MemoryUse::Downloads);
    tbb::task_arena arena(threads);
    return arena.execute([&] {
        return make_animation_file(recipe, plan, dataset, viewer, {},
                                   {&account, &share, std::chrono::seconds(1)}, text);
    });
}

std::string content(const std::string& page, const std::string& id) {
    const std::string begin = "id=\"" + id + "\">";
    const auto from = page.find(begin) + begin.size();
    return page.substr(from, page.find("</script>", from) - from);
}

} // namespace

class AnimationFiles : public testing::TestWithParam<core::SurfaceKind> {};

TEST_P(AnimationFiles, AreMadeAgainFromTheirRecipesAloneAndEveryChangedByteIsNoticed) {
    const LoadedDataset dataset = flow("double-gyre");
    const core::SurfacePlan plan = plan_of(dataset, GetParam());
    const std::string file = value_of(made(recipe_for(plan, dataset), plan, dataset)).file.bytes;
    const auto all = protocol::find_recipes(file);
    ASSERT_EQ(all.sound.size(), 1u);
    const protocol::FoundRecipe& found = all.sound.front();
    EXPECT_TRUE(seal_holds(file, found));
    const core::SurfacePlan again =
        value_of(core::plan_surface(dataset.flow, found.recipe.rake, found.recipe.parameters));
    const auto second = value_of(made(found.recipe, again, dataset, 1, found.text));
    EXPECT_EQ(second.file.bytes, file);
    EXPECT_EQ(second.file.mesh, found.recipe.mesh);
    std::mt19937 random(5);
    for (int k = 0; k < 100; ++k) {
        std::string other = file;
        other[random() % other.size()] ^= 4;
        EXPECT_NE(protocol::first_difference(found.recipe.format, other, file).what, "");
    }
}

INSTANTIATE_TEST_SUITE_P(EveryKind,
                         AnimationFiles,
                         testing::Values(core::SurfaceKind::Stream,
                                         core::SurfaceKind::Path,
                                         core::SurfaceKind::Streak,
                                         core::SurfaceKind::Time));

TEST(AnimationFile, HoldsTheBodyOfItsDataOnceAsThePageGetsIt) {
    const LoadedDataset dataset = flow("cylinder");
    const core::SurfacePlan plan = plan_of(dataset, core::SurfaceKind::Streak);
    const auto file = value_of(made(recipe_for(plan, dataset), plan, dataset));
    const core::MemoryAccount account(std::size_t{1} << 30);
    auto share = account.open(core::MemoryUse::Downloads);
    const auto body = body_frames(dataset, {}, "", {}, account, share, {});
    ASSERT_TRUE(body);
    EXPECT_EQ(protocol::base64_bytes(content(file.file.bytes, "body")), *body);
    EXPECT_EQ(file.without_body, "");
    const LoadedDataset free = flow("double-gyre");
    const core::SurfacePlan other = plan_of(free, core::SurfaceKind::Streak);
    const auto without = value_of(made(recipe_for(other, free), other, free));
    EXPECT_EQ(content(without.file.bytes, "body"), "");
    EXPECT_EQ(without.without_body, "");
}

TEST(AnimationFile, SaysThatABodyTakesTooMuchOfTheFile) {
    const core::MemoryAccount account(std::size_t{1} << 30);
    auto share = account.open(core::MemoryUse::Downloads);
    const auto body = value_of(animated_body(flow("cylinder"), 750, account, share, {}));
    EXPECT_EQ(body.frames, "");
    EXPECT_TRUE(body.without.starts_with("The body is not in this file: it would take "));
    EXPECT_TRUE(body.without.ends_with(" and at most 0.001 are spent on one."));
}

TEST(AnimationFile, IsRefusedWhereNothingMoves) {
    core::SurfacePlan still;
    still.parameters.kind = core::SurfaceKind::Streak;
    still.parameters.to = still.parameters.from;
    core::DatasetInfo info;
    EXPECT_EQ(check_moves(still, info).error().message,
              "nothing moves: the surface is of one time, 0");
    still.parameters.to = 2.0;
    EXPECT_TRUE(check_moves(still, info));
    info.steady = true;
    EXPECT_TRUE(check_moves(still, info));
    still.parameters.kind = core::SurfaceKind::Level;
    EXPECT_EQ(check_moves(still, info).error().message,
              "nothing moves: the level surface of a steady flow is the same at all times");
}

} // namespace wakesurf::server::animation_file_test
