#include "core/surface/moving/pairing.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/radix_sort.hpp"
#include "core/surface/moving/edit_round.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr float poor = 0.295f; ///< sine of the smallest or largest corner: 17 degrees
/// Sines that the quads along an alternating path must have, tried in turn.
constexpr std::array<float, 3> least_on_path{0.4f, 0.0f, -2.0f};
constexpr int swap_rounds = 4;
constexpr std::size_t scores_kept = 1 << 14; ///< a power of two

/// The triangles that a search has come to, in order, each from one before.
class Reached {
  public:
    static constexpr std::size_t most = 254;

    struct Step {
        TriangleId triangle;
        std::uint32_t before; ///< its place
    };

    Reached() { place_.fill(nowhere); }

    std::size_t size() const { return size_; }

    const Step& operator[](std::size_t place) const { return steps_[place]; }

    bool has(TriangleId t) const { return place_[bucket(t)] != nowhere; }

    /// REQUIRES: !has(t), and size() < most.
    void add(TriangleId t, std::uint32_t before) {
        place_[bucket(t)] = static_cast<std::uint8_t>(size_);
        steps_[size_++] = {t, before};
    }

  private:
    static constexpr std::uint8_t nowhere = 255;

    /// That of the triangle, or where it would be put.
    std::size_t bucket(TriangleId t) const {
        std::size_t here = (t * 0x9e3779b1u) >> 23;
        while (place_[here] != nowhere && steps_[place_[here]].triangle != t)
            here = (here + 1) % place_.size();
        return here;
    }

    std::array<Step, most> steps_;
    std::array<std::uint8_t, 512> place_; ///< of its hash
    std::size_t size_ = 0;
};

class Pairing {
  public:
    explicit Pairing(const RefinementContext& context)
        : context_(context), mesh_(context.mesh), triangles_(context.mesh.triangles),
          per_separation_(1.0 / context.rules.separation) {}

    /// Remembers scores while nothing moves: most quads are evaluated several times.
    void remember_scores() { known_.assign(scores_kept, unknown); }

