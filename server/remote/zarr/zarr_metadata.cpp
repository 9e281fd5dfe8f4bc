#include "server/remote/zarr/zarr_metadata.hpp"

#include "core/base/plain_text.hpp"
#include "core/base/result.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"
#include "server/remote/zarr/zarr_array.hpp"

#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Reads "<f4", ">f8", "|u1", of version 2. Returns false for unsupported types.
bool read_zarr_type(ZarrArray& array, std::string_view text);

/// Reads "float32", "uint8", of version 3, which states the byte order elsewhere.
bool read_zarr_type_name(ZarrArray& array, std::string_view text);

/// Reads a fill_value; empty for null. Error: Corrupt.
core::Result<std::optional<double>> read_zarr_fill(const ZarrArray& array,
                                                   const nlohmann::json& value);

using core::Error;
using core::Result;
using nlohmann::json;

namespace {

/// Parses the bits of a number, as version 3 may write them: "0x7fc00000".
std::optional<double> number_of_bits(const ZarrArray& array, std::string_view text) {
    std::uint64_t bits = 0;
    const auto read = std::from_chars(text.data() + 2, text.data() + text.size(), bits, 16);
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() ||
        text.size() != 2 + 2 * array.number_bytes)
        return std::nullopt;
    if (array.number_bytes == 4)
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (array.number_bytes == 8)
        return std::bit_cast<double>(bits);
    const bool none = (bits & 0x7c00u) == 0x7c00u && (bits & 0x3ffu) != 0;
    return none ? std::optional(std::numeric_limits<double>::quiet_NaN()) : std::nullopt;
}

} // namespace

bool read_zarr_type(ZarrArray& array, std::string_view text) {
    if (text.size() != 3 || text[2] < '1' || text[2] > '8')
        return false;
    array.big_endian = text[0] == '>';
    array.number = text[1] == 'f'   ? ZarrArray::Number::Float
                   : text[1] == 'i' ? ZarrArray::Number::Signed
                                    : ZarrArray::Number::Unsigned;
    array.number_bytes = static_cast<std::size_t>(text[2] - '0');
    return std::string_view("<>|").find(text[0]) != std::string_view::npos &&
           std::string_view("fiu").find(text[1]) != std::string_view::npos &&
           std::has_single_bit(array.number_bytes) && (text[1] != 'f' || array.number_bytes > 1);
}

bool read_zarr_type_name(ZarrArray& array, std::string_view text) {
    for (const auto& [name, number] : {std::pair{"float", 'f'}, {"int", 'i'}, {"uint", 'u'}}) {
        if (!text.starts_with(name))
            continue;
        const auto bits = text.substr(std::string_view(name).size());
        for (const auto& [said, bytes] :
             {std::pair{"8", '1'}, {"16", '2'}, {"32", '4'}, {"64", '8'}})
            if (bits == said)
                return read_zarr_type(array, std::string{'<', number, bytes});
    }
    return false;
}

Result<std::optional<double>> read_zarr_fill(const ZarrArray& array, const json& value) {
    if (value.is_null())
        return std::optional<double>();
    if (value.is_number())
        return std::optional(value.get<double>());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    if (text == "NaN")
        return std::optional(std::numeric_limits<double>::quiet_NaN());
    if (text == "Infinity" || text == "-Infinity")
        return std::optional(text[0] == '-' ? -infinity : infinity);
    if (array.number == ZarrArray::Number::Float && text.starts_with("0x"))
        if (const auto number = number_of_bits(array, text))
            return number;
    return core::fail(Error::Code::Corrupt, "its fill_value is no number");
}

/// Reads the attributes; unknown and malformed ones are ignored. REQUIRES: the array's shape, number and fill
/// are known; the names of its axes, unless they are among the attributes.
void read_zarr_attributes(ZarrArray& array, const nlohmann::json& given);

using nlohmann::json;

