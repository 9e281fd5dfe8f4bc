#include "protocol/files/mesh_ply.hpp"

#include "protocol/files/mesh_metadata.hpp"
#include "protocol/files/mesh_triangles.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace wakesurf::protocol {

namespace {

/// The coefficients of Matt Zucker's fit of the table (CC0), constant first.
constexpr double coefficients[3][7] = {
    {0.2777273272234177, 0.1050930431085774, -0.3308618287255563, -4.634230498983486,
     6.228269936347081, 4.776384997670288, -5.435455855934631},
    {0.005407344544966578, 1.404613529898575, 0.214847559468213, -5.799100973351585,
     14.17993336680509, -13.74514537774601, 4.645852612178535},
    {0.3340998053353061, 1.384590162594685, 0.09509516302823659, -19.33244095627987,
     56.69055260068105, -65.35303263337234, 26.3124352495832}};

// The sRGB colour of a value from 0 to 1 by the colour map viridis (Smith, van der Walt; CC0); other values get the colour of the
// nearer end, NaN the lower one's. Within 4 of 255 of the table in web-client/src/scene/surface/colourMap.ts.
std::array<std::uint8_t, 3> viridis(double value) {
    const double x = value > 0.0 ? std::min(value, 1.0) : 0.0; // NaN is not above 0
    std::array<std::uint8_t, 3> out{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        for (std::size_t k = 7; k-- > 0;)
            sum = sum * x + coefficients[channel][k];
        out[channel] = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(sum, 0.0, 1.0)));
    }
    return out;
}

struct Faces {
    std::string bytes;
    std::size_t count = 0;

    void add(const std::uint32_t* vertices, std::size_t corners) {
        put_bytes(bytes, static_cast<std::uint8_t>(corners));
        for (std::size_t i = 0; i < corners; ++i)
            put_bytes(bytes, static_cast<std::int32_t>(vertices[i]));
        ++count;
    }
};

Faces faces_of(const core::QuadComplex& mesh) {
    Faces faces;
    faces.bytes.reserve(mesh.cells.size() * 17);
    std::vector<Triangle> cut;
    for (const core::Cell& cell : mesh.cells) {
        const core::CellPolygon outline = core::polygon(cell);
        if (outline.count == 4) {
            faces.add(outline.vertex.data(), 4);
            continue;
        }
        cut.clear();
        append_triangles(mesh, cell, cut);
        for (const Triangle& each : cut)
            faces.add(each.data(), 3);
    }
    return faces;
}

/// Holds the speed of the slowest and of the fastest vertex, between which the colours lie; both 0 without
/// vertices.
struct SpeedRange {
    float lo = 0.0F, hi = 0.0F;

    explicit SpeedRange(const std::vector<float>& speeds) {
        bool any = false;
        for (const float speed : speeds) {
            if (!std::isfinite(speed))
                continue;
            lo = any ? std::min(lo, speed) : speed;
            hi = any ? std::max(hi, speed) : speed;
            any = true;
        }
    }

    std::array<std::uint8_t, 3> colour(float speed) const {
        return viridis(hi > lo ? double(speed - lo) / double(hi - lo) : 0.0);
    }
};

/// Of the longest side at a vertex: what the page draws as half the longer axis of an ellipse.
constexpr double radius_of_side = 0.85;

/// Returns the radii of discs at the vertices, each as large as its neighbours are away.
std::vector<float> disc_radii(const core::QuadComplex& mesh,
                              const std::vector<Triangle>& triangles) {
    std::vector<float> radii(mesh.vertices(), 0.0F);
    for (const Triangle& each : triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t from = each[i], to = each[(i + 1) % 3];
            const auto radius = static_cast<float>(
                radius_of_side * glm::distance(mesh.position[from], mesh.position[to]));
            radii[from] = std::max(radii[from], radius);
            radii[to] = std::max(radii[to], radius);
        }
    return radii;
}

/// Returns the errors that are estimated, with their names; a field of the data with that name has priority.
std::map<std::string, std::span<const float>> errors_of(const core::QuadComplex& mesh,
                                                        const MeshScalars& scalars) {
    std::map<std::string, std::span<const float>> out;
    if (!mesh.error.empty() && !scalars.contains("error"))
        out["error"] = mesh.error;
    if (!mesh.interval_error.empty() && !scalars.contains("interval_error"))
        out["interval_error"] = mesh.interval_error;
    return out;
}

