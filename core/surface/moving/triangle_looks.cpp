#include "core/surface/moving/triangle_looks.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/joins.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

/// The loops take so many triangles through the same arithmetic side by side: the compiler makes vectors of
/// the loops.
constexpr std::size_t lanes = 16;
using Floats = std::array<float, lanes>;

enum State : std::uint8_t { gone = 1, near_wall = 2 };

class Onlooker {
  public:
    Onlooker(const RefinementContext& context, TriangleLooks& looks)
        : context_(context), mesh_(context.mesh), looks_(looks),
          per_separation_(1.0 / context.rules.separation),
          shortest_(static_cast<float>(context.rules.merge * context.rules.merge)),
          bend_(context.rules.cosine > -1.0
                    ? static_cast<float>(per_separation_ * least_bend(context))
                    : std::numeric_limits<float>::infinity()) {}

    void look_at_vertex(VertexId v) const {
        const MaterialVertices& vertices = mesh_.vertices;
        if (vertices.role[v] == VertexRole::Unused)
            return;
        const double reach = context_.rules.separation;
        const Vec3& x = vertices.position[v];
        const Vec3 along_s = per_separation_ * vertices.along_s[v];
        const Vec3 along_t = per_separation_ * vertices.along_t[v];
        const bool wall =
            context_.rules.obstacle && context_.flow.may_have_wall({x - reach, x + reach});
        looks_.vertices[v] = {x, vertices.s[v], vertices.t[v], along_s, along_t};
        looks_.states[v] =
            static_cast<std::uint8_t>((vertices.dead(v) ? gone : 0) | (wall ? near_wall : 0));
        looks_.density[v] = vertices.approximated[v] != 0
                                ? 0.0f
                                : static_cast<float>(glm::length(glm::cross(along_s, along_t)));
    }

    void look_at(std::span<const TriangleId> some) const {
        Corners corners;
        for (std::size_t lane = 0; lane < lanes; ++lane)
            corners.gather(*this, lane, some[std::min(lane, some.size() - 1)]);
        Shape shape;
        find_shape(corners, shape);
        for (std::size_t lane = 0; lane < some.size(); ++lane) {
            TriangleLook& look = looks_.of[some[lane]];
            for (std::size_t k = 0; k < 3; ++k) {
                look.normal[k] = shape.normal[k][lane];
                look.cotangent[k] = shape.cotangent[k][lane];
            }
            look.flags = (corners.flags[lane] & look_dead) != 0
                             ? look_dead
                             : corners.flags[lane] | shape.flags[lane];
        }
    }

  private:
    /// The value of the edge from corner k, or at the corner, at index k.
    struct Corners {
        std::array<Floats, 3> x, y, z, ds, dt;
        std::array<std::array<Floats, 3>, 6> tangent; ///< along_s, along_t
        Floats density;
        std::array<std::uint32_t, lanes> flags;

        void gather(const Onlooker& by, std::size_t lane, TriangleId t) {
            const auto& id = by.mesh_.triangles[t].vertex;
            const TriangleLooks& looks = by.looks_;
            for (std::size_t k = 0; k < 3; ++k) {
                const VertexLook& from = looks.vertices[id[k]];
                const VertexLook& to = looks.vertices[id[(k + 1) % 3]];
                const Vec3 edge = by.per_separation_ * (to.position - from.position);
                x[k][lane] = static_cast<float>(edge.x);
                y[k][lane] = static_cast<float>(edge.y);
                z[k][lane] = static_cast<float>(edge.z);
                ds[k][lane] = static_cast<float>(by.mesh_.lattice.s_between(from.s, to.s));
                dt[k][lane] = static_cast<float>(to.t - from.t);
                for (int axis = 0; axis < 3; ++axis) {
                    tangent[static_cast<std::size_t>(axis)][k][lane] = from.along_s[axis];
                    tangent[static_cast<std::size_t>(axis) + 3][k][lane] = from.along_t[axis];
                }
            }
            density[lane] =
                std::max({looks.density[id[0]], looks.density[id[1]], looks.density[id[2]]});
            const unsigned any = looks.states[id[0]] | looks.states[id[1]] | looks.states[id[2]];
            flags[lane] =
                ((any & gone) != 0 ? look_dead : 0u) | ((any & near_wall) != 0 ? look_wall : 0u);
        }
    };

