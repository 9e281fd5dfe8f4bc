#include "core/base/for_each_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace wakesurf::core::for_each_index_test {

TEST(ForEachIndex, VisitsEachNumberOnce) {
    for (const std::size_t count : {0u, 1u, 7u, 1000u}) {
        std::vector<int> visits(count, 0);
        for_each_index(
            count, [&](std::size_t i) { ++visits[i]; }, 3);
        EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
}

TEST(Gather, KeepsTheOrderOfTheNumbersWhateverTheThreadsAndShares) {
    const auto add = [](std::size_t i, std::vector<std::size_t>& found) {
        for (std::size_t k = 0; k < i % 4; ++k)
            found.push_back(10 * i + k);
    };
    for (const std::size_t count : {0u, 1u, 64u, 65u, 5000u}) {
        std::vector<std::size_t> expected;
        for (std::size_t i = 0; i < count; ++i)
            add(i, expected);
        for (const std::size_t grain : {1u, 64u, 10'000u})
            for (const int threads : {1, 2, 4}) {
                tbb::task_arena arena(threads);
                const auto found =
                    arena.execute([&] { return gather<std::size_t>(count, add, grain); });
                EXPECT_EQ(found, expected) << count << " in shares of " << grain;
            }
    }
}

TEST(SortAll, SortsAsOneThreadDoes) {
    std::vector<std::uint32_t> numbers(20'000);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<std::uint32_t>(i * 2654435761u);
    auto expected = numbers;
    std::sort(expected.begin(), expected.end(), std::greater<>{});
    sort_all(numbers, std::greater<>{});
    EXPECT_EQ(numbers, expected);
}

TEST(Largest, IsTheLargestOfAllAndAtLeastWhatIsGiven) {
    const auto wave = [](std::size_t i, double) { return std::sin(static_cast<double>(i)); };
    double most = 0.0;
    for (std::size_t i = 0; i < 3000; ++i)
        most = std::max(most, wave(i, 0.0));
    EXPECT_EQ(largest(3000, 0.0, wave, 100), most);
    EXPECT_EQ(largest(3000, 2.0, wave, 100), 2.0);
    EXPECT_EQ(largest(0, 0.5, wave, 100), 0.5);
}

TEST(LoopTimes, HearsOfOuterLoopsAloneAndInHowManyTasksTheyAreDivided) {
    tbb::task_arena(1).execute([] {
        const auto nothing = [](std::size_t) {};
        for_each_index(10, nothing);
        const LoopTimes times;
        for_each_index(
            100, [&](std::size_t) { for_each_index(10, nothing, 1); }, 8);
        {
            const LoopTimes inner;
            for_each_index(5, nothing, 5);
            EXPECT_EQ(inner.loops().size(), 1u);
        }
        for_each_index(1, nothing);
        ASSERT_EQ(times.loops().size(), 2u);
        EXPECT_EQ(times.loops()[0].tasks, 13.0);
        EXPECT_EQ(times.loops()[1].tasks, 1.0);
        EXPECT_GE(times.loops()[0].seconds, 0.0);
    });
}

} // namespace wakesurf::core::for_each_index_test
