#include "server/sessions/people/participants.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace wakesurf::server::free_name_test {

TEST(FreeName, CountsUpUntilNobodyHasIt) {
    std::set<std::string> names;
    const auto add = [&](const std::string& name) {
        const std::string free =
            free_name(name, 8, [&](const std::string& each) { return names.contains(each); });
        EXPECT_TRUE(names.insert(free).second);
        EXPECT_LE(free.size(), 8u);
        return free;
    };
    EXPECT_EQ(add("Ada"), "Ada");
    EXPECT_EQ(add("Ada"), "Ada 2");
    EXPECT_EQ(add("Ada"), "Ada 3");
    EXPECT_EQ(add("longname"), "longname");
    EXPECT_EQ(add("longname"), "longna 2");
    EXPECT_EQ(add("longna 2"), "longna 3");
}

} // namespace wakesurf::server::free_name_test
