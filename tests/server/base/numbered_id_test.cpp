#include "server/base/numbered_id.hpp"

#include <gtest/gtest.h>

#include <string>

namespace wakesurf::server::numbered_id_test {

TEST(NumberedId, ReturnsTheNumberOfEveryIdThatIsMadeFromOne) {
    for (const std::uint64_t number : {0ULL, 1ULL, 7ULL, 10ULL, (1ULL << 53) - 1})
        EXPECT_EQ(number_of("session-" + std::to_string(number), "session-"), number);
}

TEST(NumberedId, ReturnsNothingForWhatIsNotMadeFromANumber) {
    for (const char* id : {"", "p", "g7", "p07", "p7x", "p-1", "p 7", "p7 ", "P7", "p1e3"})
        EXPECT_EQ(number_of(id, "p"), std::nullopt) << id;
}

TEST(NumberedId, ReturnsNothingWhereTheNextNumberWouldNotBeAnother) {
    for (const char* id : {"p9007199254740992", "p18446744073709551615", "p18446744073709551616"})
        EXPECT_EQ(number_of(id, "p"), std::nullopt) << id;
}

} // namespace wakesurf::server::numbered_id_test
