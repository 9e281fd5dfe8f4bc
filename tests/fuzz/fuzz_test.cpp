// The short version of fuzzing that is part of every ./check: each target takes its seeds and mutations of them.
#include "tests/fuzz/json_mutation.hpp"
#include "tests/fuzz/mutation.hpp"
#include "tests/fuzz/target.hpp"

#include <gtest/gtest.h>

namespace wakesurf::fuzz {

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
    std::mt19937 random(1);
    const JsonMutation json(seeds);
    for (int i = 0; i < runs; ++i) {
        const auto changed = GetParam().json && i % 2 == 0
                                 ? json(seeds[random() % seeds.size()], random)
                                 : std::nullopt;
        GetParam().run(input_of(changed ? *changed : mutate(seeds, random)));
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzTarget, testing::ValuesIn(targets()), [](const auto& each) {
    return std::string(each.param.name);
});

} // namespace wakesurf::fuzz
