#include "protocol/api/base/json_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::protocol::json_text_test {
namespace {

constexpr JsonLimits limits{1000, 4};

TEST(JsonText, ReadsBackWhatItWrites) {
    const nlohmann::json value{{"a", {1, 2.5, "x\n\"[{"}}, {"b", nullptr}};
    EXPECT_EQ(parse_json(json_text(value), limits).value(), value);
    EXPECT_EQ(parse_json(json_text(value, 2), limits).value(), value);
}

TEST(JsonText, RefusesWhatIsTooDeepBeforeBuildingIt) {
    EXPECT_TRUE(parse_json("[[[[1]]]]", limits).has_value());
    EXPECT_EQ(parse_json("[[[[[1]]]]]", limits).error().code, core::Error::Code::OverLimit);
    const std::string bomb(500'000, '[');
    EXPECT_EQ(parse_json(bomb, {1'000'000, 32}).error().code, core::Error::Code::OverLimit);
}

TEST(JsonText, CountsNoBracketsInsideStrings) {
    EXPECT_TRUE(parse_json(R"(["[[[[[[[", "\"[[[[[[", "\\"])", limits).has_value());
}

TEST(JsonText, RefusesWhatIsTooLong) {
    EXPECT_EQ(parse_json(std::string(1001, ' '), limits).error().code,
              core::Error::Code::OverLimit);
}

TEST(JsonText, RefusesWhatIsNotJson) {
    for (const char* text :
         {"", "{", "[1,]", "NaN", "1e999", "{\"a\" 1}", "\"\xff\"", "nul", "]", "[1]]"})
        EXPECT_EQ(parse_json(text, limits).error().code, core::Error::Code::Corrupt) << text;
}

TEST(JsonText, ReplacesBytesThatAreNotUtf8) {
    EXPECT_EQ(json_text(nlohmann::json("a\xff")), "\"a\xef\xbf\xbd\"");
}

} // namespace

TEST(JsonText, AFewBytesThatWouldBecomeManyValuesAreRefusedBeforeTheyDo) {
    constexpr JsonLimits few{1000, 4, 10};
    EXPECT_TRUE(parse_json("[1,2,3,4,5,6,7,8]", few));
    EXPECT_TRUE(parse_json(R"(["a,b,c,d,e,f,g,h,i,j,k,l"])", few)) << "commas in texts are none";
    EXPECT_EQ(parse_json("[1,2,3,4,5,6,7,8,9,10]", few).error().code, core::Error::Code::OverLimit);
    EXPECT_EQ(parse_json("[[],[],[],[],[],[]]", few).error().code, core::Error::Code::OverLimit);
}

} // namespace wakesurf::protocol::json_text_test
