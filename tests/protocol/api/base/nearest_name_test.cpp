#include "protocol/api/base/nearest_name.hpp"

#include <gtest/gtest.h>

namespace wakesurf::protocol::nearest_name_test {

TEST(NearestName, IsTheOneThatIsSpeltMostAlikeWhateverTheCaseAndTheUnderscores) {
    const std::vector<std::string> names{"maxQuads", "colour", "from", "to", "fields", "merge"};
    EXPECT_EQ(nearest_name("max_quads", names), "maxQuads");
    EXPECT_EQ(nearest_name("color", names), "colour");
    EXPECT_EQ(nearest_name("from_", names), "from");
    EXPECT_EQ(nearest_name("feilds", names), "fields");
    EXPECT_EQ(nearest_name("FIELDS", names), "fields");
}

TEST(NearestName, IsNoneWhereNoneIsNear) {
    const std::vector<std::string> names{"maxQuads", "to", "at"};
    EXPECT_EQ(nearest_name("opacity", names), "");
    EXPECT_EQ(nearest_name("x", names), "") << "any name of one letter is one letter away";
    EXPECT_EQ(nearest_name("", names), "");
    EXPECT_EQ(nearest_name("of", names), "");
    EXPECT_EQ(nearest_name("maxQuads", {}), "");
}

} // namespace wakesurf::protocol::nearest_name_test
