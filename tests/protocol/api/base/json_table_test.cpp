// A struct with a member of each kind as JSON: what is left out, what may be missing, and how a fault is named.
#include "protocol/api/base/json_table.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <map>
#include <optional>

namespace wakesurf::protocol::json_table_test {

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

} // namespace wakesurf::protocol::json_table_test

namespace wakesurf::protocol {

template <>
inline constexpr auto words_of<json_table_test::Side> = std::to_array<Word<json_table_test::Side>>(
    {{json_table_test::Side::Left, "left"}, {json_table_test::Side::Right, "right"}});

template <>
inline constexpr auto
    table_of<json_table_test::Part> = std::tuple(needed("count", &json_table_test::Part::count),
                                                 some("range", &json_table_test::Part::range));

template <>
inline constexpr auto
    table_of<json_table_test::Whole> = std::tuple(needed("name", &json_table_test::Whole::name),
                                                  needed("side", &json_table_test::Whole::side),
                                                  needed("parts", &json_table_test::Whole::parts),
                                                  needed("sums", &json_table_test::Whole::sums),
                                                  needed("at", &json_table_test::Whole::at),
                                                  those_of(&json_table_test::Whole::own),
                                                  newer("since", &json_table_test::Whole::since),
                                                  some("known", &json_table_test::Whole::known));

} // namespace wakesurf::protocol

namespace wakesurf::protocol::json_table_test {

using nlohmann::json;

const Whole example{"a", Side::Right, {{3, {1.0, 2.0}}, {4}}, {{"x", -5}}, {1, 2, 3}, {255}, 8.0};

TEST(JsonTable, WritesMembersUnlessTheyMayBeLeftOutAndHaveTheirDefaults) {
    EXPECT_EQ(
        written<json>(example).dump(),
        R"({"at":[1.0,2.0,3.0],"count":255,"name":"a","parts":[{"count":3,"range":[1.0,2.0]},{"count":4}],)"
        R"("side":"right","since":8.0,"sums":{"x":-5}})");
}

TEST(JsonTable, ReadsBackWhatItWritesAndIgnoresOtherMembers) {
    Whole known = example;
    known.known = false;
    json text = written<json>(known);
    text["other"] = 1;
    EXPECT_EQ(*parse_table<Whole>(text), known);
}

TEST(JsonTable, KeepsTheDefaultOfWhatOlderFilesLack) {
    json text = written<json>(example);
    text.erase("since");
    EXPECT_EQ(parse_table<Whole>(text)->since, 7.0);
    text["since"] = nullptr;
    EXPECT_EQ(parse_table<Whole>(text)->since, 7.0);
}

TEST(JsonTable, SaysWhereAFaultIs) {
    const auto wrong = [](const char* pointer, const json& value) {
        json text = written<json>(example);
        text[json::json_pointer(pointer)] = value;
        const auto read = parse_table<Whole>(text);
        EXPECT_EQ(read ? core::Error::Code::NotFound : read.error().code,
                  core::Error::Code::Corrupt);
        return read ? text.dump() : read.error().message;
    };
    EXPECT_EQ(wrong("/name", nullptr), "`name` is missing");
    EXPECT_EQ(wrong("/name", 1), "`name` must be a string");
    EXPECT_EQ(wrong("/side", "up"), "`side` is unknown to this version");
    EXPECT_EQ(wrong("/count", 256), "`count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/count", -1), "`count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/count", 1.0), "`count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/parts", 1), "`parts` must be a list");
    EXPECT_EQ(wrong("/parts/0/range", {1}), "`parts` `range` must have 2 entries");
    EXPECT_EQ(wrong("/parts/1/count", true),
              "`parts` `count` must be a whole number between 0 and 255");
    EXPECT_EQ(wrong("/parts/0/range/1", nullptr), "`parts` `range` must be a finite number");
    EXPECT_EQ(wrong("/sums/x", std::uint64_t{1} << 63),
              "`sums` must be a whole number between -9223372036854775808 and 9223372036854775807");
    EXPECT_EQ(wrong("/sums", 1), "`sums` must be an object");
    EXPECT_EQ(wrong("/at/2", "3"), "`at` must be a finite number");
    EXPECT_EQ(wrong("/known", 0), "`known` must be true or false");
    EXPECT_EQ(parse_table<Whole>(json::array()).error().message, "must be an object");
}

TEST(JsonTable, ReadsTheRangeThatIsUnknownAsNaN) {
    const auto part = parse_table<Part>(json{{"count", 1}, {"range", {nullptr, nullptr}}});
    EXPECT_TRUE(std::isnan(part->range[0]));
    EXPECT_TRUE(std::isnan(part->range[1]));
}

} // namespace wakesurf::protocol::json_table_test
