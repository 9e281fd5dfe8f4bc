#include "protocol/files/mesh_file.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/recipe.hpp"
#include "tests/support/small_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace wakesurf::protocol::recipe_test {

namespace {

Recipe sample() {
    Recipe recipe{.version = "1.2.3", .dataset = "a \"wake\" <-- here"};
    recipe.values = "0-0123456789abcdef 1-0123456789abcdef 20-fedcba9876543210";
    recipe.rake = {core::Rake::Kind::Circle, {{0, 0, 0}, {0.1, 1e-300, -2}, {1.0 / 3, 2, 5}}, 17};
    recipe.parameters = {.kind = core::SurfaceKind::Time,
                         .from = 0.1,
                         .to = 7,
                         .direction = core::Direction::Forward,
                         .separation = 1.0 / 7,
                         .between = core::Between::Flow,
                         .max_quads = 50'000'000,
                         .deformation = true,
                         .tangents = true,
                         .life = 3.0};
    recipe.parameters.rake2 = core::Rake{core::Rake::Kind::Line, {{1, 2, 3}, {4, 5, 6}}, 9};
    recipe.fields.assign(20, "p");
    recipe.format = "ply";
    recipe.tessellate = 3;
    recipe.lines = "points";
    recipe.time = 0.30000000000000004;
    recipe.times = {0.1, 0.30000000000000004, 7};
    recipe.look = R"({"map":"grey"})";
    recipe.mesh.assign(64, 'a');
    return recipe;
}

std::string file_with(const std::string& text, MeshFormat format = MeshFormat::Vtp) {
    MeshMetadata metadata{.dataset = "d", .version = "1"};
    metadata.recipe = text;
    return mesh_file(format, tests::small_mesh(), metadata, {}).value();
}

} // namespace

TEST(Recipe, ComesBackTheSameFromAFileOfEachFormat) {
    for (const MeshFormat format : mesh_formats) {
        const auto found = find_recipes(file_with(recipe_text(sample()), format));
        EXPECT_EQ(found.damaged, 0u);
        ASSERT_EQ(found.sound.size(), 1u) << extension(format);
        EXPECT_EQ(found.sound.front().recipe, sample()) << extension(format);
        EXPECT_EQ(found.sound.front().text, recipe_text(sample()));
    }
}

TEST(Recipe, IsFoundWhereItsSealIs) {
    const std::string file = file_with(recipe_text(sample()), MeshFormat::Obj);
    const auto found = find_recipes(file).sound.front();
    EXPECT_EQ(file.substr(found.seal_begin(), seal_length), std::string(seal_length, '0'));
    EXPECT_EQ(file[found.end - 1], '.');
}

TEST(Recipe, HasLinesThatReadersOfPlyTake) {
    Recipe longer = sample();
    longer.rake.kind = core::Rake::Kind::Polyline;
    longer.rake.points.assign(1024, {1.0 / 3, 2.0 / 3, 1e-300});
    const auto lines = recipe_lines(recipe_text(longer));
    EXPECT_GT(lines.size(), 50u);
    EXPECT_LE(std::ranges::max(lines, {}, &std::string::size).size(), 900u);
    const auto found = find_recipes(file_with(recipe_text(longer), MeshFormat::Ply));
    ASSERT_EQ(found.sound.size(), 1u);
    EXPECT_EQ(found.sound.front().recipe, longer);
}

TEST(Recipe, IsDamagedOrAnotherTextWhereverAByteIsAnother) {
    const std::string text = recipe_text(sample());
    for (std::size_t k = 0; k + 1 < text.size(); ++k) {
        std::string other = "some bytes " + text + "\n";
        other[11 + k] ^= 1;
        const auto found = find_recipes(other);
        if (!found.sound.empty()) // a byte of the seal
            EXPECT_NE(found.sound.front().seal, std::string(seal_length, '0')) << k;
    }
}

TEST(Recipe, OfAStrangerIsCheckedByTheRulesOfTheApi) {
    const auto sound = [](auto change) {
        Recipe recipe = sample();
        change(recipe);
        const auto found = find_recipes(recipe_text(recipe));
        return found.sound.size() == 1 && found.damaged == 0;
    };
    EXPECT_TRUE(sound([](Recipe&) {}));
    EXPECT_FALSE(sound([](Recipe& r) { r.parameters.merge = 0.7; }));
    EXPECT_FALSE(sound([](Recipe& r) { r.parameters.max_quads = 100'000'001; }));
    EXPECT_FALSE(sound([](Recipe& r) { r.rake.points.assign(1025, {0, 0, 0}); }));
    EXPECT_FALSE(sound([](Recipe& r) { r.rake.seeds = 1'000'000'000; }));
    EXPECT_FALSE(sound([](Recipe& r) { r.tessellate = 65; }));
    EXPECT_FALSE(sound([](Recipe& r) { r.lines.assign(300, 'x'); }));
    EXPECT_FALSE(sound([](Recipe& r) { r.fields.assign(300'000, "pressure"); }));
}

TEST(Recipe, IsNotLookedForBehindManyMarkersWithoutOne) {
    std::string file;
    for (int k = 0; k < 100'000; ++k)
        file += "wakesurf-recipe:A";
    const auto found = find_recipes(file + recipe_text(sample()));
    EXPECT_EQ(found.sound.size(), 0u);
    EXPECT_EQ(found.damaged, 64u);
}

} // namespace wakesurf::protocol::recipe_test
