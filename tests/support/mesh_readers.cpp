#include "tests/support/mesh_readers.hpp"

#include <draco/compression/decode.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace wakesurf::tests {

using nlohmann::json;

namespace {

void require(bool right, const std::string& what) {
    if (!right)
        throw std::runtime_error(what);
}

template <class T>
T take(std::string_view& bytes) {
    require(bytes.size() >= sizeof(T), "the file ends early");
    T value{};
    std::memcpy(&value, bytes.data(), sizeof(T));
    bytes.remove_prefix(sizeof(T));
    return value;
}

double number(const std::string& type, std::string_view& bytes) {
    if (type == "double")
        return take<double>(bytes);
    if (type == "float")
        return static_cast<double>(take<float>(bytes));
    if (type == "uint")
        return take<std::uint32_t>(bytes);
    if (type == "int")
        return take<std::int32_t>(bytes);
    require(type == "uchar", "unknown type " + type);
    return take<std::uint8_t>(bytes);
}

std::pair<std::string, std::string> first_word(const std::string& line) {
    const auto space = line.find(' ');
    return {line.substr(0, space), space == std::string::npos ? "" : line.substr(space + 1)};
}

ReadMesh read_draco(std::string_view bytes, const std::map<int, std::string>& names) {
    draco::DecoderBuffer in;
    in.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    const auto decoded = decoder.DecodeMeshFromBuffer(&in);
    require(decoded.ok(), decoded.ok() ? "" : decoded.status().error_msg());
    const draco::Mesh& mesh = *decoded.value();
    ReadMesh out;
    for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
        out.faces.push_back(
            {mesh.face(f)[0].value(), mesh.face(f)[1].value(), mesh.face(f)[2].value()});
    for (int id = 0; id < mesh.num_attributes(); ++id) {
        const draco::PointAttribute& attribute = *mesh.attribute(id);
        const auto* about = mesh.GetAttributeMetadataByAttributeId(id);
        std::string name;
        if (about != nullptr)
            about->GetEntryString("name", &name);
        if (const auto named = names.find(static_cast<int>(attribute.unique_id()));
            named != names.end())
            name = named->second;
        std::vector<double> values;
        for (draco::PointIndex p(0); p < mesh.num_points(); ++p) {
            float row[4] = {};
            attribute.ConvertValue<float>(attribute.mapped_index(p), attribute.num_components(),
                                          row);
            values.insert(values.end(), row, row + attribute.num_components());
        }
        if (attribute.attribute_type() == draco::GeometryAttribute::POSITION)
            for (std::size_t i = 0; i < values.size(); i += 3)
                out.points.emplace_back(values[i], values[i + 1], values[i + 2]);
        else
            out.arrays[name] = std::move(values);
    }
    if (const auto* about = mesh.GetMetadata())
        for (const auto& [key, value] : about->entries())
            about->GetEntryString(key, &out.about[key]);
    return out;
}

ReadMesh compressed_primitive(const json& gltf, std::string_view rest) {
    const json& primitive = gltf["meshes"][0]["primitives"][0];
    const json& draco = primitive["extensions"]["KHR_draco_mesh_compression"];
    const json& view = gltf["bufferViews"][draco["bufferView"].get<std::size_t>()];
    std::map<int, std::string> names;
    for (const auto& [name, id] : draco["attributes"].items())
        names[id.get<int>()] = name;
    ReadMesh out = read_draco(
        rest.substr(view.value("byteOffset", 0u), view["byteLength"].get<std::size_t>()), names);
    const auto accessor = [&](const json& index) {
        return gltf["accessors"][index.get<std::size_t>()];
    };
    require(accessor(primitive["indices"])["count"] == out.faces.size() * 3,
            "another number of indices");
    for (const auto& [name, index] : primitive["attributes"].items()) {
        require(accessor(index)["count"] == out.points.size(), name + ": another number of points");
        require(name == "POSITION" || out.arrays.contains(name), name + " is missing");
        require(!accessor(index).contains("bufferView"), name + " has an uncompressed copy");
    }
    return out;
}

/// Returns one value an element of an accessor of 32-bit floats or whole numbers, each component in a row.
std::vector<double> elements(const json& gltf, const json& index, std::string_view binary) {
    const json& accessor = gltf["accessors"][index.get<std::size_t>()];
    const json& view = gltf["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    require(!view.contains("byteStride") && accessor.value("byteOffset", 0) == 0, "interleaved");
    const auto first = view.value("byteOffset", std::size_t{0});
    require(first % 4 == 0, "an array that does not begin at a multiple of 4 bytes");
    std::string_view bytes = binary.substr(first, view["byteLength"].get<std::size_t>());
    const bool whole = accessor["componentType"] == 5125;
    require(whole || accessor["componentType"] == 5126, "a type that is neither float nor uint");
    const std::size_t width = accessor["type"] == "VEC3" ? 3 : 1;
    const auto values = accessor["count"].get<std::size_t>() * width;
    require(bytes.size() == values * 4, "another number of bytes");
    std::vector<double> out;
    for (std::size_t i = 0; i < values; ++i)
        out.push_back(whole ? take<std::uint32_t>(bytes) : double(take<float>(bytes)));
    return out;
}

ReadMesh plain_primitive(const json& gltf, std::string_view rest) {
    const json& primitive = gltf["meshes"][0]["primitives"][0];
    ReadMesh out;
    const auto corners = elements(gltf, primitive["indices"], rest);
    for (std::size_t i = 0; i < corners.size(); i += 3)
        out.faces.push_back({static_cast<std::uint32_t>(corners[i]),
                             static_cast<std::uint32_t>(corners[i + 1]),
                             static_cast<std::uint32_t>(corners[i + 2])});
    for (const auto& [name, index] : primitive["attributes"].items())
        out.arrays[name] = elements(gltf, index, rest);
    const auto& xyz = out.arrays.at("POSITION");
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        out.points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    out.arrays.erase("POSITION");
    return out;
}

} // namespace

ReadMesh read_ply(const std::string& bytes) {
    const auto end = bytes.find("end_header\n");
    require(bytes.starts_with("ply\nformat binary_little_endian 1.0\n") && end != std::string::npos,
            "no ply");
    std::istringstream header(bytes.substr(0, end));
    std::string_view data = std::string_view(bytes).substr(end + 11);
    ReadMesh out;
    std::vector<std::pair<std::string, std::string>> properties;
    std::size_t vertices = 0;
    std::size_t faces = 0;
    for (std::string line; std::getline(header, line);) {
        std::istringstream words(line);
        std::string word;
        std::string type;
        std::string name;
        words >> word >> type;
        if (word == "comment")
            out.about.insert(first_word(line.substr(8)));
        else if (word == "element")
            words >> (type == "vertex" ? vertices : faces);
        else if (word == "property" && type != "list") {
            words >> name;
            properties.emplace_back(type, name);
        } else if (word == "property")
            require(line == "property list uchar int vertex_indices", line);
    }
    for (std::size_t v = 0; v < vertices; ++v)
        for (const auto& [type, name] : properties)
            out.arrays[name].push_back(number(type, data));
    for (std::size_t v = 0; v < vertices; ++v)
        out.points.emplace_back(out.arrays["x"][v], out.arrays["y"][v], out.arrays["z"][v]);
    for (std::size_t f = 0; f < faces; ++f) {
        out.faces.emplace_back(take<std::uint8_t>(data));
        for (std::uint32_t& v : out.faces.back())
            v = static_cast<std::uint32_t>(take<std::int32_t>(data));
    }
    require(data.empty(), "bytes are left over");
    return out;
}

ReadMesh read_obj(const std::string& text) {
    ReadMesh out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "#") {
            out.about.insert(first_word(line.substr(2)));
        } else if (word == "v") {
            core::Vec3 p(0.0);
            require(bool(words >> p.x >> p.y >> p.z), line);
            out.points.push_back(p);
        } else if (word == "vt") {
            double s = 0;
            double t = 0;
            require(bool(words >> s >> t), line);
            out.arrays["s"].push_back(s);
            out.arrays["t"].push_back(t);
        } else if (word == "f") {
            out.faces.emplace_back();
            std::uint32_t v = 0;
            std::uint32_t vt = 0;
            for (char slash = 0; words >> v >> slash >> vt;) {
                require(slash == '/' && v == vt && v > 0, line);
                out.faces.back().push_back(v - 1);
            }
        }
    }
    return out;
}