namespace {

constexpr std::size_t longest_unit = 128; // of times with the date that they count from

/// Returns the number that stands for a missing value. null is a NaN, as parse_zarr_json leaves it; a text is
/// eight bytes of a double in base64, as xarray writes them into version 3. Empty for anything else.
std::optional<double> missing_number(const json& value) {
    if (value.is_null())
        return std::numeric_limits<double>::quiet_NaN();
    if (value.is_number())
        return value.get<double>();
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    std::array<unsigned char, 9> bytes{}; // the last one is padding
    if (text.size() != 12 || text.back() != '=' ||
        EVP_DecodeBlock(bytes.data(), reinterpret_cast<const unsigned char*>(text.data()), 12) != 9)
        return std::nullopt;
    double number = 0.0;
    std::memcpy(&number, bytes.data(), sizeof(number));
    return number;
}

/// Adds missing numbers. @param value  one, or a list
void add_missing(ZarrArray& array, const json& value) {
    constexpr std::size_t most = 8; // each number of the array is compared with all of them
    const json list = value.is_array() ? value : json::array({value});
    for (std::size_t i = 0; i < std::min(most, list.size()); ++i) {
        const auto number = missing_number(list[i]);
        if (number && std::isnan(*number))
            array.missing_is_nan = true;
        else if (number)
            array.missing.push_back(*number);
    }
}

void forget_odd_names(ZarrArray& array) {
    if (array.dimensions.size() != array.shape.size() ||
        !std::all_of(array.dimensions.begin(), array.dimensions.end(), is_plain_name))
        array.dimensions.clear();
}

} // namespace

void read_zarr_attributes(ZarrArray& array, const json& given) {
    const json attributes = given.is_object() ? given : json::object();
    const auto text = [&](const char* name) {
        const auto found = attributes.find(name);
        return found != attributes.end() && found->is_string() ? found->get<std::string>() : "";
    };
    const auto number = [&](const char* name) -> std::optional<double> {
        const auto found = attributes.find(name);
        return found != attributes.end() && found->is_number() ? std::optional(found->get<double>())
                                                               : std::nullopt;
    };
    array.unit = core::display_name(text("units"), longest_unit);
    array.scale = number("scale_factor").value_or(1.0);
    array.offset = number("add_offset").value_or(0.0);
    for (const char* name : {"_FillValue", "missing_value"})
        if (const auto found = attributes.find(name); found != attributes.end())
            add_missing(array, *found);
    // A fill value of 0 is most often a default without meaning.
    if (array.fill && *array.fill != 0.0 && std::isfinite(*array.fill))
        array.missing.push_back(*array.fill);
    const auto names = attributes.find("_ARRAY_DIMENSIONS");
    if (names != attributes.end() && names->is_array() && array.dimensions.empty())
        for (const json& each : *names)
            array.dimensions.push_back(each.is_string() ? each.get<std::string>() : "");
    forget_odd_names(array);
}

using core::Error;
using core::fail;
using core::Result;
using nlohmann::json;

