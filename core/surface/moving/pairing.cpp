#include "core/surface/moving/pairing.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr float poor = 0.295f; ///< sine of the smallest or largest corner: 17 degrees
/// Sines that the quads along an alternating path must have, tried in turn.
constexpr std::array<float, 3> least_on_path{0.4f, 0.0f, -2.0f};
constexpr std::size_t longest_search = 32; ///< triangles
constexpr int swap_rounds = 4;
constexpr std::size_t scores_kept = 1 << 14; ///< a power of two

class Pairing {
  public:
    explicit Pairing(const RefinementContext& context)
        : context_(context), mesh_(context.mesh), triangles_(context.mesh.triangles),
          per_separation_(1.0 / context.rules.separation) {}

    /// Remembers scores while nothing moves: most quads are evaluated several times.
    void remember_scores() { known_.assign(scores_kept, {}); }

    /// Returns the remembered score(). REQUIRES: remember_scores().
    float known_score(TriangleId t, unsigned k) {
        const TriangleId u = triangles_[t].across[k];
        const std::uint64_t name = name_of(t, u);
        Known& known = known_[place_of(name)];
        if (known.name != name)
            known = {name, t < u ? score(t, k) : score(u, triangles_.facing(t, k))};
        return known.score;
    }

    /// Prepares the search for paths, which needs it.
    void remember_searches() {
        searched_.assign(triangles_.slots().size(), 0);
        from_.resize(triangles_.slots().size());
    }

