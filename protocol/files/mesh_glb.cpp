#include "protocol/files/mesh_glb.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/files/draco_mesh.hpp"
#include "protocol/files/mesh_names.hpp"
#include "protocol/files/mesh_normals.hpp"

#include <glm/common.hpp>
#include <tiny_gltf.h>

#include <sstream>

namespace wakesurf::protocol {

namespace {

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

tinygltf::Value numbers(const std::vector<core::Vec3>& points) {
    tinygltf::Value::Array list;
    for (const core::Vec3& p : points)
        list.emplace_back(tinygltf::Value::Array{tinygltf::Value(p.x), tinygltf::Value(p.y),
                                                 tinygltf::Value(p.z)});
    return tinygltf::Value(list);
}

tinygltf::Value extras(const MeshMetadata& metadata, const std::vector<MeshAttribute>& attributes) {
    using tinygltf::Value;
    Value::Object out{{"kind", Value(std::string(name(metadata.parameters.kind)))},
                      {"dataset", Value(metadata.dataset)},
                      {"wakesurf", Value(metadata.version)},
                      {"rake", numbers(metadata.rake.points)},
                      {"from", Value(metadata.parameters.from)},
                      {"to", Value(metadata.parameters.to)},
                      {"separation", Value(metadata.separation)}};
    if (tells_kind(metadata.rake.kind))
        out["rakeKind"] = Value(std::string(name(metadata.rake.kind)));
    if (metadata.parameters.rake2)
        out["rake2"] = numbers(metadata.parameters.rake2->points);
    if (metadata.parameters.rake2 && tells_kind(metadata.parameters.rake2->kind))
        out["rake2Kind"] = Value(std::string(name(metadata.parameters.rake2->kind)));
    if (!metadata.stopped.empty())
        out["stopped"] = Value(metadata.stopped);
    if (metadata.parameters.sweep)
        out["sweep"] = numbers({*metadata.parameters.sweep}).Get(0);
    if (metadata.time)
        out["time"] = Value(*metadata.time);
    for (const auto& [name, value] : given_numbers(metadata.parameters))
        out[std::string(name)] = Value(value);
    Value::Object missing;
    for (const MeshAttribute& each : attributes)
        if (each.missing > 0)
            missing[each.name] = Value(static_cast<int>(each.missing));
    if (!missing.empty())
        out["missing"] = Value(missing);
    return Value(out);
}

/// `_S` for `s`, and words of their own for the dataset's fields.
std::vector<std::string> attribute_names(const std::vector<MeshAttribute>& attributes,
                                         const MeshScalars& scalars) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i + scalars.size() < attributes.size(); ++i)
        out.push_back(gltf_names({{attributes[i].name, {}}}, {}).front());
    for (std::string& each : gltf_names(scalars, {out.begin(), out.end()}))
        out.push_back(std::move(each));
    return out;
}

tinygltf::Accessor accessor(std::size_t count, int type, int component) {
    tinygltf::Accessor out; // of compressed data: without a buffer view
    out.count = count;
    out.type = type;
    out.componentType = component;
    return out;
}

tinygltf::Accessor accessor(std::size_t count, const MeshAttribute& attribute) {
    const bool vectors = std::holds_alternative<std::vector<core::Vec3f>>(attribute.values);
    const int component = std::holds_alternative<std::vector<std::uint16_t>>(attribute.values)
                              ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                          : std::holds_alternative<std::vector<std::uint8_t>>(attribute.values)
                              ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE
                              : TINYGLTF_COMPONENT_TYPE_FLOAT;
    return accessor(count, vectors ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_SCALAR, component);
}

int add(tinygltf::Model& model, tinygltf::Accessor accessor) {
    model.accessors.push_back(std::move(accessor));
    return static_cast<int>(model.accessors.size()) - 1;
}

void add_buffer(tinygltf::Model& model, std::vector<unsigned char> bytes) {
    tinygltf::Buffer buffer;
    buffer.data = std::move(bytes);
    model.buffers.push_back(std::move(buffer));
}

int add_view(tinygltf::Model& model, std::size_t offset, std::size_t length, int target = 0) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = offset;
    view.byteLength = length;
    view.target = target;
    model.bufferViews.push_back(view);
    return static_cast<int>(model.bufferViews.size()) - 1;
}

void add_primitive(tinygltf::Model& model, tinygltf::Primitive primitive) {
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = 0;
    tinygltf::Mesh mesh;
    mesh.name = "surface";
    mesh.primitives.push_back(std::move(primitive));
    model.meshes.push_back(std::move(mesh));
}

