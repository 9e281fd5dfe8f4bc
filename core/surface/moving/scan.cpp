#include "core/surface/moving/scan.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/cuts.hpp"
#include "core/surface/moving/flips.hpp"
#include "core/surface/moving/joins.hpp"
#include "core/surface/moving/pairing.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace wakesurf::core {

namespace {

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
          looks_(memory.looks), needs_(memory.needs), turn_(turn),
          cosine_(static_cast<float>(context.rules.cosine)) {}

    void look_at(std::span<const TriangleId> some) const {
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
                    __builtin_prefetch(&looks_.of[u]);
                }
    }

  private:
    /// The possible changes of an edge.
    enum May : std::uint32_t { cut = 1, flip = 2, part = 4 };

    static constexpr std::uint32_t edge_bits = 3;
    static constexpr std::uint32_t every_edge = 1 | 1 << edge_bits | 1 << 2 * edge_bits;

    /// Edges, each between two triangles, of which the one with the smaller number, or the only one, owns it.
    struct Edges {
        enum Is : std::uint32_t { bent = 1, lengthy = 2, plain = 4, webbed = 8, halved = 16 };

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
                const unsigned uneven = unsigned{!(bend[i] >= cosine + look_room)};
                const unsigned obtuse = unsigned{!(p + q >= look_room)};
                const unsigned stays = open & is[i] / plain;
                may[i] = ((is[i] / bent | uneven | (is[i] / lengthy & ~stays)) & 1u) * cut |
                         ((is[i] / webbed | obtuse) & 1u) * flip |
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
        const TriangleLook& look = looks_.of[t];
        const TriangleId u = here.across[k];
        const bool inner = u != no_triangle;
        const TriangleLook& beyond = looks_.of[inner ? u : t];
        const unsigned j = inner ? triangles_.facing(t, k) : k;
        edges.bend[i] = look.normal[0] * beyond.normal[0] + look.normal[1] * beyond.normal[1] +
                        look.normal[2] * beyond.normal[2];
        constexpr std::array<unsigned, 5> cycle{0, 1, 2, 0, 1};
        edges.cotangent[0][i] = look.cotangent[k];
        edges.cotangent[1][i] = look.cotangent[cycle[k + 1]];
        edges.cotangent[2][i] = look.cotangent[cycle[k + 2]];
        edges.cotangent_beyond[0][i] = inner ? beyond.cotangent[j] : 1e9f; // not to be turned
        edges.cotangent_beyond[1][i] = beyond.cotangent[cycle[j + 2]];
        edges.cotangent_beyond[2][i] = beyond.cotangent[cycle[j + 1]];
        constexpr std::uint32_t sides = look_any_long | look_wide;
        const bool is_plain =
            ((look.flags & sides) == look_long << k) & ((beyond.flags & sides) == look_long << j);
        const bool is_web = inner & (((look.flags | beyond.flags) & look_web) != 0);
        const bool is_half = (here.mate == k) & !here.odd() & is_turn(t);
        edges.is[i] = (look.flags >> k & look_bent) / look_bent * Edges::bent |
                      (look.flags >> k & look_long) / look_long * Edges::lengthy |
                      is_plain * Edges::plain | is_web * Edges::webbed | is_half * Edges::halved;
    }

    bool is_turn(TriangleId t) const { return (t + turn_) % turns == 0; }

    /// Returns whether a side is on the border. Holes close there: they are not put off.
    static bool is_on_border(const Triangle& t) {
        return std::find(t.across.begin(), t.across.end(), no_triangle) != t.across.end();
    }

    /// Asks the exact rules. @param may  of each edge that it owns
    std::uint8_t needs(TriangleId t, std::uint32_t may) const {
        const std::uint32_t look = looks_.of[t].flags;
        if ((look & look_dead) != 0)
            return cutting;
        const Triangle& here = triangles_[t];
        std::uint8_t needs = 0;
        if ((look & look_small) != 0 && context_.rules.merge > 0.0 &&
            (is_turn(t) || is_on_border(here)) && may_join(context_, t))
            needs |= joining;
        for (unsigned k = 0; k < 3 && (may & flip * every_edge) != 0; ++k)
            if ((may & flip << k * edge_bits) != 0 && should_flip(context_, t, k))
                needs |= flipping;
        if (((look & (look_no_shape | look_web)) != 0 || (may & cut * every_edge) != 0 ||
             ((look & look_wall) != 0 && meets_wall(t))) &&
            needs_cut(context_, t))
            needs |= cutting;
        const bool sides_long = (look & look_any_long & ~(look_long << here.mate)) != 0;
        if ((here.odd() || sides_long || (may & part * every_edge) != 0) &&
            is_poor_pair(context_, t))
            needs |= pairing;
        return needs;
    }

    bool meets_wall(TriangleId t) const {
        const Triangle& here = triangles_[t];
        for (unsigned k = 0; k < 3; ++k)
            if (const VertexId a = here.begin(k), b = here.end(k);
                here.across[k] > t && may_meet_wall(looks_, a) &&
                crosses_obstacle(context_, a, b, squared_length(mesh_, a, b)))
                return true;
        return false;
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    const MaterialTriangles& triangles_;
    const TriangleLooks& looks_;
    std::vector<std::uint8_t>& needs_;
    std::uint64_t turn_;
    float cosine_;
};

} // namespace

Needs scan(const RefinementContext& context, std::uint64_t turn, ScanMemory& memory) {
    const MovingMesh& mesh = context.mesh;
    const auto slots = mesh.triangles.slots();
    look_at_all(context, memory.looks);
    memory.needs.assign(slots.size(), 0);
    const Scan scan(context, turn, memory);
    for_each_index((slots.size() + at_once - 1) / at_once, [&](std::size_t block) {
        std::array<TriangleId, at_once> some;
        std::size_t count = 0;
        const std::size_t end = std::min((block + 1) * at_once, slots.size());
        for (std::size_t t = block * at_once; t < end; ++t) {
            some[count] = static_cast<TriangleId>(t);
            count += slots[t].live;
        }
        scan.fetch_neighbours(end, std::min(end + at_once, slots.size()));
        if (!context.stop.stop_requested())
            scan.look_at({some.data(), count});
    });
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
