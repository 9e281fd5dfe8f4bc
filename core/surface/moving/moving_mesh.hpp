// The mesh of a streak or time surface as it moves: material vertices, triangles, and the rectangle of its
// parameters. A vertex knows its place on the rake and its release time, so that it can be traced
// again, and the surface's tangents. Structure of arrays in mesh order, as advection wants it.
#pragma once

#include "core/integrate/particles.hpp"
#include "core/surface/carried_error.hpp"
#include "core/surface/moving/material_triangles.hpp"
#include "core/surface/quad_complex.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace wakesurf::core {

/// The role of a vertex. Free: carried by the flow. Attached: on the rake, to be released. Unused: an empty
/// slot.
enum class VertexRole : std::uint8_t { Free, Attached, Unused };

inline SurfaceTangents tangents_of(const Carried& at) {
    return {at.along_s, at.along_t, at.expansion};
}

/// The possible distance of a vertex from the true surface.
struct VertexError {
    CarriedError traced; ///< by the integrator's steps, as if it had been traced from the rake
    /// The error by interpolation, its own or that of the vertices it was interpolated from; 0 if it is
    /// traced again.
    CarriedError placed;
    CarriedDistance apart; ///< by both, in any direction, from the particle it stands for

    /// Returns the error half-way between two vertices.
    static VertexError between(const VertexError& a, const VertexError& b) {
        return {CarriedError::between(a.traced, b.traced),
                CarriedError::between(a.placed, b.placed),
                CarriedDistance::between(a.apart, b.apart)};
    }

    double across(const SurfaceTangents& at) const {
        const double volume = at.volume();
        return traced.across(volume) + placed.across(volume);
    }
};

/// The data of a new vertex.
struct MaterialPoint {
    Carried carried;
    double s = 0.0;
    double t = 0.0;          ///< release time, or place across the patch
    float birth_area = 0.0f; ///< |dx/ds x dx/dt| at release
    bool approximated = false;
    VertexError error;
};

/// A vertex takes so many bytes in all arrays.
inline constexpr std::size_t vertex_bytes =
    3 * sizeof(Vec3) + sizeof(Vec3f) + 3 * sizeof(double) + 2 * sizeof(float) + sizeof(CurveEnd) +
    2 * sizeof(std::uint32_t) + sizeof(VertexRole) + sizeof(std::uint8_t) + sizeof(VertexError);

class MaterialVertices {
  public:
    /// Puts a vertex into an empty slot. @param time simulation time it holds at
    VertexId add(const MaterialPoint& point, VertexRole role, double time);

    /// For so many vertices beyond those that there are.
    void make_room(std::size_t more);

    /// Empty slots and ids for so many vertices, each to be filled by begin().
    std::vector<VertexId> take_slots(std::size_t count);

    /// Fills a slot that was taken; several threads may, of different slots.
    void begin(VertexId v, const MaterialPoint& point, VertexRole role, double time);

    void remove(VertexId v);

    std::size_t slots() const { return role.size(); }

    std::size_t used() const { return role.size() - free_.size(); }

    MaterialPoint point(VertexId v) const;

    /// Overwrites what is known of a vertex, its id and role staying.
    void set(VertexId v, const MaterialPoint& point);

    SurfaceTangents tangents(VertexId v) const {
        return {along_s[v], along_t[v], double(expansion[v])};
    }

    /// Returns the particles for Flow::advance: only free, living vertices are Running.
    Particles particles();

    bool dead(VertexId v) const {
        return end[v] != CurveEnd::Running &&
               !(role[v] == VertexRole::Attached && end[v] == CurveEnd::Time);
    }

    /// Free, and under way.
    bool running(VertexId v) const {
        return role[v] == VertexRole::Free && end[v] == CurveEnd::Running;
    }

    /// Moves each vertex to the slot it has in `order`, which names every used one once.
    void renumber(std::span<const VertexId> order);

    /// Returns the id of the vertex that is made next.
    std::uint32_t next_id() const { return next_id_; }

    /// Sets the id of the first vertex. REQUIRES: none has been made.
    void number_from(std::uint32_t first) { next_id_ = first; }

    std::size_t bytes() const;

    /// The tangents lean towards each other as the flow shears: in single precision the area between them was off by 2 % where the
    /// product of their lengths is 4e6 times it.
    std::vector<Vec3> position, along_s, along_t;
    std::vector<float> expansion; ///< as of Carried
    std::vector<double> time;
    std::vector<CurveEnd> end; ///< Running; Time while attached; else why it is dead
    std::vector<double> s, t;
    std::vector<Vec3f> velocity; ///< at the surface's time, as of the last sample
    std::vector<float> birth_area;
    std::vector<std::uint32_t> id;
    std::vector<VertexRole> role;
    std::vector<std::uint8_t> approximated;
    std::vector<VertexError> error;
    std::vector<std::uint32_t> cell; ///< of a mesh of cells: see Particles

    /// Vertices that have been made or released since the list was last cleared: perhaps nothing has used them yet.
    std::vector<VertexId>& fresh() { return fresh_; }

  private:
    std::vector<VertexId> free_, fresh_;
    std::uint32_t next_id_ = 0;
};

/// The rectangle of s and t. A closed rake's s = 1 is its s = 0.
struct ParameterRectangle {
    bool closed = false;
    bool patch = false;   ///< t goes from 0 to 1; a streak surface has no last row
    double first_t = 0.0; ///< of the row that was released first
    /// The sign of the area in (s, t) of the triangles in the order of their vertices: 1 or -1.
    double facing = 1.0;

    /// Returns the difference from one seed parameter to another the short way round.
    double s_between(double from, double to) const {
        return closed ? to - from - std::round(to - from) : to - from;
    }

    double wrapped_s(double s) const { return closed ? s - std::floor(s) : s; }

    /// Whether the first row has this t, or the last.
    bool on_end(double t) const { return t == first_t || (patch && t == 1.0); }
};

/// The difference of two places in the parameter rectangle.
struct ParameterStep {
    double s, t;
};

struct MovingMesh {
    MaterialVertices vertices;
    MaterialTriangles triangles;
    ParameterRectangle rectangle;
    double time = 0.0; ///< simulation time the living vertices hold at

    ParameterStep parameter_step(VertexId a, VertexId b) const {
        return {rectangle.s_between(vertices.s[a], vertices.s[b]), vertices.t[b] - vertices.t[a]};
    }

    Vec3 edge(VertexId a, VertexId b) const { return vertices.position[b] - vertices.position[a]; }

    double edge_length(VertexId a, VertexId b) const {
        return glm::length(vertices.position[a] - vertices.position[b]);
    }
};

inline std::size_t memory_of(const MovingMesh& mesh) {
    return mesh.vertices.bytes() + mesh.triangles.bytes();
}

/// A vertex takes so many bytes more while the mesh to show is made.
inline constexpr std::size_t shown_bytes = 250;

/// Returns the memory with that of a step: tests of triangles, samples, an array that grows.
/// @param cuts  as many edges are about to be cut: each becomes two triangles and a vertex more
inline std::size_t memory_while_moving(const MovingMesh& mesh, std::size_t cuts = 0) {
    const std::size_t kept = memory_of(mesh) + cuts * (2 * sizeof(Triangle) + vertex_bytes);
    return kept + 7 * kept / 8;
}

} // namespace wakesurf::core
