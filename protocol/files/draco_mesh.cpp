#include "protocol/files/draco_mesh.hpp"

#include "protocol/files/mesh_metadata.hpp"

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <span>

namespace wakesurf::protocol {

core::Result<std::string>
mesh_drc(const core::QuadComplex& mesh, const MeshMetadata& metadata, const MeshScalars& scalars) {
    return encode_triangles(mesh, triangles_of(mesh), mesh_attributes(mesh, scalars), &metadata)
        .map([](DracoMesh&& made) { return std::move(made.bytes); });
}

namespace {

using core::Error;

constexpr int position_bits = 20;
constexpr int value_bits = 16;
constexpr int encoding_speed = 3;

/// Larger coordinates, and their differences, overflow in Draco's arithmetic.
constexpr float largest = 1e38F;

bool usable(float value) {
    return std::abs(value) < largest; // false for NaN
}

bool usable(const core::Vec3f& v) {
    return usable(v.x) && usable(v.y) && usable(v.z);
}

/// Replaces values that are not finite by the least finite one, and counts them: Draco hangs on a NaN and
/// aborts on an infinity.
std::size_t replace_missing(std::span<float> values) {
    float least = std::numeric_limits<float>::max();
    for (const float value : values)
        if (usable(value))
            least = std::min(least, value);
    if (least == std::numeric_limits<float>::max())
        least = 0.0F;
    std::size_t missing = 0;
    for (float& value : values)
        if (!usable(value)) {
            value = least;
            ++missing;
        }
    return missing;
}

MeshAttribute of_floats(std::string name, std::vector<float> values) {
    MeshAttribute out{std::move(name), {}, replace_missing(values)};
    out.values = std::move(values);
    return out;
}

template <class T, class From>
std::vector<T> narrowed(const std::vector<From>& values) {
    std::vector<T> out;
    out.reserve(values.size());
    for (const From value : values)
        out.push_back(static_cast<T>(std::min<From>(value, std::numeric_limits<T>::max())));
    return out;
}

template <class T>
int add_attribute(draco::Mesh& mesh,
                  draco::GeometryAttribute::Type kind,
                  draco::DataType type,
                  std::size_t components,
                  std::span<const T> values) {
    draco::GeometryAttribute description;
    description.Init(kind, nullptr, static_cast<std::uint8_t>(components), type, false,
                     static_cast<std::int64_t>(sizeof(T)), 0);
    const int id = mesh.AddAttribute(
        description, true, static_cast<draco::AttributeValueIndex::ValueType>(values.size()));
    std::memcpy(mesh.attribute(id)->buffer()->data(), values.data(), values.size_bytes());
    return id;
}

struct Adder {
    draco::Mesh& mesh;

    int operator()(const std::vector<float>& values) const {
        return add(draco::DT_FLOAT32, 1, values);
    }

    int operator()(const std::vector<core::Vec3f>& values) const {
        return add(draco::DT_FLOAT32, 3, values);
    }

    int operator()(const std::vector<std::uint16_t>& values) const {
        return add(draco::DT_UINT16, 1, values);
    }

    int operator()(const std::vector<std::uint8_t>& values) const {
        return add(draco::DT_UINT8, 1, values);
    }

    template <class T>
    int add(draco::DataType type, std::size_t components, const std::vector<T>& values) const {
        return add_attribute<T>(mesh, draco::GeometryAttribute::GENERIC, type, components, values);
    }
};

/// Holds how Draco rounds coordinates, in its own arithmetic (attribute_quantization_transform,
/// quantization_utils).
struct Rounding {
    core::Vec3f origin{largest};
    float range = 0.0F;

    explicit Rounding(const std::vector<core::Vec3f>& positions) {
        core::Vec3f end(-largest);
        for (const core::Vec3f& p : positions) {
            origin = glm::min(origin, p);
            end = glm::max(end, p);
        }
        for (int axis = 0; axis < 3; ++axis)
            range = std::max(range, end[axis] - origin[axis]);
        if (range == 0.0F)
            range = 1.0F;
    }

