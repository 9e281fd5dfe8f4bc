#include "protocol/files/mesh_glb.hpp"

#include "protocol/files/draco_mesh.hpp"
#include "protocol/files/glb_model.hpp"
#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/mesh_triangles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::protocol {

namespace {

/// Viridis (Smith, van der Walt; CC0) at 17 places, as linear light, which COLOR_0 is in.
constexpr std::array<core::Vec3f, 17> viridis{
    core::Vec3f{0.0578F, 0.0003F, 0.0887F}, core::Vec3f{0.0648F, 0.0091F, 0.1441F},
    core::Vec3f{0.0630F, 0.0262F, 0.1981F}, core::Vec3f{0.0545F, 0.0513F, 0.2384F},
    core::Vec3f{0.0437F, 0.0844F, 0.2582F}, core::Vec3f{0.0331F, 0.1248F, 0.2664F},
    core::Vec3f{0.0252F, 0.1683F, 0.2705F}, core::Vec3f{0.0194F, 0.2232F, 0.2705F},
    core::Vec3f{0.0152F, 0.2831F, 0.2623F}, core::Vec3f{0.0137F, 0.3467F, 0.2462F},
    core::Vec3f{0.0203F, 0.4179F, 0.2195F}, core::Vec3f{0.0467F, 0.5029F, 0.1746F},
    core::Vec3f{0.1070F, 0.5776F, 0.1248F}, core::Vec3f{0.2195F, 0.6514F, 0.0742F},
    core::Vec3f{0.4020F, 0.7157F, 0.0319F}, core::Vec3f{0.6654F, 0.7605F, 0.0103F},
    core::Vec3f{0.9823F, 0.7991F, 0.0185F}};

core::Vec3f colour_of(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (viridis.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), viridis.size() - 2);
    return glm::mix(viridis[i], viridis[i + 1], static_cast<float>(place - static_cast<double>(i)));
}

/// Colours by age, from the release to the surface's end, so that the files of a series have the same colours; a time surface
/// by the place across its patch, a level surface, which has no age, by speed.
std::vector<core::Vec3f> vertex_colours(const core::QuadComplex& mesh,
                                        const MeshMetadata& metadata) {
    const core::SurfaceParameters& p = metadata.parameters;
    const double now = metadata.time.value_or(p.to), span = std::abs(p.to - p.from);
    double fastest = 0.0;
    for (core::VertexId v = 0; v < mesh.vertices(); ++v)
        if (const double speed = mesh.speed(v); std::isfinite(speed))
            fastest = std::max(fastest, speed);
    std::vector<core::Vec3f> out;
    for (core::VertexId v = 0; v < mesh.vertices(); ++v) {
        const double share = p.kind == core::SurfaceKind::Level  ? mesh.speed(v) / fastest
                             : p.kind == core::SurfaceKind::Time ? mesh.t[v]
                             : p.kind == core::SurfaceKind::Streak
                                 ? std::abs(now - mesh.t[v]) / span
                                 : std::abs(mesh.t[v]) / span;
        out.push_back(colour_of(std::isfinite(share) ? share : 0.0));
    }
    return out;
}

constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// Returns `_S` for `s`, and such words for the dataset's fields.
std::vector<std::string> attribute_names(const std::vector<MeshAttribute>& attributes,
                                         const MeshScalars& scalars) {
    std::vector<std::string> out;
    for (std::size_t i = 0; i + scalars.size() < attributes.size(); ++i)
        out.push_back(gltf_names({{attributes[i].name, {}}}, {}).front());
    for (std::string& each : gltf_names(scalars, {out.begin(), out.end()}))
        out.push_back(std::move(each));
    return out;
}

tinygltf::Accessor accessor_of(std::size_t count, const MeshAttribute& attribute) {
    const bool vectors = std::holds_alternative<std::vector<core::Vec3f>>(attribute.values);
    const int component = std::holds_alternative<std::vector<std::uint16_t>>(attribute.values)
                              ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                          : std::holds_alternative<std::vector<std::uint8_t>>(attribute.values)
                              ? TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE
                              : TINYGLTF_COMPONENT_TYPE_FLOAT;
    return glb::accessor(count, vectors ? TINYGLTF_TYPE_VEC3 : TINYGLTF_TYPE_SCALAR, component);
}