std::string header(const core::QuadComplex& mesh,
                   const MeshMetadata& metadata,
                   const MeshScalars& scalars,
                   const SpeedRange& range,
                   std::optional<std::size_t> faces) {
    std::string text = ply_head(metadata);
    text += "comment colours viridis, speed " + number_text(range.lo) + " to " +
            number_text(range.hi) + "\ncomment texture s, t\n";
    text += "element vertex " + std::to_string(mesh.vertices()) + "\n";
    for (const char* name : {"x", "y", "z", "s", "t"})
        text += std::string("property double ") + name + "\n";
    for (const char* name : {"speed", "vx", "vy", "vz", "nx", "ny", "nz", "u", "v"})
        text += std::string("property float ") + name + "\n";
    for (const char* name : {"red", "green", "blue"})
        text += std::string("property uchar ") + name + "\n";
    if (!mesh.deformation.empty())
        text += "property float deformation\n";
    text += "property uint component\nproperty uchar approximated\n";
    for (const auto& [name, values] : errors_of(mesh, scalars))
        text += "property float " + name + "\n";
    if (!faces)
        text += "property float radius\n";
    for (const std::string& name : one_word_names(scalars, {"x",
                                                            "y",
                                                            "z",
                                                            "s",
                                                            "t",
                                                            "speed",
                                                            "vx",
                                                            "vy",
                                                            "vz",
                                                            "nx",
                                                            "ny",
                                                            "nz",
                                                            "u",
                                                            "v",
                                                            "red",
                                                            "green",
                                                            "blue",
                                                            "deformation",
                                                            "component",
                                                            "approximated",
                                                            faces ? "" : "radius"}))
        text += "property float " + name + "\n";
    if (faces)
        text +=
            "element face " + std::to_string(*faces) + "\nproperty list uchar int vertex_indices\n";
    return text + "end_header\n";
}

} // namespace

std::string mesh_ply(const core::QuadComplex& mesh,
                     const MeshMetadata& metadata,
                     const MeshScalars& scalars,
                     PlyElements elements) {
    const bool points = elements == PlyElements::Points;
    const Faces faces = points ? Faces() : faces_of(mesh);
    const auto triangles = triangles_of(mesh);
    const auto normals = vertex_normals(mesh, triangles);
    const auto radii = points ? disc_radii(mesh, triangles) : std::vector<float>();
    std::vector<float> speeds;
    speeds.reserve(mesh.vertices());
    for (std::size_t v = 0; v < mesh.vertices(); ++v)
        speeds.push_back(static_cast<float>(mesh.speed(static_cast<core::VertexId>(v))));
    const SpeedRange range(speeds);
    std::string out =
        header(mesh, metadata, scalars, range, points ? std::nullopt : std::optional(faces.count));
    const auto errors = errors_of(mesh, scalars);
    out.reserve(out.size() + mesh.vertices() * (88 + 4 * scalars.size()) + faces.bytes.size());
    for (std::size_t v = 0; v < mesh.vertices(); ++v) {
        put_bytes(out, mesh.position[v]);
        put_bytes(out, mesh.s[v]);
        put_bytes(out, mesh.t[v]);
        put_bytes(out, speeds[v]);
        put_bytes(out, mesh.velocity[v]);
        put_bytes(out, normals[v]);
        put_bytes(out, static_cast<float>(mesh.s[v]));
        put_bytes(out, static_cast<float>(mesh.t[v]));
        put_bytes(out, range.colour(speeds[v]));
        if (!mesh.deformation.empty())
            put_bytes(out, mesh.deformation[v]);
        put_bytes(out, mesh.component[v]);
        put_bytes(out, mesh.approximated[v]);
        for (const auto& [name, values] : errors)
            put_bytes(out, values[v]);
        if (points)
            put_bytes(out, radii[v]);
        for (const auto& [name, values] : scalars) {
            assert(values.size() == mesh.vertices());
            put_bytes(out, values[v]);
        }
    }
    return out + faces.bytes;
}

} // namespace wakesurf::protocol
