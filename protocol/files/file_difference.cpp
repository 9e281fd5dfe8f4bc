#include "protocol/files/file_difference.hpp"

#include "core/base/plain_text.hpp"
#include "protocol/files/animation_page.hpp"
#include "protocol/files/base64.hpp"
#include "protocol/files/mesh_file.hpp"
#include "protocol/files/recipe.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

namespace wakesurf::protocol {

namespace {

using std::string_view;

std::size_t first_mismatch(string_view a, string_view b) {
    return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

template <class T>
T number_at(string_view bytes, std::size_t at) {
    T value{};
    if (at + sizeof(T) <= bytes.size())
        std::memcpy(&value, bytes.data() + at, sizeof(T));
    return value;
}

/// A number as a file stores it.
struct NumberType {
    std::size_t size = 1;
    std::string (*text)(string_view bytes, std::size_t at) = nullptr;
};

template <class T>
NumberType of_type() {
    return {sizeof(T), [](string_view bytes, std::size_t at) {
                return fmt::format("{}", number_at<T>(bytes, at));
            }};
}

/// Knows the names of .ply, .vtp and glTF.
NumberType number_type(string_view name) {
    if (name == "double" || name == "Float64")
        return of_type<double>();
    if (name == "float" || name == "Float32" || name == "5126")
        return of_type<float>();
    if (name == "int")
        return of_type<std::int32_t>();
    if (name == "uint" || name == "UInt32" || name == "5125")
        return of_type<std::uint32_t>();
    if (name == "Int64")
        return of_type<std::int64_t>();
    return of_type<std::uint8_t>();
}

/// Returns `1`, or `(1, 2, 3)`.
std::string
value_text(const NumberType& type, std::size_t components, string_view bytes, std::size_t at) {
    std::string out;
    for (std::size_t k = 0; k < components; ++k)
        out += (k > 0 ? ", " : "") + type.text(bytes, at + k * type.size);
    return components > 1 ? "(" + out + ")" : out;
}

/// The array of a file in which two files differ first.
struct ValueArray {
    std::string name;   ///< `position`
    std::string of;     ///< `vertex`
    std::size_t first;  ///< byte of the first value
    std::size_t stride; ///< from one to the next
    std::size_t offset; ///< of the value in it
    NumberType type;
    std::size_t components = 1;
};

std::string
difference_in(const ValueArray& array, string_view given, string_view right, std::size_t at) {
    const std::size_t index = (at - array.first) / array.stride;
    const std::size_t value = array.first + index * array.stride + array.offset;
    return fmt::format("{} of {} {} is {} instead of {}", array.name, array.of, index,
                       value_text(array.type, array.components, given, value),
                       value_text(array.type, array.components, right, value));
}

std::string in_description(std::size_t at) {
    return fmt::format("the description in its head differs, at byte {}", at);
}

// .ply

struct PlyProperty {
    std::string name;
    NumberType type;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
    bool list = false; ///< the first property is `uchar` and so many `int`

    std::size_t record() const {
        std::size_t bytes = 0;
        for (const PlyProperty& each : properties)
            bytes += each.type.size;
        return bytes;
    }
};

std::vector<PlyElement> ply_elements(string_view header) {
    std::vector<PlyElement> out;
    for (std::size_t at = 0; at < header.size();) {
        const std::size_t line_end = std::min(header.find('\n', at), header.size());
        std::vector<string_view> words;
        for (string_view rest = header.substr(at, line_end - at); !rest.empty();) {
            const std::size_t space = std::min(rest.find(' '), rest.size());
            words.push_back(rest.substr(0, space));
            rest.remove_prefix(std::min(space + 1, rest.size()));
        }
        at = line_end + 1;
        if (words.size() == 3 && words[0] == "element") {
            out.emplace_back().name = words[1];
            std::from_chars(words[2].data(), words[2].data() + words[2].size(), out.back().count);
        } else if (words.size() == 3 && words[0] == "property" && !out.empty()) {
            out.back().properties.push_back({std::string(words[2]), number_type(words[1])});
        } else if (words.size() == 5 && words[0] == "property" && !out.empty()) {
            out.back().list = true;
        }
    }
    return out;
}

std::string ply_difference(string_view given, string_view right, std::size_t at) {
    constexpr string_view last = "end_header\n";
    const std::size_t body = right.find(last) + last.size();
    if (at < body)
        return in_description(at);
    std::size_t first = body;
    for (const PlyElement& element : ply_elements(right.substr(0, body))) {
        const std::size_t record = element.record();
        if (element.list) {
            for (std::size_t k = 0; k < element.count; ++k) {
                first += 1 + 4 * number_at<std::uint8_t>(right, first) + record;
                if (at < first)
                    return fmt::format("{} {} has other vertices", element.name, k);
            }
        } else if (at < first + element.count * record) {
            std::size_t offset = 0;
            for (const PlyProperty& each : element.properties) {
                if ((at - first) % record < offset + each.type.size)
                    return difference_in(
                        {each.name, element.name, first, record, offset, each.type}, given, right,
                        at);
                offset += each.type.size;
            }
        } else {
            first += element.count * record;
        }
    }
    return in_description(at);
}

// .obj

string_view line_at(string_view file, std::size_t at) {
    const std::size_t begin = at == 0 ? 0 : file.rfind('\n', at - 1) + 1;
    return file.substr(begin, std::min(file.find('\n', begin), begin + 80) - begin);
}

std::string obj_difference(string_view given, string_view right, std::size_t at) {
    const std::pair<string_view, string_view> kinds[] = {
        {"v ", "vertex"}, {"vt ", "s and t of vertex"}, {"f ", "face"}, {"l ", "line"}};
    const string_view line = line_at(right, at);
    for (const auto& [word, name] : kinds) {
        if (!line.starts_with(word))
            continue;
        std::size_t index = 0;
        const string_view before =
            right.substr(0, static_cast<std::size_t>(line.data() - right.data()));
        for (std::size_t k = before.find("\n" + std::string(word)); k != string_view::npos;
             k = before.find("\n" + std::string(word), k + 1))
            ++index;
        return fmt::format("{} {} is `{}` instead of `{}`", name, index,
                           core::printable_line(std::string(line_at(given, at))), line);
    }
    return in_description(at);
}

// .vtp

/// A `<DataArray>` of points, cells or vertices.
struct VtpArray {
    std::string name;
    string_view content;
    std::size_t begin = 0; ///< of the content
    NumberType type;
    std::size_t components = 1;
    std::string of;
};

string_view attribute(string_view tag, string_view name) {
    const std::string before = fmt::format(" {}=\"", name);
    const std::size_t at = tag.find(before);
    if (at == string_view::npos)
        return {};
    const string_view value = tag.substr(at + before.size());
    return value.substr(0, value.find('"'));
}

/// Returns the array of which the content holds the byte `at`; empty if none does, and for those of the description.
std::optional<VtpArray> vtp_array(string_view right, std::size_t at) {
    const std::size_t tag = right.rfind("<DataArray ", at);
    const std::size_t begin = tag == string_view::npos ? tag : right.find('>', tag) + 1;
    if (tag == string_view::npos || begin > at || at < right.find("</FieldData>"))
        return std::nullopt;
    const string_view words = right.substr(tag, begin - tag);
    VtpArray out;
    out.begin = begin;
    out.content = right.substr(begin, right.find('<', begin) - begin);
    if (at >= begin + out.content.size())
        return std::nullopt;
    out.type = number_type(attribute(words, "type"));
    const string_view components = attribute(words, "NumberOfComponents");
    std::from_chars(components.data(), components.data() + components.size(), out.components);
    const string_view name = attribute(words, "Name");
    const string_view before = right.substr(0, tag);
    const bool vertices = before.rfind("<PointData") != string_view::npos &&
                          before.find("</PointData>") == string_view::npos;
    const bool points = name == "Points";
    out.name = points ? "position" : std::string(name);
    out.of = vertices || points ? "vertex" : name == "connectivity" ? "corner" : "cell";
    return out;
}

/// Decodes what append_vtp_array wrote. Empty if it is damaged, or has more than `most` bytes.
std::optional<std::string> vtp_values(string_view content, std::size_t most) {
    constexpr std::size_t first_words = 32; // of base64, with the number of blocks in them
    const auto beginning = base64_bytes(content.substr(0, first_words));
    if (!beginning)
        return std::nullopt;
    const auto blocks = number_at<std::uint64_t>(*beginning, 0);
    if (blocks > content.size())
        return std::nullopt;
    const std::size_t header_bytes = (3 + blocks) * 8;
    const std::size_t header_text = (header_bytes + 2) / 3 * 4;
    if (header_text > content.size())
        return std::nullopt;
    const auto header = base64_bytes(content.substr(0, header_text));
    const auto data = base64_bytes(content.substr(header_text));
    if (!header || !data)
        return std::nullopt;
    std::string out;
    std::size_t at = 0;
    for (std::size_t k = 0; k < blocks; ++k) {
        const auto size = number_at<std::uint64_t>(*header, (3 + k) * 8);
        if (size > data->size() - at)
            return std::nullopt;
        const std::size_t before = out.size();
        const auto block = number_at<std::uint64_t>(*header, 8);
        out.resize(before + std::min<std::uint64_t>(block, most - before));
        auto length = static_cast<uLong>(out.size() - before);
        if (uncompress(reinterpret_cast<Bytef*>(out.data() + before), &length,
                       reinterpret_cast<const Bytef*>(data->data() + at),
                       static_cast<uLong>(size)) != Z_OK)
            return std::nullopt;
        out.resize(before + length);
        at += size;
    }
    return at == data->size() ? std::optional(std::move(out)) : std::nullopt;
}

FileDifference vtp_difference(string_view given, string_view right) {
    FileDifference out;
    std::size_t given_done = 0; // up to here both say the same
    std::size_t right_done = 0;
    while (true) {
        const std::size_t same = first_mismatch(given.substr(given_done), right.substr(right_done));
        const std::size_t at = right_done + same;
        if (at == right.size() && given_done + same == given.size())
            return out;
        const auto array = vtp_array(right, at);
        if (!array) {
            out.what = at < right.find("</FieldData>")
                           ? in_description(at)
                           : fmt::format("what stands between its arrays differs, at byte {}",
                                         given_done + same);
            return out;
        }
        const std::size_t begin = given_done + (array->begin - right_done);
        const std::size_t content_end = std::min(given.find('<', begin), given.size());
        const auto values = vtp_values(array->content, std::size_t{1} << 40);
        const auto others =
            vtp_values(given.substr(begin, content_end - begin), values ? values->size() : 0);
        if (!values || !others) {
            out.what = fmt::format("the compressed data of {} are damaged", array->name);
            return out;
        }
        if (*values != *others) {
            const std::size_t value = first_mismatch(*others, *values);
            out.what = value < others->size() && value < values->size()
                           ? difference_in({array->name, array->of, 0,
                                            array->type.size * array->components, 0, array->type,
                                            array->components},
                                           *others, *values, value)
                           : fmt::format("there are {} bytes of {} instead of {}", others->size(),
                                         array->name, values->size());
            return out;
        }
        out.recompressed = true;
        given_done = content_end;
        right_done = array->begin + array->content.size();
    }
}

// .glb

std::string glb_difference(string_view given, string_view right, std::size_t at) {
    constexpr std::size_t json_begin = 20;
    constexpr std::size_t chunk_header = 8;
    const std::size_t json_length = number_at<std::uint32_t>(right, 12);
    const std::size_t data = json_begin + json_length + chunk_header;
    if (at < data)
        return in_description(at);
    const auto model = nlohmann::json::parse(right.substr(json_begin, json_length), nullptr, false);
    const auto views = model.value("bufferViews", nlohmann::json::array());
    const auto accessors = model.value("accessors", nlohmann::json::array());
    for (std::size_t v = 0; v < views.size(); ++v) {
        const std::size_t first = data + views[v].value("byteOffset", std::size_t{0});
        if (at < first || at >= first + views[v].value("byteLength", std::size_t{0}))
            continue;
        const auto& primitive = model["meshes"][0]["primitives"][0];
        for (std::size_t a = 0; a < accessors.size(); ++a) {
            if (accessors[a].value("bufferView", views.size()) != v)
                continue;
            const NumberType type =
                number_type(std::to_string(accessors[a].value("componentType", 0)));
            const std::size_t components = accessors[a].value("type", "") == "VEC3" ? 3 : 1;
            std::string name = "index";
            for (const auto& [each, index] : primitive["attributes"].items())
                if (index == a)
                    name = each;
            return difference_in({name, name == "index" ? "corner" : "vertex", first,
                                  type.size * components, 0, type, components},
                                 given, right, at);
        }
    }
    return fmt::format("the compressed mesh differs, at byte {} of {}", at, right.size());
}

} // namespace

FileDifference first_difference(string_view format, string_view given, string_view right) {
    if (format == animation_extension)
        return {animation_difference(given, right)};
    const std::size_t at = first_mismatch(given, right);
    if (at == given.size() && at == right.size())
        return {};
    if (at == given.size())
        return {fmt::format("it ends after {} of {} bytes", given.size(), right.size())};
    if (at == right.size())
        return {fmt::format("it has {} bytes more, behind its end", given.size() - right.size())};
    for (const FoundRecipe& each : find_recipes(right).sound)
        if (at >= each.begin && at < each.end)
            return {fmt::format("its recipe differs, at byte {}", at)};
    switch (mesh_format(format).value_or(MeshFormat::Drc)) {
    case MeshFormat::Ply:
        return {ply_difference(given, right, at)};
    case MeshFormat::Obj:
        return {obj_difference(given, right, at)};
    case MeshFormat::Glb:
        return {glb_difference(given, right, at)};
    case MeshFormat::Drc:
        return {fmt::format("the compressed mesh or its description differs, at byte {} of {}", at,
                            right.size())};
    case MeshFormat::Vtp:
        break;
    }
    return vtp_difference(given, right);
}

} // namespace wakesurf::protocol
