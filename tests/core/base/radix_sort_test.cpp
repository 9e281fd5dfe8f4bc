#include "core/base/radix_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

namespace wakesurf::core::radix_sort_test {

namespace {

struct Named {
    std::uint32_t name;
    std::size_t before; ///< place it had

    bool operator==(const Named&) const = default;
};

} // namespace

TEST(RadixSort, IsAStableSort) {
    std::mt19937 random(5);
    for (const std::uint32_t most : {0u, 1u, 40u, 2047u, 2048u, 1u << 22, 0xffffffffu})
        for (const std::size_t count : {0u, 1u, 2u, 1000u}) {
            std::vector<Named> things;
            for (std::size_t i = 0; i < count; ++i)
                things.push_back(
                    {std::uniform_int_distribution<std::uint32_t>(0, most)(random), i});
            std::vector<Named> expected = things;
            std::stable_sort(expected.begin(), expected.end(),
                             [](const Named& a, const Named& b) { return a.name < b.name; });
            radix_sort(things, [](const Named& thing) { return thing.name; });
            EXPECT_TRUE(things == expected) << count << " up to " << most;
        }
}

TEST(Distinct, IsEachNumberOnceInOrder) {
    std::mt19937 random(6);
    for (const std::size_t count : {0u, 1u, 300u, 3000u}) {
        std::vector<std::uint32_t> numbers(count);
        for (std::uint32_t& number : numbers)
            number = static_cast<std::uint32_t>(random() % 700);
        const std::set<std::uint32_t> expected(numbers.begin(), numbers.end());
        EXPECT_EQ(distinct(numbers), std::vector<std::uint32_t>(expected.begin(), expected.end()));
    }
}

} // namespace wakesurf::core::radix_sort_test
