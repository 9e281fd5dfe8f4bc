// The short version of fuzzing that is part of every ./check: each target takes its seeds and mutations of them.
#include "tests/fuzz/json_mutation.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/target.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace wakesurf::fuzz::fuzz_test {

namespace {

constexpr int runs = 2000; ///< of each target: all of them together take some seconds

Input input_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class FuzzTarget : public testing::TestWithParam<Target> {};

} // namespace

TEST_P(FuzzTarget, TakesAnyInput) {
    const auto seeds = GetParam().seeds();
    ASSERT_FALSE(seeds.empty());
    for (const std::string& seed : seeds)
        GetParam().run(input_of(seed));
    Random random(1);
    const JsonMutation json(seeds);
    for (int i = 0; i < runs; ++i) {
        const auto changed = GetParam().json && i % 2 == 0
                                 ? json(seeds[random() % seeds.size()], random)
                                 : std::nullopt;
        GetParam().run(input_of(changed ? *changed : mutate(seeds, random)));
    }
}

TEST(JsonMutation, LeavesMostTextsJsonAndHardlyAnyAsItWas) {
    constexpr int rounds = 1000;
    for (const Target& target : targets()) {
        if (!target.json)
            continue;
        const auto seeds = target.seeds();
        const JsonMutation mutation(seeds);
        const auto whole = std::find_if(seeds.begin(), seeds.end(), [](const std::string& seed) {
            return nlohmann::json::accept(seed);
        });
        if (whole == seeds.end())
            continue; // lines that end with it
        Random random(7);
        int sound = 0, same = 0;
        for (int i = 0; i < rounds; ++i) {
            const auto changed = mutation(*whole, random);
            ASSERT_TRUE(changed.has_value()) << target.name;
            sound += nlohmann::json::accept(*changed) ? 1 : 0;
            same += *changed == *whole ? 1 : 0;
        }
        EXPECT_GT(sound, rounds * 8 / 10) << target.name;
        EXPECT_LT(same, rounds / 10) << target.name;
    }
}

TEST(JsonMutation, ChangesTheJsonAtTheEndOfALineAndLeavesTheWordsBeforeIt) {
    const JsonMutation mutation({R"({"a":1})"});
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        const auto changed = mutation("rake\tr1\t{\"a\":[1,2]}\n", random);
        ASSERT_TRUE(changed.has_value());
        EXPECT_TRUE(changed->starts_with("rake\tr1\t")) << *changed;
        EXPECT_TRUE(changed->ends_with("\n")) << *changed;
    }
    EXPECT_FALSE(mutation("rake\tr1\t{\"a\":[1,2}\n", random).has_value());
    EXPECT_FALSE(mutation("", random).has_value());
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzTarget, testing::ValuesIn(targets()), [](const auto& each) {
    return std::string(each.param.name);
});

} // namespace wakesurf::fuzz::fuzz_test