    core::Vec3f operator()(const core::Vec3f& p) const {
        constexpr auto most = static_cast<float>((1 << position_bits) - 1);
        return glm::floor((p - origin) * (most / range) + 0.5F) * (range / most) + origin;
    }
};

/// Sets the bounds of the vertices that have a triangle: Draco leaves out the others.
void set_bounds(DracoMesh& made,
                const std::vector<core::Vec3f>& positions,
                const std::vector<Triangle>& triangles) {
    core::Vec3f lo(largest);
    core::Vec3f hi(-largest);
    for (const Triangle& each : triangles)
        for (const std::uint32_t v : each) {
            lo = glm::min(lo, positions[v]);
            hi = glm::max(hi, positions[v]);
        }
    const Rounding rounded(positions);
    made.lo = rounded(lo);
    made.hi = rounded(hi);
}

void describe(draco::Mesh& mesh,
              const std::vector<MeshAttribute>& attributes,
              const MeshMetadata& metadata) {
    auto about = std::make_unique<draco::GeometryMetadata>();
    for (const std::string& line : mesh_lines(metadata)) {
        const auto space = line.find(' ');
        about->AddEntryString(line.substr(0, space), line.substr(space + 1));
    }
    if (!metadata.recipe.empty())
        about->AddEntryString("recipe", metadata.recipe);
    mesh.AddMetadata(std::move(about));
    for (std::size_t i = 0; i < attributes.size(); ++i) {
        auto name = std::make_unique<draco::AttributeMetadata>();
        name->AddEntryString("name", attributes[i].name);
        mesh.AddAttributeMetadata(static_cast<int>(i) + 1, std::move(name));
    }
}

core::Result<DracoMesh> encode(const draco::Mesh& mesh) {
    draco::ExpertEncoder encoder(mesh);
    encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
    encoder.SetSpeedOptions(encoding_speed, encoding_speed);
    encoder.SetTrackEncodedProperties(true);
    // SetAttributeExplicitQuantization would store the numbers as text with six decimals (Draco 1.5).
    for (int id = 0; id < mesh.num_attributes(); ++id)
        if (mesh.attribute(id)->data_type() == draco::DT_FLOAT32)
            encoder.SetAttributeQuantization(id, id == 0 ? position_bits : value_bits);
    draco::EncoderBuffer out;
    if (const draco::Status status = encoder.EncodeToBuffer(&out); !status.ok())
        return core::fail(Error::Code::Corrupt,
                          std::string("Draco did not encode the mesh: ") + status.error_msg(),
                          "write .ply instead");
    return DracoMesh{{out.data(), out.size()},
                     encoder.num_encoded_points(),
                     encoder.num_encoded_faces(),
                     {},
                     {}};
}

} // namespace

std::vector<MeshAttribute> mesh_attributes(const core::QuadComplex& mesh,
                                           const MeshScalars& scalars) {
    std::vector<float> speeds;
    speeds.reserve(mesh.vertices());
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
        speeds.push_back(static_cast<float>(mesh.speed(static_cast<core::VertexId>(v))));
    std::vector<MeshAttribute> out;
    out.push_back(of_floats("s", narrowed<float>(mesh.s)));
    out.push_back(of_floats("t", narrowed<float>(mesh.t)));
    out.push_back(of_floats("speed", std::move(speeds)));
    MeshAttribute velocity{"velocity", mesh.velocity, 0};
    for (core::Vec3f& v : std::get<std::vector<core::Vec3f>>(velocity.values))
        if (!usable(v)) {
            v = core::Vec3f(0.0F);
            ++velocity.missing;
        }
    out.push_back(std::move(velocity));
    if (!mesh.deformation.empty())
        out.push_back(of_floats("deformation", mesh.deformation));
    out.push_back({"component", narrowed<std::uint16_t>(mesh.component), 0});
    out.push_back({"approximated", mesh.approximated, 0});
    if (!mesh.error.empty() && !scalars.contains("error")) // a field of the data has priority
        out.push_back(of_floats("error", mesh.error));
    if (!mesh.interval_error.empty() && !scalars.contains("interval_error"))
        out.push_back(of_floats("interval_error", mesh.interval_error));
    for (const auto& [name, values] : scalars)
        out.push_back(of_floats(name, values));
    return out;
}

core::Result<std::vector<core::Vec3f>> narrowed_positions(std::span<const core::Vec3> points) {
    std::vector<core::Vec3f> out;
    out.reserve(points.size());
    for (const core::Vec3& p : points) {
        out.emplace_back(p);
        if (!usable(out.back()))
            return core::fail(Error::Code::Corrupt,
                              "vertex " + std::to_string(out.size() - 1) +
                                  " is not finite, or beyond 1e38",
                              "write .vtp, .ply or .obj, which keep 64 bits");
    }
    return out;
}

core::Result<DracoMesh> encode_triangles(const core::QuadComplex& mesh,
                                         const std::vector<Triangle>& triangles,
                                         const std::vector<MeshAttribute>& attributes,
                                         const MeshMetadata* metadata) try {
    if (triangles.empty())
        return core::fail(Error::Code::InvalidArgument,
                          "the surface has no cells, and Draco cannot store an empty mesh",
                          "move the rake into the flow, or write another format");
    const auto positions = narrowed_positions(mesh.position);
    if (!positions)
        return tl::unexpected(positions.error());
    draco::Mesh out;
    out.set_num_points(static_cast<draco::PointIndex::ValueType>(mesh.vertices()));
    add_attribute<core::Vec3f>(out, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 3,
                               *positions);
    for (const MeshAttribute& each : attributes)
        std::visit(Adder{out}, each.values);
    out.SetNumFaces(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        out.SetFace(draco::FaceIndex(static_cast<std::uint32_t>(i)),
                    {draco::PointIndex(triangles[i][0]), draco::PointIndex(triangles[i][1]),
                     draco::PointIndex(triangles[i][2])});
    if (metadata != nullptr)
        describe(out, attributes, *metadata);
    return encode(out).map([&](DracoMesh&& made) {
        set_bounds(made, *positions, triangles);
        return std::move(made);
    });

} catch (const std::bad_alloc&) {

    return core::fail(Error::Code::OverLimit, "there is not enough memory to compress the mesh",
                      "ask for fewer quads, or for .ply");

} catch (const std::exception& thrown) {

    return core::fail(Error::Code::Corrupt,
                      std::string("Draco failed on the mesh: ") + thrown.what(),
                      "write .ply instead");
}

} // namespace wakesurf::protocol
