#include "server/app/rake_text.hpp"

#include <gtest/gtest.h>

namespace wakesurf::server::rake_text_test {

TEST(RakeText, TwoPointsAreALineAndMoreAPolyline) {
    const auto line = parse_rake("0,0.5,-1  1e-3,2,3 ", 7);
    ASSERT_TRUE(line);
    EXPECT_EQ(line->kind, core::Rake::Kind::Line);
    EXPECT_EQ(line->points, (std::vector<core::Vec3>{{0, 0.5, -1}, {1e-3, 2, 3}}));
    EXPECT_EQ(line->seeds, 7u);
    const auto polyline = parse_rake("0,0,0 1,0,0 1,1,0", 2);
    ASSERT_TRUE(polyline);
    EXPECT_EQ(polyline->kind, core::Rake::Kind::Polyline);
}

TEST(RakeText, RefusesWhatIsNoPointAndSaysWhich) {
    for (const auto* word :
         {"1,2", "1,2,3,4", "1,2,x", "1;2;3", "nan,0,0", "0,inf,0", "1e999,0,0", ",,"}) {
        const auto rake = parse_rake("0,0,0 " + std::string(word), 2);
        ASSERT_FALSE(rake) << word;
        EXPECT_EQ(rake.error().code, core::Error::Code::InvalidArgument);
        EXPECT_NE(rake.error().message.find(word), std::string::npos) << rake.error().message;
    }
    EXPECT_FALSE(parse_rake("", 2));
    EXPECT_FALSE(parse_rake("0,0,0", 2));
    EXPECT_EQ(parse_rake("0,0,0", 2, "--rake2").error().message, "--rake2: fewer than two points");
}

TEST(RakeText, TheKindSaysWhatThePointsAre) {
    const std::string three = "0,0,0 1,0,0 0,1,0";
    EXPECT_EQ(parse_rake(three, 2, "--rake", "circle")->kind, core::Rake::Kind::Circle);
    EXPECT_EQ(parse_rake(three, 2, "--rake", "points")->kind, core::Rake::Kind::Points);
    EXPECT_EQ(parse_rake(three, 2, "--rake", "polyline")->kind, core::Rake::Kind::Polyline);
    EXPECT_EQ(parse_rake("0,0,0 1,0,0", 2, "--rake", "polyline")->kind, core::Rake::Kind::Polyline);
    const auto complaint = [](const char* text, const char* kind) {
        const auto rake = parse_rake(text, 2, "--rake", kind);
        return rake ? std::string() : rake.error().message;
    };
    EXPECT_EQ(complaint("0,0,0 1,0,0", "circle"),
              "--rake: a circle rake needs a centre and 2 points of its rim");
    EXPECT_EQ(complaint("0,0,0 1,0,0 2,0,0", "circle"),
              "--rake: a circle rake's centre and rim points lie on one line");
    EXPECT_EQ(complaint("0,0,0 1,0,0 2,0,0", "line"), "--rake: a line rake needs exactly 2 points");
    EXPECT_EQ(complaint("0,0,0 1,0,0", "ring"),
              "--rake-kind must be line, polyline, circle or points");
}

TEST(RakeText, AVectorIsOnePoint) {
    EXPECT_EQ(parse_vector("1,-2,3e1", "--sweep"), core::Vec3(1, -2, 30));
    for (const auto* text : {"", "1,2", "1,2,3 4,5,6", "1,2,inf"}) {
        const auto vector = parse_vector(text, "--sweep");
        ASSERT_FALSE(vector) << text;
        EXPECT_TRUE(vector.error().message.starts_with("--sweep: '")) << vector.error().message;
    }
}

} // namespace wakesurf::server::rake_text_test
