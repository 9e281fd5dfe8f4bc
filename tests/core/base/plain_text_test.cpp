#include "server/session/people/display_name.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace wakesurf::server::display_name_test {

TEST(DisplayName, LeavesNothingThatActsOrHides) {
    const std::map<std::string, std::string> names{
        {"Ada", "Ada"},
        {"  Ada \t\n Lovelace ", "Ada Lovelace"},
        {"Zo\u00eb \u4e2d\u6587 \U0001f30a", "Zo\u00eb \u4e2d\u6587 \U0001f30a"},
        {"\u202egnp.exe", "gnp.exe"},
        {"A\u200bd\u200da\ufeff", "Ada"},
        {"\u2066A\u2069", "A"},
        {"A\u2028B", "A B"},
        {"\u3000\u00a0", ""},
        {"\u3164", ""},
        {std::string("A\0B", 3), "AB"},
        {"\x1b[31mred\x7f", "[31mred"},
        {"\xff"
         "A\xc0\xaf"
         "B\xed\xa0\x80",
         "AB"},
        {"A\xf4\x90\x80\x80", "A"},
        {"<b>&amp;", "<b>&amp;"},
    };
    for (const auto& [given, shown] : names)
        EXPECT_EQ(display_name(given, 120), shown) << testing::PrintToString(given);
}

TEST(DisplayName, CutsBetweenCharacters) {
    EXPECT_EQ(display_name("\u00e9\u00e9\u00e9", 5), "\u00e9\u00e9");
    EXPECT_EQ(display_name("ab cd", 3), "ab");
    EXPECT_EQ(display_name("ab cd", 4), "ab c");
}

TEST(DisplayName, StaysWhatItIsWhenItIsMadeAgain) {
    for (const char* given : {" a\u200b  b ", "\u202e x", "\u00e9\u00e9\u00e9\u00e9"}) {
        const std::string once = display_name(given, 7);
        EXPECT_EQ(display_name(once, 7), once);
    }
}

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

} // namespace wakesurf::server::display_name_test
