#include "core/surface/moving/scan.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/edge_changes.hpp"
#include "core/surface/moving/joins.hpp"
#include "core/surface/moving/pairing.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace wakesurf::core {

namespace {

/// Single precision may be off by this, and some more.
constexpr float metric_margin = 1e-4f;

/// The tests. Edges have three bits each: the first << k.
enum TriangleFlag : std::uint32_t {
    flag_dead = 1,      ///< a vertex is; nothing else is said then
    flag_small = 2,     ///< an edge is short, or the triangle thin
    flag_bridging = 4,  ///< may be one
    flag_wall = 8,      ///< an edge may meet one
    flag_no_shape = 16, ///< no area, or not a number
    flag_wide = 32,     ///< an edge is too long for a diagonal
    flag_long = 64,
    flag_bent = 512,
};

constexpr std::uint32_t flag_any_long = 7 * flag_long;

/// The loops take so many triangles through the same arithmetic side by side: the compiler makes vectors of
/// the loops.
constexpr std::size_t lanes = 16;
/// So many blocks of triangles are done by one thread: 13 shares for 200,000 triangles were too few for 16 cores.
constexpr std::size_t blocks_together = 64;
using Floats = std::array<float, lanes>;

enum State : std::uint8_t { gone = 1, near_wall = 2 };

class TriangleProbe {
  public:
    TriangleProbe(const RefinementContext& context, MeshMetrics& metrics)
        : context_(context), mesh_(context.mesh), metrics_(metrics),
          per_separation_(1.0 / context.rules.separation),
          shortest_(static_cast<float>(context.rules.merge * context.rules.merge)),
          bend_(context.rules.cosine > -1.0
                    ? static_cast<float>(per_separation_ * least_bend(context))
                    : std::numeric_limits<float>::infinity()) {}

    void measure_vertex(VertexId v) const {
        const MaterialVertices& vertices = mesh_.vertices;
        if (vertices.role[v] == VertexRole::Unused)
            return;
        const double reach = context_.rules.separation;
        const Vec3& x = vertices.position[v];
        const Vec3 along_s = per_separation_ * vertices.along_s[v];
        const Vec3 along_t = per_separation_ * vertices.along_t[v];
        const bool wall =
            context_.rules.obstacle && context_.flow.may_have_wall({x - reach, x + reach});
        metrics_.vertices[v] = {x, vertices.s[v], vertices.t[v], along_s, along_t};
        metrics_.states[v] =
            static_cast<std::uint8_t>((vertices.dead(v) ? gone : 0) | (wall ? near_wall : 0));
        metrics_.density[v] = vertices.approximated[v] != 0
                                  ? 0.0f
                                  : static_cast<float>(glm::length(glm::cross(along_s, along_t)));
    }

