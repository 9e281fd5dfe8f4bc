// Whole sessions in simulated worlds, many of them. WAKESURF_SEED=N runs world N alone, WAKESURF_SEEDS=M the first M.
#include "tests/simulation/simulation.hpp"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::simulation::simulation_test {

namespace {

constexpr std::uint64_t usual_seeds = 1000;
constexpr unsigned at_a_time = 2;

std::optional<std::uint64_t> asked(const char* variable) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? std::nullopt : std::optional<std::uint64_t>(std::stoull(text));
}

struct SimulationTest : testing::Test {
    SimulationTest() { spdlog::set_level(spdlog::level::off); }
};

void add(Story& sum, const Story& story) {
    sum.edits += story.edits;
    sum.durable += story.durable;
    sum.losses += story.losses;
    sum.resumed += story.resumed;
    sum.crashes += story.crashes;
    sum.deltas += story.deltas;
    sum.surfaces += story.surfaces;
    sum.records += story.records;
}

} // namespace

TEST_F(SimulationTest, EndsWithEverybodySeeingTheSame) {
    const auto only = asked("WAKESURF_SEED");
    const std::uint64_t first = only.value_or(1);
    const std::uint64_t count = only ? 1 : asked("WAKESURF_SEEDS").value_or(usual_seeds);
    std::atomic<std::uint64_t> next = first;
    std::mutex mutex; // guards both below
    Story sum;
    std::vector<std::string> troubles;
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 0; i < at_a_time; ++i)
            threads.emplace_back([&] {
                for (std::uint64_t seed; (seed = next++) < first + count;) {
                    const Story story = simulate(seed);
                    const std::lock_guard lock(mutex);
                    add(sum, story);
                    if (!story.trouble.empty())
                        troubles.push_back("seed " + std::to_string(seed) + ": " + story.trouble);
                }
            });
    }
    for (const std::string& each : troubles)
        ADD_FAILURE() << each;
    std::printf("%llu worlds: %zu edits, %zu durable, %zu connections lost, %zu resumed, %zu "
                "crashes, %zu deltas; "
                "at the end %zu records, %zu surfaces\n",
                static_cast<unsigned long long>(count), sum.edits, sum.durable, sum.losses,
                sum.resumed, sum.crashes, sum.deltas, sum.records, sum.surfaces);
    EXPECT_GE(sum.crashes, count);
    if (only)
        return;
    EXPECT_GT(sum.edits, 40 * count);
    EXPECT_GT(sum.durable, 10 * count);
    EXPECT_GT(sum.losses, 8 * count);
    EXPECT_GT(sum.resumed, count / 2);
    EXPECT_GT(sum.deltas, 10 * count);
    EXPECT_GT(sum.surfaces, count);
}

TEST_F(SimulationTest, GoesTheSameWayTwice) {
    for (std::uint64_t seed = asked("WAKESURF_SEED").value_or(1), end = seed + 5; seed < end;
         ++seed)
        EXPECT_EQ(simulate(seed).digest, simulate(seed).digest) << "seed " << seed;
    EXPECT_NE(simulate(1).digest, simulate(2).digest);
}

} // namespace wakesurf::simulation::simulation_test
