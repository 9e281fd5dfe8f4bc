#include "server/base/terminal_text.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::terminal_text_test {

TEST(TerminalText, ShowsWhatATerminalCouldTakeForACommandAsItsBytes) {
    EXPECT_EQ(terminal_text("plain, \xc3\xa4 \xe2\x86\x92 \xf0\x9f\x8c\x8a"),
              "plain, \xc3\xa4 \xe2\x86\x92 \xf0\x9f\x8c\x8a");
    EXPECT_EQ(terminal_text("\x1b]0;title\x07"), "\\x1b]0;title\\x07");
    EXPECT_EQ(terminal_text("a\r\nb\x7f"), "a\\x0d\\x0ab\\x7f");
    EXPECT_EQ(terminal_text("\xc2\x9b"
                            "31m"),
              "\\xc2\\x9b31m")
        << "CSI in two bytes";
    EXPECT_EQ(terminal_text("\x9b\xc3"), "\\x9b\\xc3");
    EXPECT_EQ(terminal_text("\xff\xf5\xe2\x86"), "\\xff\\xf5\\xe2\\x86");
    EXPECT_EQ(terminal_text(std::string(1, '\0')), "\\x00");
    for (int c = 0; c < 256; ++c)
        for (const char each : terminal_text(std::string(2, static_cast<char>(c))))
            EXPECT_TRUE(each >= ' ' && each < 0x7f) << c;
}

} // namespace wakesurf::server::terminal_text_test