    void measure(std::span<const TriangleId> some) const {
        Corners corners;
        for (std::size_t lane = 0; lane < lanes; ++lane)
            corners.gather(*this, lane, some[std::min(lane, some.size() - 1)]);
        Shape shape;
        find_shape(corners, shape);
        for (std::size_t lane = 0; lane < some.size(); ++lane) {
            TriangleMetrics& measured = metrics_.of[some[lane]];
            for (std::size_t k = 0; k < 3; ++k) {
                measured.normal[k] = shape.normal[k][lane];
                measured.cotangent[k] = shape.cotangent[k][lane];
            }
            measured.flags = (corners.flags[lane] & flag_dead) != 0
                                 ? flag_dead
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

        void gather(const TriangleProbe& by, std::size_t lane, TriangleId t) {
            const auto& id = by.mesh_.triangles[t].vertex;
            const MeshMetrics& metrics = by.metrics_;
            for (std::size_t k = 0; k < 3; ++k) {
                const VertexMetrics& from = metrics.vertices[id[k]];
                const VertexMetrics& to = metrics.vertices[id[(k + 1) % 3]];
                const Vec3 edge = by.per_separation_ * (to.position - from.position);
                x[k][lane] = static_cast<float>(edge.x);
                y[k][lane] = static_cast<float>(edge.y);
                z[k][lane] = static_cast<float>(edge.z);
                ds[k][lane] = static_cast<float>(by.mesh_.rectangle.s_between(from.s, to.s));
                dt[k][lane] = static_cast<float>(to.t - from.t);
                for (int axis = 0; axis < 3; ++axis) {
                    tangent[static_cast<std::size_t>(axis)][k][lane] = from.along_s[axis];
                    tangent[static_cast<std::size_t>(axis) + 3][k][lane] = from.along_t[axis];
                }
            }
            density[lane] =
                std::max({metrics.density[id[0]], metrics.density[id[1]], metrics.density[id[2]]});
            const unsigned any =
                metrics.states[id[0]] | metrics.states[id[1]] | metrics.states[id[2]];
            flags[lane] =
                ((any & gone) != 0 ? flag_dead : 0u) | ((any & near_wall) != 0 ? flag_wall : 0u);
        }
    };

    struct Shape {
        std::array<Floats, 3> normal, cotangent;
        std::array<std::uint32_t, lanes> flags{};
    };

    /// Tests the shape. A triangle whose numbers are not finite is selected for the exact test: comparisons
    /// are written so that it does not pass.
    void find_shape(const Corners& at, Shape& shape) const {
        constexpr float room = metric_margin;
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
                shape.flags[i] |= (length[k][i] <= 1.0f - room ? 0u : flag_long << k) |
                                  (length[k][i] <= widest ? 0u : flag_wide) |
                                  (length[k][i] < shortest_ ? flag_small : 0u) |
                                  (turned <= bend ? 0u : flag_bent << k);
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
            constexpr auto most = static_cast<float>(bridging_density) * (1.0f - room);
            const float covered = most * at.density[i] * material;
            shape.flags[i] |= (inverse > 0.0f ? 0u : flag_no_shape) |
                              (area >= thin * all ? 0u : flag_small) |
                              (at.density[i] > 0.0f && area > covered ? flag_bridging : 0u);
        }
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    MeshMetrics& metrics_;
    double per_separation_;
    float shortest_, bend_; ///< in separations; the first squared
};

/// Computes the metrics in parallel. Cost: O(triangles).
void measure_triangles(const RefinementContext& context, MeshMetrics& metrics) {
    const MovingMesh& mesh = context.mesh;
    const auto slots = mesh.triangles.slots();
    metrics.vertices.resize(mesh.vertices.slots());
    metrics.density.resize(mesh.vertices.slots());
    metrics.states.resize(mesh.vertices.slots());
    metrics.of.resize(slots.size());
    const TriangleProbe probe(context, metrics);
    for_each_index(mesh.vertices.slots(), [&](std::size_t v) {
        if (!context.stop.stop_requested())
            probe.measure_vertex(static_cast<VertexId>(v));
    });
    for_each_index((slots.size() + lanes - 1) / lanes,
                   [&](std::size_t block) {
                       std::array<TriangleId, lanes> some;
                       std::size_t count = 0;
                       for (std::size_t t = block * lanes;
                            t < std::min((block + 1) * lanes, slots.size()); ++t) {
                           some[count] = static_cast<TriangleId>(t);
                           count += slots[t].live;
                       }
                       if (count > 0 && !context.stop.stop_requested())
                           probe.measure({some.data(), count});
                   },
                   blocks_together);
}

/// True where an edge from the vertex may meet a wall.
bool may_meet_wall(const MeshMetrics& metrics, VertexId v) {
    return (metrics.states[v] & near_wall) != 0;
}

/// The period, in steps, of testing unchanged triangles for joining and a better other half.
constexpr std::uint64_t turns = 12;

/// If normals differ by more, the corners of the quad are not the sums of its triangles' angles.
constexpr float flat = 0.9f;
constexpr float poor_corner = 0.31f; ///< sine; with room above that of pairs that are poor
constexpr float open_corner = 0.6f;  ///< cotangent: 59 degrees, with room above is_diagonal()'s
constexpr float nearly_flat = 0.99f;

enum Need : std::uint8_t { flipping = 1, cutting = 2, joining = 4, pairing = 8 };

/// The loops take so many triangles, and their edges, through the same arithmetic side by side.
constexpr std::size_t at_once = 16;

/// The questions to the exact rules about some triangles, and the answers.
class Scan {
  public:
    Scan(const RefinementContext& context, std::uint64_t turn, ScanMemory& memory)
        : context_(context), mesh_(context.mesh), triangles_(context.mesh.triangles),
          metrics_(memory.metrics), needs_(memory.needs), turn_(turn),
          cosine_(static_cast<float>(context.rules.cosine)) {}

    void measure(std::span<const TriangleId> some) const {
        Edges edges = edges_of(some);
        edges.compare(cosine_);
        std::array<std::uint32_t, at_once> may{};
        for (std::size_t i = 0; i < edges.count; ++i)
            may[edges.owner[i]] |= edges.may[i] << (edges.k[i] * edge_bits);
        for (std::size_t i = 0; i < some.size(); ++i)
            needs_[some[i]] = needs(some[i], may[i]);
    }