void add_compressed(tinygltf::Model& model,
                    const DracoMesh& draco,
                    const std::vector<MeshAttribute>& attributes,
                    const std::vector<std::string>& names) {
    tinygltf::Primitive primitive;
    primitive.indices = glb::add(model, glb::accessor(draco.triangles * 3, TINYGLTF_TYPE_SCALAR,
                                                      TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT));
    auto positions = glb::accessor(draco.points, TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT);
    positions.minValues = {draco.lo.x, draco.lo.y, draco.lo.z};
    positions.maxValues = {draco.hi.x, draco.hi.y, draco.hi.z};
    primitive.attributes["POSITION"] = glb::add(model, positions);
    tinygltf::Value::Object ids{{"POSITION", tinygltf::Value(0)}};
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        primitive.attributes[names[i]] = glb::add(model, accessor_of(draco.points, attributes[i]));
        ids[names[i]] = tinygltf::Value(static_cast<int>(i) + 1);
    }
    primitive.extensions[draco_extension] = tinygltf::Value(tinygltf::Value::Object{
        {"bufferView", tinygltf::Value(0)}, {"attributes", tinygltf::Value(ids)}});
    glb::add_buffer(model, {draco.bytes.begin(), draco.bytes.end()});
    glb::add_view(model, 0, draco.bytes.size());
    glb::add_mesh(model, std::move(primitive), TINYGLTF_MODE_TRIANGLES);
    model.extensionsUsed = {draco_extension};
    model.extensionsRequired = {draco_extension};
}

core::Result<void> add_plain(tinygltf::Model& model,
                             const core::QuadComplex& mesh,
                             const std::vector<Triangle>& triangles,
                             const std::vector<MeshAttribute>& attributes,
                             const std::vector<std::string>& names) {
    const auto positions = narrowed_positions(mesh.position);
    if (!positions)
        return tl::unexpected(positions.error());
    glb::PlainArrays arrays(model);
    tinygltf::Primitive primitive;
    primitive.indices = arrays.indices(triangles);
    primitive.attributes["POSITION"] = arrays.vertices(*positions);
    glb::set_bounds(model.accessors.back(), *positions);
    primitive.attributes["NORMAL"] = arrays.vertices(vertex_normals(mesh, triangles));
    for (std::size_t i = 0; i < attributes.size(); ++i)
        primitive.attributes[names[i]] = std::visit(
            [&](const auto& values) { return arrays.vertices(values); }, attributes[i].values);
    arrays.finish();
    glb::add_mesh(model, std::move(primitive), TINYGLTF_MODE_TRIANGLES);
    return {};
}

} // namespace

core::Result<std::string> mesh_glb(const core::QuadComplex& mesh,
                                   const MeshMetadata& metadata,
                                   const MeshScalars& scalars,
                                   GlbCoding coding) {
    auto attributes = mesh_attributes(mesh, scalars);
    tinygltf::Model model;
    if (!mesh.cells.empty()) {
        const auto triangles = triangles_of(mesh);
        auto names = attribute_names(attributes, scalars);
        attributes.push_back({"colour", vertex_colours(mesh, metadata), 0});
        names.emplace_back("COLOR_0");
        if (coding == GlbCoding::Draco) {
            const auto draco = encode_triangles(mesh, triangles, attributes, nullptr);
            if (!draco)
                return tl::unexpected(draco.error());
            add_compressed(model, *draco, attributes, names);
        } else if (auto added = add_plain(model, mesh, triangles, attributes, names); !added) {
            return tl::unexpected(added.error());
        }
    }
    auto extras = glb::extras(metadata);
    tinygltf::Value::Object missing;
    for (const MeshAttribute& each : attributes)
        if (each.missing > 0)
            missing[each.name] = tinygltf::Value(static_cast<int>(each.missing));
    if (!missing.empty())
        extras["missing"] = tinygltf::Value(missing);
    return glb::file_of(model, metadata.version, std::move(extras));
}

} // namespace wakesurf::protocol