ReadMesh read_drc(std::string_view bytes) {
    return read_draco(bytes, {});
}

ReadMesh read_glb(const std::string& bytes) {
    std::string_view rest(bytes);
    require(take<std::uint32_t>(rest) == 0x46546c67 && take<std::uint32_t>(rest) == 2, "no glb");
    require(take<std::uint32_t>(rest) == bytes.size(), "a wrong length");
    const auto json_length = take<std::uint32_t>(rest);
    require(take<std::uint32_t>(rest) == 0x4e4f534a && json_length % 4 == 0, "no JSON chunk");
    const std::string text(rest.substr(0, json_length));
    const json gltf = json::parse(text);
    rest.remove_prefix(json_length);
    ReadMesh out;
    if (gltf.contains("meshes")) {
        const auto binary_length = take<std::uint32_t>(rest);
        require(take<std::uint32_t>(rest) == 0x004e4942 && binary_length == rest.size(),
                "no BIN chunk");
        if (gltf["meshes"][0]["primitives"][0].contains("extensions"))
            out = compressed_primitive(gltf, rest);
        else
            out = plain_primitive(gltf, rest);
    }
    out.json = text;
    return out;
}

std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_uses(const ReadMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& face : mesh.faces)
        for (std::size_t i = 0; i < face.size(); ++i) {
            const auto a = face[i];
            const auto b = face[(i + 1) % face.size()];
            ++uses[{std::min(a, b), std::max(a, b)}];
        }
    return uses;
}

} // namespace wakesurf::tests