    /// Least sine of the corners of the quad across edge k, or cosine of the bend there if that is less;
    /// negative where it is not convex.
    float score(TriangleId t, unsigned k) const {
        const Triangle& here = triangles_[t];
        const std::array<VertexId, 4> corner{here.begin(k), triangles_.opposite_beyond(t, k),
                                             here.end(k), here.opposite(k)};
        // Four corners at a time, in separations; the first side comes last again.
        std::array<float, 5> x, y, z, length;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3f side(per_separation_ * mesh_.edge(corner[i], corner[(i + 1) % 4]));
            x[i] = side.x;
            y[i] = side.y;
            z[i] = side.z;
        }
        x[4] = x[0], y[4] = y[0], z[4] = z[0];
        for (std::size_t i = 0; i < 5; ++i)
            length[i] = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
        std::array<float, 4> normal_x, normal_y, normal_z, sine;
        for (std::size_t i = 0; i < 4; ++i) {
            normal_x[i] = y[i] * z[i + 1] - z[i] * y[i + 1];
            normal_y[i] = z[i] * x[i + 1] - x[i] * z[i + 1];
            normal_z[i] = x[i] * y[i + 1] - y[i] * x[i + 1];
        }
        // Twice the quad's area vector is the sum of two opposite corners'.
        const float along_x = normal_x[0] + normal_x[2];
        const float along_y = normal_y[0] + normal_y[2];
        const float along_z = normal_z[0] + normal_z[2];
        const float size = along_x * along_x + along_y * along_y + along_z * along_z;
        for (std::size_t i = 0; i < 4; ++i) {
            const float along =
                normal_x[i] * along_x + normal_y[i] * along_y + normal_z[i] * along_z;
            const float scale = length[i] * length[i + 1] * size;
            sine[i] = scale > 0.0f ? along * std::abs(along) / scale : -1.0f; // squared
        }
        const float least = *std::min_element(sine.begin(), sine.end());
        // The normals of the triangles count: a quad is not to be bent over a ridge of the sheet.
        const float here_size =
            normal_x[0] * normal_x[0] + normal_y[0] * normal_y[0] + normal_z[0] * normal_z[0];
        const float there_size =
            normal_x[2] * normal_x[2] + normal_y[2] * normal_y[2] + normal_z[2] * normal_z[2];
        const float together =
            normal_x[0] * normal_x[2] + normal_y[0] * normal_y[2] + normal_z[0] * normal_z[2];
        const float sizes = std::sqrt(here_size * there_size);
        return std::min(std::copysign(std::sqrt(std::abs(least)), least),
                        sizes > 0.0f ? together / sizes : 1.0f);
    }

    bool is_forced(TriangleId t) const {
        return triangles_[t].paired() && too_long(t, triangles_[t].mate);
    }

    bool too_long(TriangleId t, unsigned k) const {
        return !(squared_length(mesh_, triangles_[t].begin(k), triangles_[t].end(k)) <=
                 context_.longest_allowed());
    }

    bool is_free(TriangleId t) const {
        return triangles_[t].live && triangles_[t].mate == Triangle::alone;
    }

    void pair(TriangleId t, unsigned k) { triangles_.pair(t, k, triangles_.take_id()); }

    /// Pairs the triangles of edges that must not be visible, whatever their present partners.
    void pair_forced(std::span<const TriangleId> loose) {
        for (const TriangleId t : loose)
            for (unsigned k = 0; k < 3 && is_free(t); ++k) {
                const TriangleId u = triangles_[t].across[k];
                if (u == no_triangle || !too_long(t, k))
                    continue;
                triangles_.part(u);
                pair(t, k);
            }
    }

    void pair_best(std::span<const TriangleId> loose) {
        struct Candidate {
            float score;
            TriangleId t;
            unsigned k;
        };

        const auto add = [&](std::size_t i, std::vector<Candidate>& found) {
            const TriangleId t = loose[i];
            for (unsigned k = 0; k < 3; ++k)
                if (const TriangleId u = triangles_[t].across[k];
                    u != no_triangle && t < u && is_free(t) && is_free(u))
                    found.push_back({score(t, k), t, k});
        };
        auto candidates = gather<Candidate>(loose.size(), add, few_triangles);
        for (const Candidate& each : candidates) {
            const std::uint64_t name = name_of(each.t, triangles_[each.t].across[each.k]);
            known_[place_of(name)] = {name, each.score};
        }
        std::erase_if(candidates, [](const Candidate& each) { return !(each.score >= poor); });
        std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
            return std::tuple(-a.score, a.t, a.k) < std::tuple(-b.score, b.t, b.k);
        });
        for (const Candidate& best : candidates)
            if (is_free(best.t) && is_free(triangles_[best.t].across[best.k]))
                pair(best.t, best.k);
    }

    /// Another half for `start` by taking apart every other pair on the way to a triangle that has none
    /// either.
    bool pair_along_path(TriangleId start, float least) {
        ++search_;
        std::vector<TriangleId> queue{start};
        come_from(start, no_triangle);
        for (std::size_t i = 0; i < queue.size() && queue.size() < longest_search; ++i) {
            const TriangleId t = queue[i]; // an even number of steps from the start
            for (unsigned k = 0; k < 3; ++k) {
                const TriangleId u = triangles_[t].across[k];
                if (u == no_triangle || seen(u) || known_score(t, k) < least)
                    continue;
                if (is_free(u) || triangles_[u].odd()) {
                    triangles_.part(u);
                    follow_back(t, u);
                    return true;
                }
                const TriangleId next = triangles_[u].across[triangles_[u].mate];
                if (is_forced(u) || seen(next))
                    continue;
                come_from(u, t);
                come_from(next, u);
                queue.push_back(next);
            }
        }
        return false;
    }

    /// Two pairs beside each other become two others where that is better for both together.
    void swap_pairs(std::span<const TriangleId> around) {
        for (int round = 0; round < swap_rounds; ++round) {
            bool any = false;
            for (const TriangleId t : around)
                for (unsigned k = 0; k < 3 && swappable(t); ++k)
                    any = swap(t, k) || any;
            if (!any)
                return;
        }
    }

  private:
    static std::uint64_t name_of(TriangleId t, TriangleId u) {
        return std::uint64_t{std::min(t, u)} << 32 | std::max(t, u);
    }

    static std::size_t place_of(std::uint64_t name) {
        return (name ^ name >> 23) & (scores_kept - 1);
    }

    bool seen(TriangleId t) const { return searched_[t] == search_; }

    void come_from(TriangleId t, TriangleId before) {
        searched_[t] = search_;
        from_[t] = before;
    }

    void follow_back(TriangleId t, TriangleId u) {
        for (;;) {
            const TriangleId before = from_[t];
            if (before != no_triangle)
                triangles_.part(t); // from `before`, which is next
            pair(t, edge_to(t, u));
            if (before == no_triangle)
                return;
            u = before;
            t = from_[before];
        }
    }

    unsigned edge_to(TriangleId t, TriangleId u) const {
        const auto& across = triangles_[t].across;
        return across[0] == u ? 0u : across[1] == u ? 1u : 2u;
    }

    bool beside(TriangleId t, TriangleId u) const {
        const auto& across = triangles_[t].across;
        return across[0] == u || across[1] == u || across[2] == u;
    }

    bool swappable(TriangleId t) const {
        return triangles_[t].live && triangles_[t].paired() && !is_forced(t);
    }

    bool swap(TriangleId t, unsigned k) {
        const TriangleId u = triangles_[t].across[triangles_[t].mate];
        const TriangleId v = triangles_[t].across[k];
        if (v == no_triangle || v == u || !swappable(v))
            return false;
        const TriangleId w = triangles_[v].across[triangles_[v].mate];
        if (!beside(u, w) || w == t)
            return false;
        const unsigned j = edge_to(u, w);
        const auto worth = [&](TriangleId x, unsigned edge) {
            return std::sqrt(std::max(known_score(x, edge), 0.0f));
        };
        if (!(worth(t, k) + worth(u, j) >
              worth(t, triangles_[t].mate) + worth(v, triangles_[v].mate) + 1e-4f))
            return false;
        triangles_.part(t);
        triangles_.part(v);
        pair(t, k);
        pair(u, j);
        return true;
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    MaterialTriangles& triangles_;
    double per_separation_;

    struct Known {
        std::uint64_t name = ~std::uint64_t{0}; ///< of both triangles
        float score = 0.0f;
    };

    std::vector<Known> known_;
    std::uint32_t search_ = 0;
    std::vector<std::uint32_t> searched_; ///< by which search a triangle was last come to
    std::vector<TriangleId> from_;        ///< and from which triangle
};

