#include "protocol/api/base/checked_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace wakesurf::protocol::checked_json_test {

using nlohmann::json;

namespace {

/// The first fault, or an empty string.
std::string fault(const json& parameters, const std::function<void(CheckedJson&)>& read) {
    CheckedJson in(parameters);
    read(in);
    const auto verdict = in.verdict();
    return verdict ? std::string{} : verdict.error().message;
}

std::string number_fault(const json& value) {
    return fault({{"n", value}}, [](CheckedJson& in) { in.number("n", -1e30, 1e30); });
}

std::string count_fault(const json& value) {
    return fault({{"n", value}}, [](CheckedJson& in) { in.count("n", 2, 4096); });
}

std::string points_fault(const json& value) {
    return fault({{"p", value}}, [](CheckedJson& in) { in.points("p", 3); });
}

} // namespace

TEST(CheckedJson, TakesNumbersInRangeOnly) {
    EXPECT_EQ(number_fault(1.5), "");
    EXPECT_EQ(number_fault(-7), "");
    for (const json& bad :
         {json(1e300), json("1"), json(nullptr), json(true), json::array(), json(-1e31)})
        EXPECT_EQ(number_fault(bad).substr(0, 4), "`n` ") << bad;
}

TEST(CheckedJson, HintsAtTheNameThatIsMeantAndLeavesTheRestToTheMessage) {
    const auto hint = [](const json& parameters) {
        CheckedJson in(parameters);
        in.count("seeds", 2, 4096);
        in.token_if("name", false);
        const auto verdict = in.verdict();
        return verdict ? std::string("no fault") : verdict.error().hint;
    };
    EXPECT_EQ(hint({{"seeds", 8u}, {"names", "x"}}), "did you mean `name`?");
    EXPECT_EQ(hint({{"seeds", 8u}, {"opacity", 1}}), "there is `seeds`, `name`");
    EXPECT_EQ(hint({{"seeds", 1u}}), "");
    EXPECT_EQ(hint(json::object()), "");
}

TEST(CheckedJson, TakesWholeNumbersHoweverTheyAreWritten) {
    const json parameters = json::parse(R"({"a":32,"b":32.0,"c":3.2e1})");
    CheckedJson in(parameters);
    for (const char* name : {"a", "b", "c"})
        EXPECT_EQ(in.count(name, 2, 4096), 32u) << name;
    EXPECT_TRUE(in.verdict());
    for (const json& bad : {json(1), json(4097), json(-3), json(2.5), json(1e300), json(-1e300),
                            json("8"), json(true), json(std::uint64_t{1} << 63)})
        EXPECT_EQ(count_fault(bad).substr(0, 4), "`n` ") << bad;
}

TEST(CheckedJson, TakesPointsThatStayFiniteAsFloat) {
    EXPECT_EQ(points_fault(json::parse("[[0,0,0],[1,2,3.5]]")), "");
    EXPECT_EQ(points_fault(json::array()), "");
    for (const char* bad :
         {"[[0,0]]", "[[0,0,0,0]]", "[[0,0,1e300]]", "[[0,0,1e39]]", "[[0,0,\"1\"]]",
          "[[0,0,null]]", "[0,0,0]", "{}", "7", "[[0,0,0],[0,0,0],[0,0,0],[0,0,0]]", "[[0,0,[]]]"})
        EXPECT_EQ(points_fault(json::parse(bad)).substr(0, 4), "`p` ") << bad;
}

TEST(CheckedJson, NamesTheFirstFaultAndWhatNobodyAskedFor) {
    const json parameters{{"a", "text"}, {"b", 5}, {"typo", 1}};
    EXPECT_EQ(fault(parameters,
                    [](CheckedJson& in) {
                        in.number("a", 0, 1);
                        in.text("b");
                    })
                  .substr(0, 4),
              "`a` ");
    EXPECT_EQ(fault(parameters,
                    [](CheckedJson& in) {
                        in.text("a");
                        in.number("b", 0, 9);
                    }),
              "`typo` is not a parameter of this method");
    EXPECT_EQ(fault(json::object(), [](CheckedJson& in) { in.text("name"); }), "`name` is missing");
    EXPECT_NE(fault(json::array({1}), [](CheckedJson&) {}), "");
}

TEST(CheckedJson, TakesNullForLeftOut) {
    const json parameters{{"a", nullptr}};
    CheckedJson in(parameters);
    EXPECT_FALSE(in.has("a"));
    EXPECT_EQ(in.text_or("a", "fallback"), "fallback");
    EXPECT_EQ(in.count_if("a", 0, 9), std::nullopt);
    EXPECT_TRUE(in.verdict());
}

TEST(CheckedJson, RefusesLongTextsAndControlCharacters) {
    const auto text_fault = [](const std::string& text) {
        return fault({{"t", text}}, [](CheckedJson& in) { in.text("t", 8); });
    };
    EXPECT_EQ(text_fault("12345678"), "");
    EXPECT_NE(text_fault("123456789"), "");
    EXPECT_NE(text_fault(std::string("a\0b", 3)), "");
    EXPECT_NE(text_fault("a\nb"), "");
}

} // namespace wakesurf::protocol::checked_json_test
