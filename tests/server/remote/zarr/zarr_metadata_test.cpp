// Metadata of arrays of Zarr: what is read, and what is refused with which words.
#include "server/remote/zarr/zarr_metadata.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace wakesurf::server::zarr_metadata_test {

namespace {

using nlohmann::json;
using Code = core::Error::Code;

json version_2() {
    return {{"zarr_format", 2},       {"shape", {5, 20, 30, 40}},
            {"chunks", {1, 8, 8, 8}}, {"dtype", "<f4"},
            {"order", "C"},           {"filters", nullptr},
            {"compressor", nullptr},  {"fill_value", 0.0}};
}

json version_3() {
    return {
        {"zarr_format", 3},
        {"node_type", "array"},
        {"shape", {5, 20, 30, 40}},
        {"data_type", "float32"},
        {"chunk_grid", {{"name", "regular"}, {"configuration", {{"chunk_shape", {1, 8, 8, 8}}}}}},
        {"chunk_key_encoding", {{"name", "default"}}},
        {"codecs", {{{"name", "bytes"}, {"configuration", {{"endian", "little"}}}}}},
        {"fill_value", 0.0},
        {"dimension_names", {"time", "z", "y", "x"}}};
}

/// As a file has it: whole numbers without a sign are others in C++.
json as_text(const json& value) {
    return json::parse(value.dump());
}

core::Result<ZarrArray> of_2(const char* member, json value, json attributes = json::object()) {
    json array = version_2();
    array[member] = std::move(value);
    return parse_zarr_2("u", as_text(array), attributes);
}

core::Result<ZarrArray> of_3(const char* member, json value) {
    json array = version_3();
    array[member] = std::move(value);
    return parse_zarr_3("u", as_text(array));
}

void expect_refused(const core::Result<ZarrArray>& array, Code code, const std::string& words) {
    ASSERT_FALSE(array.has_value()) << words;
    EXPECT_EQ(array.error().code, code) << array.error().message;
    EXPECT_NE(array.error().message.find(words), std::string::npos) << array.error().message;
}

} // namespace

TEST(ZarrMetadata, SayWhatTheNumbersAreAndWhereTheyLie) {
    const auto array =
        of_2("dtype", ">f8", {{"_ARRAY_DIMENSIONS", {"time", "z", "y", "x"}}, {"units", "m s-1"}});
    ASSERT_TRUE(array) << array.error().message;
    EXPECT_EQ(array->shape, (std::vector<std::uint64_t>{5, 20, 30, 40}));
    EXPECT_EQ(array->chunk_bytes(), 512u * 8);
    EXPECT_EQ(array->chunks_along(2), 4u);
    EXPECT_TRUE(array->big_endian);
    EXPECT_EQ(array->dimensions.back(), "x");
    EXPECT_EQ(array->unit, "m s-1");
    EXPECT_EQ(array->path_of({0, 1, 2, 3}), "u/0.1.2.3");
    EXPECT_EQ(of_2("dimension_separator", "/")->path_of({0, 1, 2, 3}), "u/0/1/2/3");
}

TEST(ZarrMetadata, OfVersion3SayTheSame) {
    const auto array = of_3("zarr_format", 3);
    ASSERT_TRUE(array) << array.error().message;
    EXPECT_EQ(array->path_of({0, 1, 2, 3}), "u/c/0/1/2/3");
    EXPECT_EQ(array->dimensions.front(), "time");
    const auto old_names = of_3("chunk_key_encoding", {{"name", "v2"}});
    EXPECT_EQ(old_names->path_of({0, 1, 2, 3}), "u/0.1.2.3");
    const auto packed = of_3("codecs", {{{"name", "bytes"}, {"configuration", {{"endian", "big"}}}},
                                        {{"name", "gzip"}},
                                        {{"name", "crc32c"}}});
    ASSERT_TRUE(packed) << packed.error().message;
    EXPECT_TRUE(packed->big_endian);
    EXPECT_EQ(packed->coders,
              (std::vector{ZarrArray::Coder::Crc32c, ZarrArray::Coder::Zlib})); // as they are read
}

TEST(ZarrMetadata, TellValuesThatAreMissing) {
    EXPECT_FALSE(of_2("fill_value", 0.0)->may_miss_values());
    EXPECT_FALSE(of_2("fill_value", nullptr)->may_miss_values());
    EXPECT_FALSE(of_2("fill_value", nullptr)->fill.has_value());
    EXPECT_TRUE(std::isnan(of_2("fill_value", "NaN")->fill.value()));
    EXPECT_TRUE(of_2("fill_value", "NaN")->may_miss_values());
    EXPECT_TRUE(of_2("fill_value", 1e20)->may_miss_values());
    EXPECT_TRUE(of_2("fill_value", 0.0, {{"_FillValue", -999}})->may_miss_values());
    EXPECT_TRUE(std::isnan(of_3("fill_value", "0x7fc00000")->fill.value()));
    const auto nan = [](json attributes) {
        return of_2("fill_value", 0.0, std::move(attributes))->missing_is_nan;
    };
    EXPECT_TRUE(nan({{"_FillValue", "AAAAAAAA+H8="}})) << "as xarray writes NaN into version 3";
    EXPECT_TRUE(nan({{"missing_value", nullptr}})) << "NaN, as parse_zarr_json leaves it";
    EXPECT_FALSE(nan({{"_FillValue", "Infinity"}}));
    EXPECT_EQ(of_2("fill_value", 0.0, {{"_FillValue", "AAAAAAA4j8A="}})->missing,
              std::vector{-999.0});
    EXPECT_EQ(of_2("fill_value", 0.0, {{"missing_value", {-999, "?", 1e20}}})->missing,
              (std::vector{-999.0, 1e20}));
    expect_refused(of_2("fill_value", "none"), Code::Corrupt, "fill_value is no number");
}

