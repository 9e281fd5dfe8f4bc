#include "protocol/files/glb_model.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/api/generated/surface.hpp"
#include "protocol/files/mesh_metadata.hpp"

#include <glm/common.hpp>

#include <cmath>
#include <sstream>

namespace wakesurf::protocol::glb {

namespace {

tinygltf::Value numbers(const std::vector<core::Vec3>& points) {
    tinygltf::Value::Array list;
    for (const core::Vec3& p : points)
        list.emplace_back(tinygltf::Value::Array{tinygltf::Value(p.x), tinygltf::Value(p.y),
                                                 tinygltf::Value(p.z)});
    return tinygltf::Value(list);
}

/// A quarter turn about x, as a quaternion x, y, z, w: up is y in glTF, and z in simulations.
const std::vector<double> upright{-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)};

tinygltf::Material both_sides() {
    tinygltf::Material out;
    out.name = "surface";
    out.doubleSided = true;
    out.pbrMetallicRoughness.metallicFactor = 0.0;
    out.pbrMetallicRoughness.roughnessFactor = 0.6;
    return out;
}

} // namespace

tinygltf::Value::Object extras(const MeshMetadata& metadata) {
    using tinygltf::Value;
    Value::Object out{{"kind", Value(std::string(name(metadata.parameters.kind)))},
                      {"dataset", Value(metadata.dataset)},
                      {"wakesurf", Value(metadata.version)},
                      {"from", Value(metadata.parameters.from)},
                      {"to", Value(metadata.parameters.to)},
                      {"separation", Value(metadata.separation)}};
    if (metadata.parameters.field)
        out["field"] = Value(*metadata.parameters.field);
    else
        out["rake"] = numbers(metadata.rake.points);
    if (!metadata.parameters.field && tells_kind(metadata.rake.kind))
        out["rakeKind"] = Value(std::string(name(metadata.rake.kind)));
    if (metadata.parameters.rake2)
        out["rake2"] = numbers(metadata.parameters.rake2->points);
    if (metadata.parameters.rake2 && tells_kind(metadata.parameters.rake2->kind))
        out["rake2Kind"] = Value(std::string(name(metadata.parameters.rake2->kind)));
    if (metadata.tessellate > 1)
        out["tessellate"] = Value(static_cast<int>(metadata.tessellate));
    for (const auto& [name, value] : metadata.errors)
        out[name] = Value(value);
    if (!metadata.stopped.empty())
        out["stopped"] = Value(metadata.stopped);
    if (metadata.parameters.sweep)
        out["sweep"] = numbers({*metadata.parameters.sweep}).Get(0);
    if (!metadata.recipe.empty())
        out["recipe"] = Value(metadata.recipe);
    if (metadata.time)
        out["time"] = Value(*metadata.time);
    for (const auto& [name, value] : given_numbers(metadata.parameters))
        out[std::string(name)] = Value(value);
    return out;
}

tinygltf::Accessor accessor(std::size_t count, int type, int component) {
    tinygltf::Accessor out; // of compressed data: without a buffer view
    out.count = count;
    out.type = type;
    out.componentType = component;
    return out;
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

int add_view(tinygltf::Model& model, std::size_t offset, std::size_t length, int target) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = offset;
    view.byteLength = length;
    view.target = target;
    model.bufferViews.push_back(view);
    return static_cast<int>(model.bufferViews.size()) - 1;
}

void add_mesh(tinygltf::Model& model, tinygltf::Primitive primitive, int mode) {
    primitive.mode = mode;
    primitive.material = 0;
    tinygltf::Mesh mesh;
    mesh.name = "surface";
    mesh.primitives.push_back(std::move(primitive));
    model.meshes.push_back(std::move(mesh));
    model.materials.push_back(both_sides());
}

void set_bounds(tinygltf::Accessor& positions, const std::vector<core::Vec3f>& values) {
    core::Vec3f lo = values.front(), hi = values.front();
    for (const core::Vec3f& p : values) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    positions.minValues = {lo.x, lo.y, lo.z};
    positions.maxValues = {hi.x, hi.y, hi.z};
}

core::Result<std::string>
file_of(tinygltf::Model& model, const std::string& version, tinygltf::Value::Object extras) {
    model.asset.version = "2.0";
    model.asset.generator = "wakesurf " + version;
    tinygltf::Node node;
    if (!model.meshes.empty()) {
        node.mesh = 0;
        node.rotation = upright;
    }
    model.nodes.push_back(std::move(node));
    tinygltf::Scene scene;
    scene.extras = tinygltf::Value(std::move(extras));
    scene.nodes = {0};
    model.scenes.push_back(std::move(scene));
    model.defaultScene = 0;
    std::ostringstream out;
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToStream(&model, out, false, true))
        return core::fail(core::Error::Code::Corrupt, "the .glb file could not be put together",
                          "write .ply instead");
    return std::move(out).str();
}

} // namespace wakesurf::protocol::glb
