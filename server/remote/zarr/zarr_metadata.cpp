#include "server/remote/zarr/zarr_metadata.hpp"

#include "core/base/plain_text.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"
#include "server/remote/zarr/zarr_attributes.hpp"
#include "server/remote/zarr/zarr_numbers.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;
using nlohmann::json;

namespace {

using Counts = std::vector<std::uint64_t>;

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
            return fail(Error::Code::OverLimit, "it has more numbers than can be counted");
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
        return unsupported("its numbers lie in another order, with the fastest axis first",
                           "write it in C order");
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
        return "nothing that has a name";
    if (const auto found = value.find("configuration"); found != value.end() && found->is_object())
        configuration = *found;
    return name->get<std::string>();
}

Result<void> read_codecs(ZarrArray& array, const json& list) {
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
    protocol::JsonMembers members(array);
    ZarrArray out;
    out.name = std::move(name);
    out.shape = members.get<Counts>("shape");
    out.chunks = members.get<Counts>("chunks");
    const std::string order = members.text("order");
    if (const auto sound = members.verdict(); !sound)
        return tl::unexpected(sound.error());
    const json type = array.value("dtype", json());
    if (!type.is_string() || !read_zarr_type(out, type.get<std::string>()))
        return unsupported("its numbers are of type " + quoted_word(type.dump()) +
                           ", which is not read");
    if (order != "C")
        return unsupported("its numbers lie in Fortran's order, with the fastest axis first",
                           "write it in C order");
    if (members.has("filters") && !array["filters"].empty())
        return unsupported("it has filters, which are not read", "write it without filters");
    if (members.has("compressor")) {
        const json& compressor = members.object("compressor");
        const json id = compressor.value("id", json());
        const auto found =
            coder(id.is_string() ? id.get<std::string>() : "nothing that has a name");
        if (!found)
            return tl::unexpected(found.error());
        out.coders = {*found};
    }
    if (members.has("dimension_separator") && !read_separator(out, array["dimension_separator"]))
        return fail(Error::Code::Corrupt, "its dimension_separator is neither . nor /");
    const auto fill = read_zarr_fill(out, array.value("fill_value", json()));
    if (!fill)
        return tl::unexpected(fill.error());
    out.fill = *fill;
    read_zarr_attributes(out, attributes);
    return check_sizes(out).map([&] { return std::move(out); });
}

Result<ZarrArray> parse_zarr_3(std::string name, const json& array) {
    protocol::JsonMembers members(array);
    ZarrArray out;
    out.name = std::move(name);
    out.shape = members.get<Counts>("shape");
    const json type = array.is_object() ? array.value("data_type", json()) : json();
    json grid;
    const bool regular = name_and_configuration(members.object("chunk_grid"), grid) == "regular";
    protocol::JsonMembers chunks(grid);
    out.chunks = regular ? chunks.get<Counts>("chunk_shape") : out.shape;
    json key;
    const std::string encoding = name_and_configuration(members.object("chunk_key_encoding"), key);
    const json& codecs = members.list("codecs");
    for (const auto& sound : {members.verdict(), chunks.verdict()})
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
    if (members.has("dimension_names") && array["dimension_names"].is_array())
        for (const json& each : array["dimension_names"])
            out.dimensions.push_back(each.is_string() ? each.get<std::string>() : "");
    read_zarr_attributes(out, array.value("attributes", json()));
    return check_sizes(out).map([&] { return std::move(out); });
}

} // namespace wakesurf::server