    /// Returns the remembered score(). From several threads at the same time. REQUIRES: remember_scores().
    float known_score(TriangleId t, unsigned k) {
        if (const TriangleId u = triangles_[t].across[k]; u < t) { // an edge has one name
            k = triangles_.facing(t, k);
            t = u;
        }
        const std::uint32_t name = 3 * t + k;
        const std::atomic_ref known(known_[(name ^ name >> 11) % scores_kept]);
        const std::uint64_t found = known.load(std::memory_order_relaxed);
        if (found >> 32 == name)
            return std::bit_cast<float>(static_cast<std::uint32_t>(found));
        const float its = score(t, k);
        known.store(std::uint64_t{name} << 32 | std::bit_cast<std::uint32_t>(its),
                    std::memory_order_relaxed);
        return its;
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

    /// Pairs the triangles of edges that must not be visible, whatever their present partners.
    void pair_forced(std::span<const TriangleId> loose) {
        for (const TriangleId t : loose)
            for (unsigned k = 0; k < 3 && is_free(t); ++k) {
                const TriangleId u = triangles_[t].across[k];
                if (u == no_triangle || !too_long(t, k))
                    continue;
                triangles_.part(u);
                triangles_.pair(t, k, triangles_.take_ids(1));
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
                    if (const float its = known_score(t, k); its >= poor)
                        found.push_back({its, t, k});
        };
        auto candidates = gather<Candidate>(loose.size(), add, few_triangles);
        sort_all(candidates, [](const Candidate& a, const Candidate& b) {
            return std::tuple(-a.score, a.t, a.k) < std::tuple(-b.score, b.t, b.k);
        });
        for (int round = 0; !candidates.empty(); ++round) {
            const auto pairs = pairing_round(
                round, candidates.size(),
                [&](std::size_t i, std::vector<TriangleId>& claimed) -> std::optional<Pairs> {
                    const auto [its, t, k] = candidates[i];
                    const TriangleId u = triangles_[t].across[k];
                    if (!is_free(t) || !is_free(u))
                        return std::nullopt;
                    claimed.insert(claimed.end(), {t, u});
                    return Pairs{{}, {{t, k}}};
                });
            candidates = pairs.again(candidates);
        }
    }

    /// Gives triangles another half each by taking apart every other pair on the way to a triangle that has none
    /// either. Returns those that have still none.
    std::vector<TriangleId> pair_along_paths(std::vector<TriangleId> loose, float least) {
        std::vector<TriangleId> pending = loose;
        for (int round = 0; !pending.empty(); ++round) {
            const auto paths = pairing_round(round, pending.size(),
                                             [&](std::size_t i, std::vector<TriangleId>& claimed) {
                                                 return path_from(pending[i], least, claimed);
                                             });
            pending = paths.again(pending);
        }
        return still_free(loose);
    }

    /// Two pairs beside each other become two others where that is better for both together.
    void swap_pairs(std::span<const TriangleId> around) {
        std::vector<TriangleId> asked(around.begin(), around.end());
        for (int round = 0; round < swap_rounds && !asked.empty(); ++round) {
            // What lies beside the new pairs may be worth more with them next.
            std::vector<TriangleId> changed;
            for (int again = 0; !asked.empty(); ++again) {
                const auto swapped = pairing_round(
                    again, asked.size(), [&](std::size_t i, std::vector<TriangleId>& claimed) {
                        return swap_at(asked[i], claimed);
                    });
                for (const Pairs& each : swapped.made)
                    for (const auto& [t, k] : each.paired)
                        changed.insert(changed.end(), {t, triangles_[t].across[k]});
                asked = swapped.again(asked);
            }
            asked = distinct(std::move(changed));
        }
    }

    std::vector<TriangleId> still_free(std::span<const TriangleId> from) const {
        std::vector<TriangleId> found;
        for (const TriangleId t : from)
            if (is_free(t))
                found.push_back(t);
        return distinct(std::move(found));
    }

  private:
    /// What is taken apart, and then paired across an edge. Only triangles of these pairs change.
    struct Pairs {
        std::vector<TriangleId> parted;
        std::vector<MaterialTriangles::Edge> paired;
    };

    /// Claims are of triangles.
    template <class Ask>
    EditRound<Pairs> pairing_round(int round, std::size_t count, const Ask& ask) {
        std::optional<std::uint32_t> first;
        triangles_.claims().make_room(triangles_.slots().size());
        return edit_round<Pairs>(
            round, context_.stop.stop_requested() ? 0 : count, triangles_, ask,
            [](const Pairs& pairs) { return pairs.paired.size(); },
            [&](std::size_t ids) {
                first = std::min(first.value_or(no_vertex), triangles_.take_ids(ids));
            },
            [&](const Pairs& pairs, std::size_t number, TriangleChanges& changes) {
                for (const TriangleId t : pairs.parted)
                    triangles_.part(t, changes);
                for (const auto& [t, k] : pairs.paired)
                    triangles_.pair(t, k, *first + static_cast<std::uint32_t>(number++));
            });
    }

    /// A triangle that stays odd has one more vertex. Exact surfaces trace that from the rake, and a wider search saves them
    /// a fifth of their time round a sphere. Others interpolate it, and lose by the search about what they win.
    std::size_t most_reached() const {
        return context_.rules.policy == InsertionPolicy::Exact ? Reached::most : 64;
    }

    /// Searches nearest pairs first.
    std::optional<Pairs>
    path_from(TriangleId start, float least, std::vector<TriangleId>& claimed) {
        if (!is_free(start))
            return std::nullopt;

        Reached reached; // at its even places what is steps from the start in pairs
        reached.add(start, 0);
        for (std::uint32_t i = 0; i < reached.size() && reached.size() + 6 <= most_reached();
             i += 2) {
            const TriangleId t = reached[i].triangle;
            for (unsigned k = 0; k < 3; ++k) {
                const TriangleId u = triangles_[t].across[k];
                if (u == no_triangle || reached.has(u) || known_score(t, k) < least)
                    continue;
                const bool ends = is_free(u) || triangles_[u].odd();
                const TriangleId next = ends ? u : triangles_[u].across[triangles_[u].mate];
                if (!ends && (is_forced(u) || reached.has(next)))
                    continue;
                reached.add(u, i);
                if (!ends) {
                    reached.add(next, static_cast<std::uint32_t>(reached.size() - 1));
                    continue;
                }
                Pairs path;
                for (std::uint32_t at = static_cast<std::uint32_t>(reached.size() - 1);;) {
                    const std::uint32_t before = reached[at].before;
                    const TriangleId from = reached[before].triangle;
                    path.parted.push_back(reached[at].triangle);
                    path.paired.push_back({from, edge_to(from, reached[at].triangle)});
                    claimed.insert(claimed.end(), {from, reached[at].triangle});
                    if (before == 0)
                        return path;
                    at = reached[before].before;
                }
            }
        }
        return std::nullopt;
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

    std::optional<Pairs> swap_at(TriangleId t, std::vector<TriangleId>& claimed) {
        const auto worth = [&](TriangleId x, unsigned edge) {
            return std::sqrt(std::max(known_score(x, edge), 0.0f));
        };
        for (unsigned k = 0; k < 3 && swappable(t); ++k) {
            const TriangleId u = triangles_[t].across[triangles_[t].mate];
            const TriangleId v = triangles_[t].across[k];
            if (v == no_triangle || v == u || !swappable(v))
                continue;
            const TriangleId w = triangles_[v].across[triangles_[v].mate];
            if (!beside(u, w) || w == t)
                continue;
            const unsigned j = edge_to(u, w);
            if (!(worth(t, k) + worth(u, j) >
                  worth(t, triangles_[t].mate) + worth(v, triangles_[v].mate) + 1e-4f))
                continue;
            claimed.insert(claimed.end(), {t, u, v, w});
            return Pairs{{t, v}, {{t, k}, {u, j}}};
        }
        return std::nullopt;
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    MaterialTriangles& triangles_;
    double per_separation_;

    static constexpr std::uint64_t unknown = ~std::uint64_t{0};

    std::vector<std::uint64_t> known_; ///< the edge's name, and its score
};

} // namespace

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
    const VertexId hanging = mesh.triangles.hanging(t);
    const auto far = [&](VertexId v) {
        return !(squared_length(mesh, hanging, v) <= context.longest_allowed());
    };
    return mesh.vertices.dead(hanging) || far(here.begin(here.mate)) || far(here.end(here.mate));
}

std::vector<TriangleId> pair_all(const RefinementContext& context,
                                 std::span<const TriangleId> loose) {
    MaterialTriangles& triangles = context.mesh.triangles;
    Pairing pairing(context);
    const std::vector<TriangleId> all = pairing.still_free(loose);
    triangles.loose().clear();
    pairing.remember_scores();
    pairing.pair_forced(all);
    // A triangle whose pair was broken up needs another half as well.
    std::vector<TriangleId> rest = all;
    rest.insert(rest.end(), triangles.loose().begin(), triangles.loose().end());
    rest = pairing.still_free(rest);
    pairing.pair_best(rest);
    rest = pairing.still_free(rest);
    for (const float least : least_on_path)
        rest = pairing.pair_along_paths(std::move(rest), least);
    pairing.swap_pairs(all);
    triangles.loose().clear();
    return rest;
}

} // namespace wakesurf::core
