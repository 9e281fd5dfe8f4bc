#include "core/base/plain_text.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace wakesurf::core::plain_text_test {

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

TEST(DisplayLines, KeepsLinesAndLosesWhatActs) {
    EXPECT_EQ(display_lines("a \u202eb\n\tc\u0085\x1b[2J", 40), "a b\n\tc[2J");
    EXPECT_EQ(display_lines("\u00e9\u00e9", 3), "\u00e9");
}

TEST(Printable, ShowsWhatWouldActAndKeepsTheRest) {
    EXPECT_EQ(printable("p\x1b]0;owned\x07 [Pa]\n"), "p\\u001b]0;owned\\u0007 [Pa]\n");
    EXPECT_EQ(printable("\u202ea\xff\u00e9"), "\\u202ea\\xff\u00e9");
    EXPECT_EQ(printable("\U000e0041"), "\\udb40\\udc41") << "as JSON has it";
    EXPECT_EQ(printable_line("a\nevent=fake\r"), "a\\u000aevent=fake\\u000d");
}

} // namespace wakesurf::core::plain_text_test