namespace {

constexpr protocol::JsonLimits limits{std::size_t{64} << 20, 32};
constexpr std::size_t most_axes = 8;
constexpr std::uint64_t most_numbers = std::uint64_t{1} << 60; // of an array
constexpr std::uint64_t most_chunk_bytes = 0x7fffffff;         // c-blosc counts in int

/// Returns a word of the metadata as an error quotes it.
std::string quoted_word(const std::string& word) {
    return core::display_name(word, 64);
}

tl::unexpected<Error> unsupported(std::string what, std::string hint = {}) {
    return fail(Error::Code::Unsupported, std::move(what), std::move(hint));
}

Result<void> check_sizes(const ZarrArray& array) {
    if (array.shape.empty() || array.shape.size() > most_axes)
        return unsupported("it has " + std::to_string(array.shape.size()) + " axes");
    if (array.chunks.size() != array.shape.size())
        return fail(Error::Code::Corrupt, "its shape and its chunks have other numbers of axes");
    std::uint64_t numbers = 1;
    std::uint64_t in_chunk = array.number_bytes;
    for (std::size_t axis = 0; axis < array.shape.size(); ++axis) {
        if (array.chunks[axis] == 0)
            return fail(Error::Code::Corrupt, "its chunks are empty");
        if (array.shape[axis] == 0)
            return fail(Error::Code::Corrupt, "it is empty");
        if (array.shape[axis] > most_numbers / numbers)
            return fail(Error::Code::OverLimit, "it has too many values");
        numbers *= array.shape[axis];
        if (array.chunks[axis] > most_chunk_bytes / in_chunk)
            return fail(Error::Code::OverLimit, "its chunks are larger than 2 GiB",
                        "write it with smaller chunks, for example of 64 x 64 x 64");
        in_chunk *= array.chunks[axis];
    }
    return {};
}

Result<ZarrArray::Coder> coder(const std::string& name) {
    using Coder = ZarrArray::Coder;
    if (name == "zlib" || name == "gzip")
        return Coder::Zlib;
    if (name == "blosc")
        return Coder::Blosc;
    if (name == "zstd")
        return Coder::Zstd;
    if (name == "crc32c")
        return Coder::Crc32c;
    if (name == "sharding_indexed")
        return unsupported("its chunks lie in shards, which are not read",
                           "write it without shards");
    if (name == "transpose")
        return unsupported("its axes are transposed", "write it in C order");
    return unsupported("it is packed by " + quoted_word(name) + ", which is not read",
                       "write it uncompressed, or packed by zlib, gzip, zstd or blosc");
}

/// Reads "NAME", or an object that has it. @param configuration  empty if there is none
std::string name_and_configuration(const json& value, json& configuration) {
    configuration = json::object();
    if (value.is_string())
        return value.get<std::string>();
    const auto name = value.is_object() ? value.find("name") : value.end();
    if (!value.is_object() || name == value.end() || !name->is_string())
        return "something without a name";
    if (const auto found = value.find("configuration"); found != value.end() && found->is_object())
        configuration = *found;
    return name->get<std::string>();
}

Result<void> read_codecs(ZarrArray& array, const std::vector<json>& list) {
    bool numbers = false;
    for (const json& each : list) {
        json configuration;
        const std::string name = name_and_configuration(each, configuration);
        if (name == "bytes" && !numbers) {
            numbers = true;
            const std::string order = configuration.value("endian", json()).is_string()
                                          ? configuration["endian"].get<std::string>()
                                          : "";
            if (order != "little" && order != "big" && array.number_bytes > 1)
                return fail(Error::Code::Corrupt, "it has no byte order");
            array.big_endian = order == "big";
            continue;
        }
        const auto found = coder(name);
        if (!found)
            return tl::unexpected(found.error());
        array.coders.insert(array.coders.begin(), *found);
    }
    if (!numbers)
        return unsupported("it has no codec `bytes`");
    if (array.coders.size() - std::ranges::count(array.coders, ZarrArray::Coder::Crc32c) > 1)
        return unsupported("it is packed twice", "write it packed once");
    return {};
}

bool read_separator(ZarrArray& array, const json& value) {
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    if (text != "." && text != "/")
        return false;
    array.separator = text[0];
    return true;
}

} // namespace

Result<json> parse_zarr_json(std::string_view text) {
    std::string strict;
    strict.reserve(text.size());
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto rest = text.substr(i);
        const auto word = quoted                          ? std::string_view()
                          : rest.starts_with("NaN")       ? rest.substr(0, 3)
                          : rest.starts_with("-Infinity") ? rest.substr(0, 9)
                          : rest.starts_with("Infinity")  ? rest.substr(0, 8)
                                                          : std::string_view();
        if (!word.empty()) {
            strict += "null";
            i += word.size() - 1;
            continue;
        }
        strict += text[i];
        if (quoted && text[i] == '\\' && i + 1 < text.size())
            strict += text[++i];
        else if (text[i] == '"')
            quoted = !quoted;
    }
    return protocol::parse_json(strict, limits);
}

