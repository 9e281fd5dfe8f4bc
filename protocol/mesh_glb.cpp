#include "protocol/mesh_glb.hpp"

#include "protocol/draco_mesh.hpp"
#include "protocol/mesh_names.hpp"
#include "protocol/surface_names.hpp"

#include <tiny_gltf.h>

#include <sstream>

namespace wakesurf::protocol {

namespace {

constexpr const char* extension = "KHR_draco_mesh_compression";

tinygltf::Value numbers(const std::vector<core::Vec3>& points) {
    tinygltf::Value::Array list;
    for (const core::Vec3& p : points)
        list.emplace_back(tinygltf::Value::Array{tinygltf::Value(p.x), tinygltf::Value(p.y),
                                                 tinygltf::Value(p.z)});
    return tinygltf::Value(list);
}

tinygltf::Value extras(const MeshMetadata& metadata, const std::vector<MeshAttribute>& attributes) {
    using tinygltf::Value;
    Value::Object out{{"kind", Value(std::string(name(metadata.kind)))},
                      {"dataset", Value(metadata.dataset)},
                      {"wakesurf", Value(metadata.version)},
                      {"rake", numbers(metadata.rake)},
                      {"from", Value(metadata.from)},
                      {"to", Value(metadata.to)},
                      {"separation", Value(metadata.separation)}};
    if (!metadata.rake2.empty())
        out["rake2"] = numbers(metadata.rake2);
    if (metadata.sweep)
        out["sweep"] = numbers({*metadata.sweep}).Get(0);
    if (metadata.release_until)
        out["releaseUntil"] = Value(*metadata.release_until);
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

void add_mesh(tinygltf::Model& model,
              const DracoMesh& draco,
              const std::vector<MeshAttribute>& attributes,
              const std::vector<std::string>& names) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = 0;
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
    primitive.extensions[extension] = tinygltf::Value(tinygltf::Value::Object{
        {"bufferView", tinygltf::Value(0)}, {"attributes", tinygltf::Value(ids)}});
    tinygltf::Buffer buffer;
    buffer.data.assign(draco.bytes.begin(), draco.bytes.end());
    model.buffers.push_back(std::move(buffer));
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteLength = draco.bytes.size();
    model.bufferViews.push_back(view);
    tinygltf::Mesh mesh;
    mesh.name = "surface";
    mesh.primitives.push_back(std::move(primitive));
    model.meshes.push_back(std::move(mesh));
    model.extensionsUsed = {extension};
    model.extensionsRequired = {extension};
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

core::Result<std::string>
mesh_glb(const core::QuadComplex& mesh, const MeshMetadata& metadata, const MeshScalars& scalars) {
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
        const auto draco = encode_triangles(mesh, triangles_of(mesh), attributes, nullptr);
        if (!draco)
            return tl::unexpected(draco.error());
        add_mesh(model, *draco, attributes, attribute_names(attributes, scalars));
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
