#include "core/surface/moving/scan.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/cuts.hpp"
#include "core/surface/moving/flips.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/joins.hpp"
#include "core/surface/moving/pairing.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>

namespace wakesurf::core {

namespace {

/// One of so many steps looks at what has not changed for joining and a better other half.
constexpr std::uint64_t turns = 6;

/// What single precision may be off by, and some more.
constexpr float room = 1e-4f;

/// Normals that differ by more: the corners of the quad are not the sums of its triangles' angles.
constexpr float flat = 0.9f;
constexpr float poor_corner = 0.31f; ///< sine; with room above that of pairs that are poor

enum Flag : std::uint8_t { dead = 1, long_edge = 2, may_join = 4, web = 8 };

enum Need : std::uint8_t { flipping = 1, cutting = 2, joining = 4, pairing = 8 };

class Scan {
  public:
    Scan(const RefinementContext& context, ScanMemory& memory)
        : context_(context), mesh_(context.mesh), triangles_(context.mesh.triangles),
          memory_(memory), longest_(static_cast<float>(context.longest_allowed())),
          shortest_(static_cast<float>(context.squared_separation(context.rules.merge))) {}

    void look_at_vertex(VertexId v) const {
        const MaterialVertices& vertices = mesh_.vertices;
        if (vertices.role[v] == VertexRole::Unused || context_.stop.stop_requested())
            return;
        const double reach = context_.rules.separation;
        const Vec3& x = vertices.position[v];
        memory_.near_wall[v] =
            context_.rules.obstacle && context_.flow.may_have_wall({x - reach, x + reach});
        memory_.density[v] = vertices.approximated[v] != 0
                                 ? 0.0f
                                 : static_cast<float>(glm::length(
                                       glm::cross(vertices.along_s[v], vertices.along_t[v])));
    }

    void look_at(TriangleId t) const {
        TriangleLook& look = memory_.looks[t];
        look = {};
        const auto& [a, b, c] = triangles_[t].vertex;
        if (has_dead_vertex(mesh_, t)) {
            look.flags = dead;
            return;
        }
        const auto& x = mesh_.vertices.position;
        const std::array<Vec3f, 3> edge{Vec3f(x[b] - x[a]), Vec3f(x[c] - x[b]), Vec3f(x[a] - x[c])};
        std::array<float, 3> length;
        for (unsigned k = 0; k < 3; ++k)
            length[k] = glm::dot(edge[k], edge[k]);
        const Vec3f normal = glm::cross(edge[0], edge[1]);
        const float area = glm::length(normal);
        const float all = length[0] + length[1] + length[2];
        const float inverse = area > 1e-12f * all ? 1.0f / area : 0.0f;
        look.normal = normal * inverse;
        for (unsigned k = 0; k < 3; ++k)
            look.cotangent[k] = (0.5f * all - length[k]) * inverse;
        // What is no number, or has no area, is left to the exact rules.
        if (!(std::max({length[0], length[1], length[2]}) <= (1.0f - room) * longest_) ||
            inverse == 0.0f)
            look.flags |= long_edge;
        if (std::min({length[0], length[1], length[2]}) < shortest_ || !(area >= thin_ * all))
            look.flags |= may_join;
        const float density =
            std::max({memory_.density[a], memory_.density[b], memory_.density[c]});
        const ParameterStep p = mesh_.parameter_step(a, b);
        const ParameterStep q = mesh_.parameter_step(a, c);
        const float material = static_cast<float>(std::abs(p.s * q.t - q.s * p.t));
        if (density > 0.0f && area > (1.0f - room) * web_density * density * material)
            look.flags |= web;
    }

