// A struct with a member of each kind as JSON: what is left out, what may be missing, and how a fault is named.
#include "protocol/api/base/json_members.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <optional>

namespace wakesurf::protocol::json_members_test {

enum class Side : std::uint8_t { Left, Right };

struct Part {
    std::uint8_t count = 0;
    std::array<double, 2> range{0.0, 1.0};

    bool operator==(const Part&) const = default;
};

struct Whole {
    std::string name;
    Side side = Side::Left;
    std::vector<Part> parts;
    std::map<std::string, std::int64_t> sums;
    core::Vec3 at{0.0};
    Part own;
    double since = 7.0;
    std::optional<bool> known{};

    bool operator==(const Whole&) const = default;
};

} // namespace wakesurf::protocol::json_members_test

namespace wakesurf::protocol {

template <>
inline constexpr auto words_of<json_members_test::Side> =
    std::to_array<Word<json_members_test::Side>>({{json_members_test::Side::Left, "left"},
                                                  {json_members_test::Side::Right, "right"}});

} // namespace wakesurf::protocol

namespace wakesurf::protocol::json_members_test {

template <class Io>
void members(Io& io, Of<Io, Part>& of) {
    io.needed("count", of.count);
    io.some("range", of.range, {}, {0.0, 1.0});
}

template <class Io>
void members(Io& io, Of<Io, Whole>& of) {
    io.needed("name", of.name);
    io.needed("side", of.side);
    io.needed("parts", of.parts);
    io.needed("sums", of.sums);
    io.needed("at", of.at);
    members(io, of.own);
    io.newer("since", of.since);
    io.some("known", of.known);
}

using nlohmann::json;

const Whole example{"a", Side::Right, {{3, {1.0, 2.0}}, {4}}, {{"x", -5}}, {1, 2, 3}, {255}, 8.0};

TEST(JsonMembers, WritesMembersUnlessTheyMayBeLeftOutAndHaveTheirDefaults) {
    EXPECT_EQ(
        written(example).dump(),
        R"({"at":[1.0,2.0,3.0],"count":255,"name":"a","parts":[{"count":3,"range":[1.0,2.0]},{"count":4}],)"
        R"("side":"right","since":8.0,"sums":{"x":-5}})");
}

TEST(JsonMembers, ReadsBackWhatItWritesAndIgnoresOtherMembers) {
    Whole known = example;
    known.known = false;
    json text = written(known);
    text["other"] = 1;
    EXPECT_EQ(*parse_kept<Whole>(text), known);
}

TEST(JsonMembers, KeepsTheDefaultOfWhatOlderFilesLack) {
    json text = written(example);
    text.erase("since");
    EXPECT_EQ(parse_kept<Whole>(text)->since, 7.0);
    text["since"] = nullptr;
    EXPECT_EQ(parse_kept<Whole>(text)->since, 7.0);
}

TEST(JsonMembers, SaysWhereAFaultIs) {
    const auto wrong = [](const char* pointer, const json& value) {
        json text = written(example);
        text[json::json_pointer(pointer)] = value;
        const auto read = parse_kept<Whole>(text);
        EXPECT_EQ(read ? core::Error::Code::NotFound : read.error().code,
                  core::Error::Code::Corrupt);
        return read ? text.dump() : read.error().message;
    };
    EXPECT_EQ(wrong("/name", nullptr), "`name` is missing");
    EXPECT_EQ(wrong("/name", 1), "`name` must be a string");
    EXPECT_EQ(wrong("/side", "up"), "`side` must be left or right");
    EXPECT_EQ(wrong("/count", 256), "`count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/count", -1), "`count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/count", 1.5), "`count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/parts", 1), "`parts` must be a list");
    EXPECT_EQ(wrong("/parts/0/range", {1}), "`parts` `range` must have 2 entries");
    EXPECT_EQ(wrong("/parts/1/count", true),
              "`parts` `count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/parts/0/range/1", nullptr), "`parts` `range` must be a finite number");
    EXPECT_EQ(wrong("/sums/x", std::uint64_t{1} << 63),
              "`sums` must be a whole number between -9223372036854775808 and 9223372036854775807");
    EXPECT_EQ(wrong("/sums", 1), "`sums` must be an object");
    EXPECT_EQ(wrong("/at/2", "3"), "`at` must be three finite numbers [x,y,z]");
    EXPECT_EQ(wrong("/known", 0), "`known` must be true or false");
    EXPECT_EQ(parse_kept<Whole>(json::array()).error().message, "must be an object");
}

TEST(JsonMembers, ReadsTheRangeThatIsUnknownAsNaN) {
    const auto part = parse_kept<Part>(json{{"count", 1}, {"range", {nullptr, nullptr}}});
    EXPECT_TRUE(std::isnan(part->range[0]));
    EXPECT_TRUE(std::isnan(part->range[1]));
}

} // namespace wakesurf::protocol::json_members_test