void add_compressed(tinygltf::Model& model,
                    const DracoMesh& draco,
                    const std::vector<MeshAttribute>& attributes,
                    const std::vector<std::string>& names) {
    tinygltf::Primitive primitive;
    primitive.indices = add(model, accessor(draco.triangles * 3, TINYGLTF_TYPE_SCALAR,
                                            TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT));
    auto positions = accessor(draco.points, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT);
    positions.minValues = {draco.lo.x, draco.lo.y, draco.lo.z};
    positions.maxValues = {draco.hi.x, draco.hi.y, draco.hi.z};
    primitive.attributes["POSITION"] = add(model, positions);
    tinygltf::Value::Object ids{{"POSITION", tinygltf::Value(0)}};
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        primitive.attributes[names[i]] = add(model, accessor(draco.points, attributes[i]));
        ids[names[i]] = tinygltf::Value(static_cast<int>(i) + 1);
    }
    primitive.extensions[draco_extension] = tinygltf::Value(tinygltf::Value::Object{
        {"bufferView", tinygltf::Value(0)}, {"attributes", tinygltf::Value(ids)}});
    add_buffer(model, {draco.bytes.begin(), draco.bytes.end()});
    add_view(model, 0, draco.bytes.size());
    add_primitive(model, std::move(primitive));
    model.extensionsUsed = {draco_extension};
    model.extensionsRequired = {draco_extension};
}

/// Arrays one behind the other in the file's one buffer.
class PlainArrays {
  public:
    explicit PlainArrays(tinygltf::Model& model) : model_(model) {}

    template <class T>
    int
    array(const std::vector<T>& values, int type, int component, std::size_t count, int target) {
        auto out = accessor(count, type, component);
        const std::size_t first = bytes_.size();
        const auto* data = reinterpret_cast<const unsigned char*>(values.data());
        bytes_.insert(bytes_.end(), data, data + values.size() * sizeof(T));
        out.bufferView = add_view(model_, first, bytes_.size() - first, target);
        return add(model_, std::move(out));
    }

    int vertices(const std::vector<core::Vec3f>& values) {
        return array(values, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT, values.size(),
                     TINYGLTF_TARGET_ARRAY_BUFFER);
    }

    int vertices(const std::vector<float>& values) {
        return array(values, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_FLOAT, values.size(),
                     TINYGLTF_TARGET_ARRAY_BUFFER);
    }

    /// As floats: glTF has the elements of an attribute begin at multiples of 4 bytes.
    template <class Whole>
    int vertices(const std::vector<Whole>& values) {
        return vertices(std::vector<float>(values.begin(), values.end()));
    }

    void finish() { add_buffer(model_, std::move(bytes_)); }

  private:
    tinygltf::Model& model_;
    std::vector<unsigned char> bytes_;
};

void set_bounds(tinygltf::Accessor& positions, const std::vector<core::Vec3f>& values) {
    core::Vec3f lo = values.front(), hi = values.front();
    for (const core::Vec3f& p : values) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    positions.minValues = {lo.x, lo.y, lo.z};
    positions.maxValues = {hi.x, hi.y, hi.z};
}

core::Result<void> add_plain(tinygltf::Model& model,
                             const core::QuadComplex& mesh,
                             const std::vector<Triangle>& triangles,
                             const std::vector<MeshAttribute>& attributes,
                             const std::vector<std::string>& names) {
    const auto positions = narrowed_positions(mesh);
    if (!positions)
        return tl::unexpected(positions.error());
    PlainArrays arrays(model);
    tinygltf::Primitive primitive;
    primitive.indices =
        arrays.array(triangles, TINYGLTF_TYPE_SCALAR, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
                     triangles.size() * 3, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    primitive.attributes["POSITION"] = arrays.vertices(*positions);
    set_bounds(model.accessors.back(), *positions);
    primitive.attributes["NORMAL"] = arrays.vertices(vertex_normals(mesh, triangles));
    for (std::size_t i = 0; i < attributes.size(); ++i)
        primitive.attributes[names[i]] = std::visit(
            [&](const auto& values) { return arrays.vertices(values); }, attributes[i].values);
    arrays.finish();
    add_primitive(model, std::move(primitive));
    return {};
}

tinygltf::Material both_sides() {
    tinygltf::Material out;
    out.name = "surface";
    out.doubleSided = true;
    out.pbrMetallicRoughness.metallicFactor = 0.0;
    out.pbrMetallicRoughness.roughnessFactor = 0.6;
    return out;
}

} // namespace

core::Result<std::string> mesh_glb(const core::QuadComplex& mesh,
                                   const MeshMetadata& metadata,
                                   const MeshScalars& scalars,
                                   GlbCoding coding) {
    const auto attributes = mesh_attributes(mesh, scalars);
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "wakesurf " + metadata.version;
    tinygltf::Node node;
    tinygltf::Scene scene;
    scene.extras = extras(metadata, attributes);
    scene.nodes = {0};
    model.defaultScene = 0;
    if (!mesh.cells.empty()) {
        const auto triangles = triangles_of(mesh);
        const auto names = attribute_names(attributes, scalars);
        if (coding == GlbCoding::Draco) {
            const auto draco = encode_triangles(mesh, triangles, attributes, nullptr);
            if (!draco)
                return tl::unexpected(draco.error());
            add_compressed(model, *draco, attributes, names);
        } else if (auto added = add_plain(model, mesh, triangles, attributes, names); !added) {
            return tl::unexpected(added.error());
        }
        model.materials.push_back(both_sides());
        node.mesh = 0;
    }
    model.nodes.push_back(std::move(node));
    model.scenes.push_back(std::move(scene));
    std::ostringstream out;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model, out, false, true))
        return core::fail(core::Error::Code::Corrupt, "the .glb file could not be put together",
                          "write .ply instead");
    return std::move(out).str();
}

} // namespace wakesurf::protocol