    struct Shape {
        std::array<Floats, 3> normal, cotangent;
        std::array<std::uint32_t, lanes> flags{};
    };

    /// Tests the shape. A triangle whose numbers are not finite is selected for the exact test: comparisons
    /// are written so that it does not pass.
    void find_shape(const Corners& at, Shape& shape) const {
        constexpr float room = look_room;
        constexpr float widest = 2.1f - room;
        const float bend = (1.0f - room) * bend_ * bend_;
        const float thin = static_cast<float>(thin_quality / (2.0 * std::sqrt(3.0)));
        std::array<Floats, 3> length;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            for (std::size_t i = 0; i < lanes; ++i) {
                length[k][i] =
                    at.x[k][i] * at.x[k][i] + at.y[k][i] * at.y[k][i] + at.z[k][i] * at.z[k][i];
                float turned = 0.0f;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const auto& s = at.tangent[axis];
                    const auto& t = at.tangent[axis + 3];
                    const float turn =
                        (s[k][i] - s[next][i]) * at.ds[k][i] + (t[k][i] - t[next][i]) * at.dt[k][i];
                    turned += turn * turn;
                }
                shape.flags[i] |= (length[k][i] <= 1.0f - room ? 0u : look_long << k) |
                                  (length[k][i] <= widest ? 0u : look_wide) |
                                  (length[k][i] < shortest_ ? look_small : 0u) |
                                  (turned <= bend ? 0u : look_bent << k);
            }
        }
        for (std::size_t i = 0; i < lanes; ++i) {
            const float nx = at.y[0][i] * at.z[1][i] - at.z[0][i] * at.y[1][i];
            const float ny = at.z[0][i] * at.x[1][i] - at.x[0][i] * at.z[1][i];
            const float nz = at.x[0][i] * at.y[1][i] - at.y[0][i] * at.x[1][i];
            const float area = std::sqrt(nx * nx + ny * ny + nz * nz);
            const float all = length[0][i] + length[1][i] + length[2][i];
            const float inverse = area > 1e-12f * all ? 1.0f / area : 0.0f;
            shape.normal[0][i] = nx * inverse;
            shape.normal[1][i] = ny * inverse;
            shape.normal[2][i] = nz * inverse;
            for (std::size_t k = 0; k < 3; ++k)
                shape.cotangent[k][i] = (0.5f * all - length[k][i]) * inverse;
            const float material = std::abs(at.ds[0][i] * at.dt[1][i] - at.ds[1][i] * at.dt[0][i]);
            constexpr auto most = static_cast<float>(web_density) * (1.0f - room);
            const float covered = most * at.density[i] * material;
            shape.flags[i] |= (inverse > 0.0f ? 0u : look_no_shape) |
                              (area >= thin * all ? 0u : look_small) |
                              (at.density[i] > 0.0f && area > covered ? look_web : 0u);
        }
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    TriangleLooks& looks_;
    double per_separation_;
    float shortest_, bend_; ///< in separations; the first squared
};

} // namespace

void look_at_all(const RefinementContext& context, TriangleLooks& looks) {
    const MovingMesh& mesh = context.mesh;
    const auto slots = mesh.triangles.slots();
    looks.vertices.resize(mesh.vertices.slots());
    looks.density.resize(mesh.vertices.slots());
    looks.states.resize(mesh.vertices.slots());
    looks.of.resize(slots.size());
    const Onlooker onlooker(context, looks);
    for_each_index(mesh.vertices.slots(), [&](std::size_t v) {
        if (!context.stop.stop_requested())
            onlooker.look_at_vertex(static_cast<VertexId>(v));
    });
    for_each_index((slots.size() + lanes - 1) / lanes, [&](std::size_t block) {
        std::array<TriangleId, lanes> some;
        std::size_t count = 0;
        for (std::size_t t = block * lanes; t < std::min((block + 1) * lanes, slots.size()); ++t) {
            some[count] = static_cast<TriangleId>(t);
            count += slots[t].live;
        }
        if (count > 0 && !context.stop.stop_requested())
            onlooker.look_at({some.data(), count});
    });
}

bool may_meet_wall(const TriangleLooks& looks, VertexId v) {
    return (looks.states[v] & near_wall) != 0;
}

} // namespace wakesurf::core