/// Returns its longest edge that is not the rake's, of those whose middle is in the fluid if there is one: a
/// middle that is only drawn must not be in a body that the edge goes along.
unsigned side_to_halve(const RefinementContext& context, TriangleId t) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    unsigned best = 0;
    std::pair<bool, double> most{false, -1.0};
    for (unsigned k = 0; k < 3; ++k) {
        const VertexId a = here.begin(k), b = here.end(k);
        const MaterialVertices& v = mesh.vertices;
        if (v.role[a] == VertexRole::Attached && v.role[b] == VertexRole::Attached)
            continue;
        const bool in_fluid =
            !context.rules.obstacle ||
            context.flow.status(0.5 * (v.position[a] + v.position[b])) == PointStatus::Inside;
        if (const std::pair here_is(in_fluid, squared_length(mesh, a, b)); here_is > most) {
            most = here_is;
            best = k;
        }
    }
    return best;
}

} // namespace

bool is_poor_pair(const RefinementContext& context, TriangleId t) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    if (here.mate == Triangle::alone)
        return false;
    const Pairing pairing(context);
    for (unsigned k = 0; k < 3; ++k)
        if ((k != here.mate || here.odd()) && pairing.too_long(t, k))
            return true;
    if (!here.odd())
        return !pairing.is_forced(t) && pairing.score(t, here.mate) < poor;
    const auto far = [&](VertexId v) {
        return !(squared_length(mesh, here.hanging, v) <= context.longest_allowed());
    };
    return mesh.vertices.dead(here.hanging) || far(here.begin(here.mate)) ||
           far(here.end(here.mate));
}

void pair_all(const RefinementContext& context,
              std::span<const TriangleId> loose,
              const std::function<VertexId(TriangleId t, unsigned k)>& insert) {
    MaterialTriangles& triangles = context.mesh.triangles;
    Pairing pairing(context);
    const auto still_free = [&](std::span<const TriangleId> from) {
        std::vector<TriangleId> found;
        for (const TriangleId t : from)
            if (pairing.is_free(t))
                found.push_back(t);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    };
    const std::vector<TriangleId> all = still_free(loose);
    triangles.loose().clear();
    pairing.remember_scores();
    pairing.pair_forced(all);
    // A triangle whose pair was broken up needs another half as well.
    std::vector<TriangleId> rest = all;
    rest.insert(rest.end(), triangles.loose().begin(), triangles.loose().end());
    rest = still_free(rest);
    pairing.pair_best(rest);
    rest = still_free(rest);
    if (!rest.empty())
        pairing.remember_searches();
    for (const float least : least_on_path) {
        for (const TriangleId t : rest)
            if (pairing.is_free(t) && !context.stop.stop_requested())
                pairing.pair_along_path(t, least);
        rest = still_free(rest);
    }
    pairing.swap_pairs(all);
    std::vector<VertexId>& fresh = context.mesh.vertices.fresh();
    const std::size_t used = fresh.size();
    for (const TriangleId t : rest) {
        const unsigned k = side_to_halve(context, t);
        triangles.leave_odd(t, k, insert(t, k), triangles.take_id());
    }
    fresh.resize(used); // the others hang on a triangle each
    triangles.loose().clear();
}

} // namespace wakesurf::core