    /// Neighbours are anywhere in memory: a quarter of a profile's samples waited for them.
    void fetch_neighbours(std::size_t begin, std::size_t end) const {
        for (std::size_t t = begin; t < end; ++t)
            for (const TriangleId u : triangles_.slots()[t].across)
                if (u < triangles_.slots().size()) {
                    __builtin_prefetch(&triangles_.slots()[u]);
                    __builtin_prefetch(&metrics_.of[u]);
                }
    }

  private:
    /// The possible changes of an edge.
    enum May : std::uint32_t { cut = 1, flip = 2, part = 4 };

    static constexpr std::uint32_t edge_bits = 3;
    static constexpr std::uint32_t every_edge = 1 | 1 << edge_bits | 1 << 2 * edge_bits;

    /// Edges, each between two triangles, of which the one with the smaller number, or the only one, owns it.
    struct Edges {
        enum Is : std::uint32_t { bent = 1, lengthy = 2, plain = 4, bridged = 8, halved = 16 };

        static constexpr std::size_t most = 3 * at_once;
        template <class T>
        using Column = std::array<T, most>;

        std::size_t count = 0;
        Column<std::uint32_t> owner, k;
        Column<float> bend; ///< cosine
        /// Hold the cotangents of the angles opposite to the edge, at its beginning and at its end.
        std::array<Column<float>, 3> cotangent, cotangent_beyond;
        Column<std::uint32_t> is; ///< bits of Is
        Column<std::uint32_t> may;

        void compare(float cosine) {
            for (std::size_t i = 0; i < count; ++i) {
                const float p = cotangent[0][i], q = cotangent_beyond[0][i];
                const float p1 = cotangent[1][i], q1 = cotangent_beyond[1][i];
                const float p2 = cotangent[2][i], q2 = cotangent_beyond[2][i];
                // The cotangent of a sum of angles is (p q - 1) / (p + q). No branches: vectors have none.
                const unsigned open = unsigned{std::abs(p) < open_corner} &
                                      unsigned{std::abs(q) < open_corner} &
                                      unsigned{std::abs(p1 * q1 - 1.0f) < open_corner * (p1 + q1)} &
                                      unsigned{std::abs(p2 * q2 - 1.0f) < open_corner * (p2 + q2)} &
                                      unsigned{bend[i] > nearly_flat};
                constexpr float most_squared = 1.0f / (poor_corner * poor_corner);
                const float sum1 = p1 + q1, sum2 = p2 + q2;
                const float sines1 = (1.0f + p1 * p1) * (1.0f + q1 * q1);
                const float sines2 = (1.0f + p2 * p2) * (1.0f + q2 * q2);
                const unsigned fair =
                    unsigned{1.0f + p * p <= most_squared} &
                    unsigned{1.0f + q * q <= most_squared} & unsigned{sum1 > 0.0f} &
                    unsigned{sum2 > 0.0f} & unsigned{sines1 <= most_squared * sum1 * sum1} &
                    unsigned{sines2 <= most_squared * sum2 * sum2} & unsigned{bend[i] >= flat};
                const unsigned uneven = unsigned{!(bend[i] >= cosine + metric_margin)};
                const unsigned obtuse = unsigned{!(p + q >= metric_margin)};
                const unsigned stays = open & is[i] / plain;
                may[i] = ((is[i] / bent | uneven | (is[i] / lengthy & ~stays)) & 1u) * cut |
                         ((is[i] / bridged | obtuse) & 1u) * flip |
                         (is[i] / halved & ~fair & 1u) * part;
            }
        }
    };

    /// Returns the edges that some triangles own.
    Edges edges_of(std::span<const TriangleId> some) const {
        Edges edges;
        for (std::size_t owner = 0; owner < some.size(); ++owner)
            for (unsigned k = 0; k < 3; ++k) {
                edges.owner[edges.count] = static_cast<std::uint32_t>(owner);
                edges.k[edges.count] = k;
                edges.count += triangles_[some[owner]].across[k] > some[owner]; // or there is none
            }
        for (std::size_t i = 0; i < edges.count; ++i)
            fill(some[edges.owner[i]], edges.k[i], i, edges);
        return edges;
    }