Result<ZarrArray> parse_zarr_2(std::string name, const json& array, const json& attributes) {
    protocol::JsonReader in(array);
    ZarrArray out;
    out.name = std::move(name);
    std::string order;
    json filters, compressor, separator;
    in.needed("shape", out.shape);
    in.needed("chunks", out.chunks);
    in.needed("order", order);
    in.newer("filters", filters);
    in.newer("compressor", compressor);
    in.newer("dimension_separator", separator);
    if (const auto sound = in.verdict(); !sound)
        return tl::unexpected(sound.error());
    const json type = array.value("dtype", json());
    if (!type.is_string() || !read_zarr_type(out, type.get<std::string>()))
        return unsupported("its numbers are of type " + quoted_word(type.dump()) +
                           ", which is not read");
    if (order != "C")
        return unsupported("its numbers lie in Fortran's order, with the fastest axis first",
                           "write it in C order");
    if (!filters.empty())
        return unsupported("it has filters, which are not read", "write it without filters");
    if (!compressor.is_null()) {
        const json id = compressor.is_object() ? compressor.value("id", json()) : json();
        const auto found =
            coder(id.is_string() ? id.get<std::string>() : "something without a name");
        if (!found)
            return tl::unexpected(found.error());
        out.coders = {*found};
    }
    if (!separator.is_null() && !read_separator(out, separator))
        return fail(Error::Code::Corrupt, "its dimension_separator is neither . nor /");
    const auto fill = read_zarr_fill(out, array.value("fill_value", json()));
    if (!fill)
        return tl::unexpected(fill.error());
    out.fill = *fill;
    read_zarr_attributes(out, attributes);
    return check_sizes(out).map([&] { return std::move(out); });
}

Result<ZarrArray> parse_zarr_3(std::string name, const json& array) {
    protocol::JsonReader in(array);
    ZarrArray out;
    out.name = std::move(name);
    json type, chunk_grid, key_encoding, grid, key;
    std::vector<json> codecs;
    in.needed("shape", out.shape);
    in.newer("data_type", type);
    in.needed("chunk_grid", chunk_grid);
    in.needed("chunk_key_encoding", key_encoding);
    in.needed("codecs", codecs);
    const bool regular = name_and_configuration(chunk_grid, grid) == "regular";
    const std::string encoding = name_and_configuration(key_encoding, key);
    out.chunks = out.shape;
    protocol::JsonReader chunks(grid);
    if (regular)
        chunks.needed("chunk_shape", out.chunks);
    for (const auto& sound : {in.verdict(), chunks.verdict()})
        if (!sound)
            return tl::unexpected(sound.error());
    if (!type.is_string() || !read_zarr_type_name(out, type.get<std::string>()))
        return unsupported("its numbers are of type " + quoted_word(type.dump()) +
                           ", which is not read");
    if (!regular)
        return unsupported("its chunks are not all of one shape");
    if (encoding != "default" && encoding != "v2")
        return unsupported("its chunks have names by " + quoted_word(encoding) +
                           ", which is not read");
    out.key_prefix = encoding == "default" ? "c" : "";
    out.separator = encoding == "default" ? '/' : '.';
    if (key.contains("separator") && !read_separator(out, key["separator"]))
        return fail(Error::Code::Corrupt, "the separator of its chunks' names is neither . nor /");
    if (auto read = read_codecs(out, codecs); !read)
        return tl::unexpected(read.error());
    const auto fill = read_zarr_fill(out, array.value("fill_value", json()));
    if (!fill)
        return tl::unexpected(fill.error());
    out.fill = *fill;
    if (const json names = array.value("dimension_names", json()); names.is_array())
        for (const json& each : names)
            out.dimensions.push_back(each.is_string() ? each.get<std::string>() : "");
    read_zarr_attributes(out, array.value("attributes", json()));
    return check_sizes(out).map([&] { return std::move(out); });
}

} // namespace wakesurf::server
