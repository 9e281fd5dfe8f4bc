// Parameters of calls with a rule of each kind: what is refused, in which words, with which hint.
#include "protocol/api/base/json_members.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace wakesurf::protocol::call_test {

struct Asked {
    std::optional<double> number;
    std::optional<std::uint32_t> count;
    std::vector<core::Vec3> points;
    std::string text{"fallback"};
    std::optional<std::string> token;
};

struct Inner {
    std::string id;
};

struct Outer {
    std::uint32_t seeds = 0;
    Nullable<Inner> inner;
    std::optional<std::string> name;
};

void members(JsonReader& io, Asked& of) {
    io.some("n", of.number, {.lo = -1e30, .hi = 1e30});
    io.some("c", of.count, {.lo = 2, .hi = 4096});
    io.some("p", of.points, {.hi = 3});
    io.some("t", of.text, {.hi = 8, .text = Text::Line});
    io.some("k", of.token, {.text = Text::Token});
}

void members(JsonReader& io, Inner& of) {
    io.needed("id", of.id, {.lo = 1, .hi = 8, .text = Text::Line});
}

void members(JsonReader& io, Outer& of) {
    io.needed("seeds", of.seeds, {.lo = 2, .hi = 4096});
    io.some("inner", of.inner);
    io.some("name", of.name, {.text = Text::Token});
    io.check("name", of.name && of.seeds == 7 ? "does not go with seven seeds" : "");
}

using nlohmann::json;

namespace {

/// The first fault, or an empty string.
template <class Parameters = Asked>
std::string fault(const json& parameters) {
    const auto read = parse_call<Parameters>(parameters);
    EXPECT_TRUE(read || read.error().code == core::Error::Code::InvalidArgument);
    return read ? std::string() : read.error().message;
}

} // namespace

TEST(Call, TakesNumbersInRangeOnly) {
    EXPECT_EQ(fault({{"n", 1.5}}), "");
    EXPECT_EQ(fault({{"n", -7}}), "");
    for (const json& bad : {json(1e300), json("1"), json(true), json::array(), json(-1e31)})
        EXPECT_EQ(fault({{"n", bad}}), "`n` must be a number between -1e+30 and 1e+30") << bad;
}

TEST(Call, TakesWholeNumbersHoweverTheyAreWritten) {
    for (const char* good : {"32", "32.0", "3.2e1"})
        EXPECT_EQ(parse_call<Asked>({{"c", json::parse(good)}})->count, 32u) << good;
    for (const json& bad : {json(1), json(4097), json(-3), json(2.5), json(1e300), json(-1e300),
                            json("8"), json(true), json(std::uint64_t{1} << 63)})
        EXPECT_EQ(fault({{"c", bad}}), "`c` must be a whole number between 2 and 4096") << bad;
}

TEST(Call, TakesPointsThatStayFiniteAsFloat) {
    EXPECT_EQ(fault({{"p", json::parse("[[0,0,0],[1,2,3.5]]")}}), "");
    EXPECT_EQ(fault({{"p", json::array()}}), "");
    for (const char* bad : {"[[0,0]]", "[[0,0,0,0]]", "[[0,0,1e300]]", "[[0,0,1e39]]",
                            "[[0,0,\"1\"]]", "[[0,0,null]]", "[0,0,0]", "[[0,0,[]]]"})
        EXPECT_EQ(fault({{"p", json::parse(bad)}}),
                  "`p` must hold points of three finite numbers; point 0 is not one")
            << bad;
    for (const char* bad : {"{}", "7", "[[0,0,0],[0,0,0],[0,0,0],[0,0,0]]"})
        EXPECT_EQ(fault({{"p", json::parse(bad)}}),
                  "`p` must be a list of at most 3 points [x,y,z]")
            << bad;
}

TEST(Call, RefusesLongTextsAndControlCharacters) {
    EXPECT_EQ(fault({{"t", "12345678"}}), "");
    for (const std::string& bad :
         {std::string("123456789"), std::string("a\0b", 3), std::string("a\nb")})
        EXPECT_EQ(fault({{"t", bad}}), "`t` must be at most 8 bytes without control characters");
    EXPECT_EQ(fault({{"t", 7}}), "`t` must be a string");
}

TEST(Call, NamesTheFirstFaultAndThenWhatNobodyAskedFor) {
    EXPECT_EQ(fault({{"c", 1}, {"n", "text"}, {"typo", 1}}).substr(0, 4), "`n` ");
    EXPECT_EQ(fault({{"n", 5}, {"typo", 1}}), "`typo` is not a parameter of this method");
    EXPECT_EQ(fault<Outer>(json::object()), "`seeds` is missing");
    EXPECT_EQ(fault(json::array({1})), "`params` must be an object: parameters have names");
}

TEST(Call, HintsAtTheNameThatIsMeantAndLeavesTheRestToTheMessage) {
    const auto hint = [](const json& parameters) {
        const auto read = parse_call<Outer>(parameters);
        return read ? std::string("no fault") : read.error().hint;
    };
    EXPECT_EQ(hint({{"seeds", 8u}, {"names", "x"}}), "did you mean `name`?");
    EXPECT_EQ(hint({{"seeds", 8u}, {"opacity", 1}}), "there is `seeds`, `inner`, `name`");
    EXPECT_EQ(hint({{"seeds", 8u}, {"inner", {{"id", "a"}, {"ids", 1}}}}), "did you mean `id`?");
    EXPECT_EQ(hint({{"seeds", 1u}}), "");
    EXPECT_EQ(hint(json::object()), "");
}

TEST(Call, TakesNullForLeftOutUnlessItSaysMore) {
    const auto read = parse_call<Asked>({{"c", nullptr}, {"t", nullptr}});
    EXPECT_EQ(read->text, "fallback");
    EXPECT_EQ(read->count, std::nullopt);
    EXPECT_FALSE(parse_call<Outer>({{"seeds", 8}})->inner.given);
    const auto cleared = parse_call<Outer>({{"seeds", 8}, {"inner", nullptr}});
    EXPECT_TRUE(cleared->inner.given && !cleared->inner.value);
    EXPECT_EQ(parse_call<Outer>({{"seeds", 8}, {"inner", {{"id", "a"}}}})->inner.value->id, "a");
}

TEST(Call, ChecksWhatLiesInsideAndBesideEachOther) {
    EXPECT_EQ(fault<Outer>({{"seeds", 8}, {"inner", json::object()}}),
              "`inner` is invalid: `id` is missing");
    EXPECT_EQ(fault<Outer>({{"seeds", 8}, {"inner", {{"id", ""}}}}),
              "`inner` is invalid: `id` must not be empty");
    EXPECT_EQ(fault<Outer>({{"seeds", 7}, {"name", "a"}}), "`name` does not go with seven seeds");
}

} // namespace wakesurf::protocol::call_test