    void fill(TriangleId t, unsigned k, std::size_t i, Edges& edges) const {
        const Triangle& here = triangles_[t];
        const TriangleMetrics& own = metrics_.of[t];
        const TriangleId u = here.across[k];
        const bool inner = u != no_triangle;
        const TriangleMetrics& beyond = metrics_.of[inner ? u : t];
        const unsigned j = inner ? triangles_.facing(t, k) : k;
        edges.bend[i] = own.normal[0] * beyond.normal[0] + own.normal[1] * beyond.normal[1] +
                        own.normal[2] * beyond.normal[2];
        constexpr std::array<unsigned, 5> cycle{0, 1, 2, 0, 1};
        edges.cotangent[0][i] = own.cotangent[k];
        edges.cotangent[1][i] = own.cotangent[cycle[k + 1]];
        edges.cotangent[2][i] = own.cotangent[cycle[k + 2]];
        edges.cotangent_beyond[0][i] = inner ? beyond.cotangent[j] : 1e9f; // not to be turned
        edges.cotangent_beyond[1][i] = beyond.cotangent[cycle[j + 2]];
        edges.cotangent_beyond[2][i] = beyond.cotangent[cycle[j + 1]];
        constexpr std::uint32_t sides = flag_any_long | flag_wide;
        const bool is_plain =
            ((own.flags & sides) == flag_long << k) & ((beyond.flags & sides) == flag_long << j);
        const bool is_bridging = inner & (((own.flags | beyond.flags) & flag_bridging) != 0);
        const bool is_half = (here.mate == k) & !here.odd() & is_turn(t);
        edges.is[i] = (own.flags >> k & flag_bent) / flag_bent * Edges::bent |
                      (own.flags >> k & flag_long) / flag_long * Edges::lengthy |
                      is_plain * Edges::plain | is_bridging * Edges::bridged |
                      is_half * Edges::halved;
    }

    bool is_turn(TriangleId t) const { return (t + turn_) % turns == 0; }

    /// Returns whether a side is on the border. Holes close there: they are not put off.
    static bool is_on_border(const Triangle& t) {
        return std::find(t.across.begin(), t.across.end(), no_triangle) != t.across.end();
    }

    /// Asks the exact rules. @param may  of each edge that it owns
    std::uint8_t needs(TriangleId t, std::uint32_t may) const {
        const std::uint32_t flags = metrics_.of[t].flags;
        if ((flags & flag_dead) != 0)
            return cutting;
        const Triangle& here = triangles_[t];
        std::uint8_t needs = 0;
        if ((flags & flag_small) != 0 && context_.rules.merge > 0.0 &&
            (is_turn(t) || is_on_border(here)) && may_join(context_, t))
            needs |= joining;
        for (unsigned k = 0; k < 3 && (may & flip * every_edge) != 0; ++k)
            if ((may & flip << k * edge_bits) != 0 && should_flip(context_, t, k))
                needs |= flipping;
        if (((flags & (flag_no_shape | flag_bridging)) != 0 || (may & cut * every_edge) != 0 ||
             ((flags & flag_wall) != 0 && meets_wall(t))) &&
            needs_cut(context_, t))
            needs |= cutting;
        const bool sides_long = (flags & flag_any_long & ~(flag_long << here.mate)) != 0;
        if ((here.odd() || sides_long || (may & part * every_edge) != 0) &&
            is_poor_pair(context_, t))
            needs |= pairing;
        return needs;
    }

    bool meets_wall(TriangleId t) const {
        const Triangle& here = triangles_[t];
        for (unsigned k = 0; k < 3; ++k)
            if (const VertexId a = here.begin(k), b = here.end(k);
                here.across[k] > t && may_meet_wall(metrics_, a) &&
                crosses_obstacle(context_, a, b, squared_length(mesh_, a, b)))
                return true;
        return false;
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    const MaterialTriangles& triangles_;
    const MeshMetrics& metrics_;
    std::vector<std::uint8_t>& needs_;
    std::uint64_t turn_;
    float cosine_;
};

} // namespace

Needs scan(const RefinementContext& context, std::uint64_t turn, ScanMemory& memory) {
    const MovingMesh& mesh = context.mesh;
    const auto slots = mesh.triangles.slots();
    measure_triangles(context, memory.metrics);
    memory.needs.assign(slots.size(), 0);
    const Scan scan(context, turn, memory);
    for_each_index((slots.size() + at_once - 1) / at_once,
                   [&](std::size_t block) {
                       std::array<TriangleId, at_once> some;
                       std::size_t count = 0;
                       const std::size_t end = std::min((block + 1) * at_once, slots.size());
                       for (std::size_t t = block * at_once; t < end; ++t) {
                           some[count] = static_cast<TriangleId>(t);
                           count += slots[t].live;
                       }
                       scan.fetch_neighbours(end, std::min(end + at_once, slots.size()));
                       if (!context.stop.stop_requested())
                           scan.measure({some.data(), count});
                   },
                   blocks_together);
    const auto with = [&](std::uint8_t need) {
        return gather<TriangleId>(
            slots.size(),
            [&](std::size_t t, std::vector<TriangleId>& found) {
                if ((memory.needs[t] & need) != 0)
                    found.push_back(static_cast<TriangleId>(t));
            },
            16384);
    };
    return {with(flipping), with(cutting), with(joining), with(pairing)};
}

} // namespace wakesurf::core
