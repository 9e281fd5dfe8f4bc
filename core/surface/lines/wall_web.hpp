// The triangles of a wall, which of them meet, and the flow beside them where it lies in them: what lines along a wall go through.
#pragma once

#include "core/base/vec3.hpp"
#include "core/surface/quad_complex.hpp"

#include <glm/mat3x3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace wakesurf::core {

/// A wall, and what there is beside each of its vertices: not a number where there is nothing.
struct WallFlow {
    const QuadComplex& wall; ///< positions and cells
    std::span<const Vec3f> velocity;
    std::span<const float> values; ///< of a field
};

/// Corners of triangles are numbered from 0 to 2, and so are edges, by the corner opposite. A place in a triangle is said in parts of its corners.
class WallWeb {
  public:
    static constexpr std::uint32_t none = 0xffffffffU;

    /// How fast each part grows at each corner, a column each.
    using Rates = glm::dmat3;

    /// A triangle as it is seen across an edge of another.
    struct Beyond {
        std::uint32_t triangle;
        int opposite;      ///< its corner that the edge does not have
        int first, second; ///< those that are the other's next corners after the one opposite

        /// Returns the place in it on the edge, so far from the first to the second.
        Vec3 place(double u) const;
    };

    struct Corner {
        std::uint32_t triangle;
        int corner;
    };

    /// @param stagnation  what is slower than this part of the fastest rests. REQUIRES: `flow` outlives it.
    WallWeb(const WallFlow& flow, double stagnation);

    /// Returns what one takes, in bytes.
    static std::size_t bytes(const QuadComplex& wall);

    /// Returns the speed below which the flow rests.
    double rest() const { return rest_; }

    /// Nothing in a triangle without area, or beside which the flow is not known.
    std::optional<Rates> rates(std::uint32_t triangle) const;

    Vec3 corner(std::uint32_t triangle, int corner) const;

    /// Returns the velocity beside a corner, in the wall.
    Vec3 velocity(std::uint32_t triangle, int corner) const;

    /// Returns the edge from the next corner after the one opposite to the one after that.
    Vec3 edge(std::uint32_t triangle, int opposite) const;

    Vec3 place(std::uint32_t triangle, const Vec3& parts) const { return way(triangle, parts); }

    /// Returns how parts that change so move a place.
    Vec3 way(std::uint32_t triangle, const Vec3& rate) const;

    float value(std::uint32_t triangle, const Vec3& parts) const;

    /// Returns the parts of a place in a triangle.
    Vec3 parts(std::uint32_t triangle, const Vec3& place) const;

    /// Nothing at a border.
    std::optional<Beyond> beyond(std::uint32_t triangle, int opposite) const;

    /// Returns all corners of triangles that are at the place of this one.
    std::span<const Corner> around(std::uint32_t triangle, int corner) const;

  private:
    void join();
    void lay_into_wall();
    std::optional<std::array<Vec3, 3>> gradients(std::uint32_t triangle) const;

    const std::vector<Vec3>& position_;
    std::vector<std::array<VertexId, 3>>
        triangles_; ///< of vertices that stand for all at their places
    std::vector<std::array<std::uint32_t, 3>> beyond_; ///< 3 * triangle + corner across each edge
    std::vector<std::uint32_t> around_begin_;          ///< of each vertex, in around_
    std::vector<Corner> around_;
    std::vector<Vec3> velocity_;
    std::vector<float> value_;
    double rest_ = 0.0;
};

} // namespace wakesurf::core