TEST(ZarrMetadata, OfOtherArraysAreRefusedWithTheReason) {
    expect_refused(of_2("order", "F"), Code::Unsupported, "Fortran's order");
    expect_refused(of_2("filters", {{{"id", "delta"}}}), Code::Unsupported, "filters");
    expect_refused(of_2("compressor", {{"id", "bz2"}}), Code::Unsupported, "packed by bz2");
    expect_refused(of_2("dtype", "<U8"), Code::Unsupported, "\"<U8\"");
    expect_refused(of_2("dtype", json::array()), Code::Unsupported, "of type []");
    expect_refused(of_3("codecs", {{{"name", "sharding_indexed"}}}), Code::Unsupported, "shards");
    expect_refused(of_3("codecs", {{{"name", "transpose"}}}), Code::Unsupported, "transposed");
    expect_refused(of_3("codecs", {{{"name", "bytes"}}}), Code::Corrupt, "no byte order");
    expect_refused(of_3("chunk_grid", {{"name", "rectangular"}}), Code::Unsupported, "one shape");
}

TEST(ZarrMetadata, ThatCannotBeAreRefused) {
    expect_refused(of_2("shape", {5, -20, 30, 40}), Code::Corrupt, "shape");
    expect_refused(of_2("chunks", {1, 0, 8, 8}), Code::Corrupt, "empty");
    expect_refused(of_2("chunks", {1, -8, 8, 8}), Code::Corrupt, "chunks");
    expect_refused(of_2("chunks", {1.5, 8, 8, 8}), Code::Corrupt, "chunks");
    expect_refused(of_2("chunks", {8, 8, 8}), Code::Corrupt, "other numbers of axes");
    expect_refused(of_2("chunks", {1, 1024, 1024, 1024}), Code::OverLimit, "2 GiB");
    const std::uint64_t most = ~std::uint64_t{0};
    expect_refused(of_2("chunks", {most, most, most, most}), Code::OverLimit, "2 GiB");
    expect_refused(of_2("shape", {most, most, 2, 2}), Code::OverLimit, "too many values");
    expect_refused(of_2("shape", json::array()), Code::Unsupported, "0 axes");
    expect_refused(of_2("dimension_separator", "../"), Code::Corrupt, "dimension_separator");
    expect_refused(parse_zarr_2("u", json::array(), {}), Code::Corrupt, "object");
    expect_refused(parse_zarr_3("u", json("text")), Code::Corrupt, "object");
}

TEST(ZarrMetadata, AreQuotedOnlyAsFarAsAnyoneReads) {
    const std::string megabyte(1 << 20, 'w');
    for (const auto& refused :
         {of_2("dtype", megabyte), of_2("compressor", {{"id", megabyte}}),
          of_3("data_type", megabyte), of_3("chunk_key_encoding", {{"name", megabyte}}),
          of_3("codecs", json::array({{{"name", megabyte}}}))}) {
        ASSERT_FALSE(refused.has_value());
        EXPECT_LT(refused.error().message.size(), 200u);
    }
    EXPECT_EQ(of_2("dtype", "<f4", {{"units", megabyte}})->unit.size(), 128u);
}

TEST(ZarrMetadata, NamesLeadNowhereElse) {
    EXPECT_TRUE(is_plain_name("velocity_x-2.1"));
    for (const char* name : {"", ".", "..", "a/b", "../u", "a\\b", "a?b", "a#b", "a%2fb", "a b"})
        EXPECT_FALSE(is_plain_name(name)) << name;
    const auto odd = of_2("shape", {5, 20, 30, 40}, {{"_ARRAY_DIMENSIONS", {"..", "z", "y", "x"}}});
    EXPECT_TRUE(odd->dimensions.empty());
}

TEST(ZarrMetadata, MayHoldNumbersAsPythonWritesThem) {
    const auto value =
        parse_zarr_json(R"({"a": NaN, "b": [-Infinity, Infinity], "c": "NaN \" NaN"})");
    ASSERT_TRUE(value) << value.error().message;
    EXPECT_TRUE((*value)["a"].is_null());
    EXPECT_TRUE((*value)["b"][1].is_null());
    EXPECT_EQ((*value)["c"], "NaN \" NaN");
    EXPECT_FALSE(parse_zarr_json("{").has_value());
    EXPECT_FALSE(parse_zarr_json(std::string(10'000, '[')).has_value());
}

} // namespace wakesurf::server::zarr_metadata_test