    std::uint8_t needs(TriangleId t, bool turn) const {
        const TriangleLook& look = memory_.looks[t];
        if ((look.flags & dead) != 0)
            return cutting;
        const Triangle& here = triangles_[t];
        std::uint8_t needs =
            turn && context_.rules.merge > 0.0 && (look.flags & may_join) != 0 ? joining : 0;
        bool cut = (look.flags & (long_edge | web)) != 0;
        bool pair = here.odd() || (look.flags & long_edge) != 0;
        for (unsigned k = 0; k < 3; ++k) {
            const TriangleId u = here.across[k];
            if (u != no_triangle && u < t)
                continue; // that one looks at this edge
            const VertexId a = here.begin(k), b = here.end(k);
            cut = cut || may_bulge(a, b) ||
                  (memory_.near_wall[a] != 0 &&
                   crosses_obstacle(context_, a, b, squared_length(mesh_, a, b)));
            if (u == no_triangle)
                continue;
            const TriangleLook& beyond = memory_.looks[u];
            const float bend = glm::dot(look.normal, beyond.normal);
            cut = cut || bend < static_cast<float>(context_.rules.cosine) + room;
            const unsigned j = triangles_.facing(t, k);
            if ((look.cotangent[k] + beyond.cotangent[j] < room ||
                 ((look.flags | beyond.flags) & web) != 0) &&
                should_flip(context_, t, k))
                needs |= flipping;
            pair = pair || (turn && here.paired() && here.mate == k &&
                            (bend < flat || has_poor_corner(look, k, beyond, j)));
        }
        if (cut && needs_cut(context_, t))
            needs |= cutting;
        if (pair && is_poor_pair(context_, t))
            needs |= pairing;
        return needs;
    }

  private:
    bool may_bulge(VertexId a, VertexId b) const {
        const float bend = static_cast<float>(least_bend(context_));
        return context_.rules.cosine > -1.0 &&
               static_cast<float>(squared(edge_turn(mesh_, a, b))) > (1.0f - room) * bend * bend;
    }

    /// Of the quad across edge k: opposite to it, or at its ends, where two angles add up.
    static bool
    has_poor_corner(const TriangleLook& here, unsigned k, const TriangleLook& beyond, unsigned j) {
        constexpr float most = 1.0f / (poor_corner * poor_corner);
        const auto thin = [&](float cotangent) { return 1.0f + cotangent * cotangent > most; };
        const auto thin_sum = [&](float p, float q) {
            const float sum = p + q;
            return !(sum > 0.0f) || (1.0f + p * p) * (1.0f + q * q) > most * sum * sum;
        };
        return thin(here.cotangent[k]) || thin(beyond.cotangent[j]) ||
               thin_sum(here.cotangent[(k + 1) % 3], beyond.cotangent[(j + 2) % 3]) ||
               thin_sum(here.cotangent[(k + 2) % 3], beyond.cotangent[(j + 1) % 3]);
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    const MaterialTriangles& triangles_;
    ScanMemory& memory_;
    float longest_, shortest_; ///< squared
    float thin_ = static_cast<float>(thin_quality / (2.0 * std::sqrt(3.0)));
};

} // namespace

Needs scan(const RefinementContext& context, std::uint64_t turn, ScanMemory& memory) {
    const MovingMesh& mesh = context.mesh;
    const auto slots = mesh.triangles.slots();
    memory.density.resize(mesh.vertices.slots());
    memory.near_wall.resize(mesh.vertices.slots());
    memory.looks.resize(slots.size());
    memory.needs.assign(slots.size(), 0);
    const Scan scan(context, memory);
    for_each_index(mesh.vertices.slots(),
                   [&](std::size_t v) { scan.look_at_vertex(static_cast<VertexId>(v)); });
    const auto each = [&](auto visit) {
        for_each_index(slots.size(), [&](std::size_t i) {
            if (slots[i].live && !context.stop.stop_requested())
                visit(static_cast<TriangleId>(i));
        });
    };
    each([&](TriangleId t) { scan.look_at(t); });
    each([&](TriangleId t) { memory.needs[t] = scan.needs(t, (t + turn) % turns == 0); });
    Needs found;
    for (TriangleId t = 0; t < slots.size(); ++t) {
        const std::uint8_t needs = memory.needs[t];
        if ((needs & flipping) != 0)
            found.flipping.push_back(t);
        if ((needs & cutting) != 0)
            found.cutting.push_back(t);
        if ((needs & joining) != 0)
            found.joining.push_back(t);
        if ((needs & pairing) != 0)
            found.pairing.push_back(t);
    }
    return found;
}

} // namespace wakesurf::core
