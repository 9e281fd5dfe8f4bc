#include "core/surface/moving/joins.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/radix_sort.hpp"
#include "core/surface/moving/edge_changes.hpp"
#include "core/surface/moving/edit_round.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr int most_rounds = 4;
constexpr double good = 0.5;           ///< quality that every new triangle may have
constexpr double bad = 0.25;           ///< quality of what may get worse elsewhere to go
constexpr double means_nothing = 0.15; ///< quality below which a normal says nothing
constexpr double least_turn = 0.342;   ///< cosine: normals may turn by 70 degrees
constexpr double least_fold = 0.5;     ///< cosine: neighbours may meet at 60 degrees
/// A vertex of the rectangle's border may be so many separations from its new edge.
constexpr double off_border = 0.05;
constexpr double off_tear = 0.2; ///< the same along a tear
constexpr double of_bulge = 0.5; ///< allowed of what is cut, or it would be cut again soon

constexpr double needle_base = 10.0; ///< of a crumb: what is not higher may lie aslant

struct Short {
    double length; ///< rounded_length(); edges of one length are taken in order of ids
    VertexId a, b;
    std::uint32_t id_a, id_b; ///< a's is the smaller
};

/// Whether one vertex may be taken into another, and all that has to be known of it.
class Join {
  public:
    /// @param shape_counts  false: only the part on the surface, and its border, is tested
    Join(const RefinementContext& context, std::vector<TriangleId>& ring, bool shape_counts = true)
        : context_(context), mesh_(context.mesh), ring_(ring), shape_counts_(shape_counts) {}

    /// Returns whether `gone` may be taken into `kept`, its neighbour. Its fan is in the ring then. What is cheap, and refuses
    /// most, comes first.
    bool allowed(VertexId gone, VertexId kept) {
        if (mesh_.vertices.role[gone] == VertexRole::Attached ||
            mesh_.vertices.dead(gone) != mesh_.vertices.dead(kept))
            return false;
        mesh_.triangles.fan(gone, ring_);
        // A vertex beside the rake makes the next row: it would be seeded again at once.
        for (const TriangleId t : ring_)
            if (has_attached_vertex(mesh_, t))
                return false;
        return (!shape_counts_ || (lengths_allow(gone, kept) && triangles_allow(gone, kept))) &&
               border_allows(gone, kept) && material_allows(gone, kept) &&
               mesh_.triangles.collapsible(gone, kept, ring_) &&
               (!shape_counts_ || (bends_allow(gone, kept) && walls_allow(gone, kept)));
    }

  private:
    /// Along the boundary only, where it is straight; the rectangle's corners stay.
    bool border_allows(VertexId gone, VertexId kept) const {
        const Triangle& first = mesh_.triangles[ring_.front()];
        if (first.across[first.edge_from(gone)] != no_triangle)
            return true;
        const Triangle& last = mesh_.triangles[ring_.back()];
        const VertexId next = first.end(first.edge_from(gone));
        const VertexId before = last.opposite(last.edge_from(gone));
        if (kept != next && kept != before)
            return false;
        const Vec3 chord = mesh_.edge(before, next);
        const Vec3 way = mesh_.edge(before, gone);
        const double l2 = squared(chord);
        const double part = l2 > 0.0 ? std::clamp(glm::dot(way, chord) / l2, 0.0, 1.0) : 0.0;
        const bool rim =
            on_rectangle_border(mesh_, before, gone) || on_rectangle_border(mesh_, gone, next);
        if (squared(way - part * chord) > context_.squared_separation(rim ? off_border : off_tear))
            return false;
        const ParameterStep p = mesh_.parameter_step(before, gone);
        const ParameterStep q = mesh_.parameter_step(gone, next);
        const double turn = std::abs(p.s * q.t - q.s * p.t);
        const double size = std::abs(p.s * q.t) + std::abs(q.s * p.t);
        return !(rim && size > 0.0 && turn > 0.9 * size);
    }

    /// The other ends of the edges that are to lead to `kept` instead.
    template <class Holds>
    bool all_neighbours(VertexId gone, VertexId kept, Holds holds) const {
        for (std::size_t i = 0; i <= ring_.size(); ++i) {
            const bool past = i == ring_.size(); // the other end of an open fan
            const Triangle& t = mesh_.triangles[past ? ring_.back() : ring_[i]];
            const VertexId x = past ? t.opposite(t.edge_from(gone)) : t.end(t.edge_from(gone));
            if (x != kept && !holds(x))
                return false;
        }
        return true;
    }

    bool lengths_allow(VertexId gone, VertexId kept) const {
        return all_neighbours(gone, kept, [&](VertexId x) {
            return squared_length(mesh_, x, kept) <= context_.squared_separation() &&
                   // The short way round would not be the surface's.
                   !(mesh_.rectangle.closed && std::abs(mesh_.parameter_step(x, kept).s) > 0.3);
        });
    }

    bool bends_allow(VertexId gone, VertexId kept) const {
        const bool is_bad = std::any_of(ring_.begin(), ring_.end(),
                                        [&](TriangleId t) { return quality(mesh_, t) < bad; });
        return all_neighbours(gone, kept, [&](VertexId x) {
            // An edge that is bad already may bulge as it did.
            return !bulges(context_, x, kept, of_bulge) ||
                   (is_bad &&
                    squared(edge_bend(mesh_, x, kept)) <= squared(edge_bend(mesh_, x, gone)));
        });
    }

    /// Asks the flow, and comes last.
    bool walls_allow(VertexId gone, VertexId kept) const {
        return all_neighbours(gone, kept, [&](VertexId x) {
            return !crosses_obstacle(context_, x, kept, squared_length(mesh_, x, kept));
        });
    }

    bool material_allows(VertexId gone, VertexId kept) const {
        return std::all_of(ring_.begin(), ring_.end(), [&](TriangleId t) {
            const Triangle& here = mesh_.triangles[t];
            const unsigned k = here.edge_from(gone);
            const VertexId x = here.end(k), y = here.opposite(k);
            return x == kept || y == kept ||
                   (material_area(mesh_, kept, x, y) > least_material &&
                    (!is_bridging(mesh_, kept, x, y) || is_bridging(mesh_, gone, x, y)));
        });
    }

    bool triangles_allow(VertexId gone, VertexId kept) const {
        double worst_before = 1.0, worst_after = 1.0;
        for (const TriangleId t : ring_) {
            const Triangle& here = mesh_.triangles[t];
            const unsigned k = here.edge_from(gone);
            const VertexId x = here.end(k), y = here.opposite(k);
            const double before = quality(mesh_, t);
            worst_before = std::min(worst_before, before);
            if (x == kept || y == kept)
                continue;
            const double after = quality(mesh_, kept, x, y);
            worst_after = std::min(worst_after, after);
            const Vec3 old_area = area_vector(mesh_, gone, x, y);
            const Vec3 new_area = area_vector(mesh_, kept, x, y);
            if (before > means_nothing && !(cosine_between(old_area, new_area, -1.0) > least_turn))
                return false;
            const TriangleId beyond = here.across[(k + 1) % 3];
            if (beyond == no_triangle || !(quality(mesh_, beyond) > means_nothing))
                continue;
            const Vec3 area = area_vector(mesh_, beyond);
            const double now = cosine_between(area, new_area, 1.0);
            if (now < least_fold && now < cosine_between(area, old_area, 1.0) - 1e-12)
                return false;
        }
        return worst_after >= good ||
               worst_after >= worst_before * (worst_before < bad ? 1.05 : 1.0);
    }

    const RefinementContext& context_;
    MovingMesh& mesh_;
    std::vector<TriangleId>& ring_;
    bool shape_counts_;
};

bool is_short(const RefinementContext& context, double squared_length) {
    return squared_length < context.squared_separation(context.rules.merge);
}

/// True where the edges of `gone` would be short enough if they led to `kept`. Of 30,000 joins that were
/// tried in a step 26,000 failed at that.
/// @param t  has both
bool all_near(const MovingMesh& mesh, TriangleId t, VertexId gone, VertexId kept, double allowed) {
    const MaterialTriangles& triangles = mesh.triangles;
    const auto near = [&](VertexId x) { return squared_length(mesh, x, kept) <= allowed; };
    TriangleId at = t; // counter-clockwise, to where it began or to the boundary
    do {
        const unsigned k = triangles[at].edge_from(gone);
        if (!near(triangles[at].opposite(k)))
            return false;
        at = triangles[at].across[(k + 2) % 3];
    } while (at != no_triangle && at != t);
    if (at == t)
        return true;
    for (at = t; at != no_triangle;) {
        const unsigned k = triangles[at].edge_from(gone);
        if (!near(triangles[at].end(k)))
            return false;
        at = triangles[at].across[k];
    }
    return true;
}

/// Calls `visit(k, squared length)` for the edges of a triangle that may shrink.
template <class Visit>
void each_edge_to_join(const RefinementContext& context, TriangleId t, const Visit& visit) {
    const MovingMesh& mesh = context.mesh;
    const Triangle& here = mesh.triangles[t];
    const double allowed = context.squared_separation();
    const bool low = quality(mesh, t) < thin_quality;
    for (unsigned k = 0; k < 3; ++k) {
        const VertexId a = here.begin(k), b = here.end(k);
        const double square = squared_length(mesh, a, b);
        if ((low || is_short(context, square)) && square <= allowed &&
            (all_near(mesh, t, a, b, allowed) || all_near(mesh, t, b, a, allowed)))
            visit(k, square);
    }
}

/// The edges of `triangles` that may shrink, in order.
std::vector<Short> short_edges(const RefinementContext& context,
                               std::span<const TriangleId> triangles) {
    const MovingMesh& mesh = context.mesh;
    const auto& ids = mesh.vertices.id;
    const auto add = [&](std::size_t i, std::vector<Short>& found) {
        const TriangleId t = triangles[i];
        const Triangle& here = mesh.triangles[t];
        if (!here.live || context.stop.stop_requested())
            return;
        each_edge_to_join(context, t, [&](unsigned k, double square) {
            const VertexId a = here.begin(k), b = here.end(k);
            const double length = rounded_length(square / context.squared_separation());
            if (ids[a] < ids[b])
                found.push_back({length, a, b, ids[a], ids[b]});
            else
                found.push_back({length, b, a, ids[b], ids[a]});
        });
    };
    std::vector<Short> edges = gather<Short>(triangles.size(), add, few_triangles);
    const auto key = [](const Short& edge) {
        return std::tuple(edge.length, edge.id_a, edge.id_b);
    };
    sort_all(edges, [&](const Short& x, const Short& y) { return key(x) < key(y); });
    const auto same = [](const Short& x, const Short& y) {
        return x.id_a == y.id_a && x.id_b == y.id_b;
    };
    edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
    return edges;
}

} // namespace

bool may_join(const RefinementContext& context, TriangleId t) {
    bool found = false;
    each_edge_to_join(context, t, [&](unsigned, double) { found = true; });
    return found;
}

bool join_needle(const RefinementContext& context, TriangleId t) {
    const auto& v = context.mesh.triangles[t].vertex;
    std::vector<TriangleId> ring;
    Join join(context, ring, false);
    for (unsigned k = 0; k < 3; ++k) {
        VertexId a = v[k], b = v[(k + 1) % 3];
        if (squared_length(context.mesh, a, b) >
            context.squared_separation(needle_base * context.rules.crumb))
            continue;
        if (context.mesh.vertices.id[a] > context.mesh.vertices.id[b])
            std::swap(a, b);
        for (const auto& [gone, kept] : {std::pair(b, a), std::pair(a, b)})
            if (join.allowed(gone, kept)) {
                context.mesh.triangles.collapse(gone, kept, ring);
                return true;
            }
    }
    return false;
}

namespace {

struct Collapse {
    VertexId gone, kept;
};

/// Makes the joins that are allowed, the shortest first. Returns how many.
std::size_t join_edges(const RefinementContext& context, std::vector<Short> edges) {
    MovingMesh& mesh = context.mesh;
    MaterialTriangles& triangles = mesh.triangles;
    triangles.claims().make_room(mesh.vertices.slots());
    const auto ask = [&](std::size_t i, std::vector<VertexId>& claimed) -> std::optional<Collapse> {
        const auto [length, a, b, id_a, id_b] = edges[i];
        if (triangles.unused(a) || triangles.unused(b) || context.stop.stop_requested())
            return std::nullopt;
        std::vector<TriangleId> ring;
        Join join(context, ring);
        for (const auto& [gone, kept] :
             {std::pair(b, a), std::pair(a, b)}) { // the younger goes first
            if (!join.allowed(gone, kept))
                continue;
            const auto claim = [&] {
                for (const TriangleId t : ring)
                    claimed.insert(claimed.end(), triangles[t].vertex.begin(),
                                   triangles[t].vertex.end());
            };
            claim();
            if (triangles.fan(kept, ring)) // its border may close
                claim();
            return Collapse{gone, kept};
        }
        return std::nullopt;
    };
    std::size_t joined = 0;
    for (int round = 0; !edges.empty(); ++round) {
        const auto joins = edit_round<Collapse>(
            round, edges.size(), triangles, ask, numbers_nothing, prepares_nothing,
            [&](const Collapse& each, std::size_t, TriangleChanges& changes) {
                std::vector<TriangleId> ring;
                triangles.fan(each.gone, ring);
                triangles.collapse(each.gone, each.kept, ring, changes);
            });
        joined += joins.made.size();
        edges = joins.again(edges);
    }
    return joined;
}

} // namespace

void join_all(const RefinementContext& context, std::span<const TriangleId> candidates) {
    std::vector<TriangleId>& touched = context.mesh.triangles.touched();
    std::vector<TriangleId> due(candidates.begin(), candidates.end());
    for (int round = 0; round < most_rounds && !context.stop.stop_requested(); ++round) {
        const std::size_t before = touched.size();
        if (join_edges(context, short_edges(context, due)) == 0)
            break;
        due = distinct({touched.begin() + static_cast<std::ptrdiff_t>(before), touched.end()});
        std::vector<TriangleId> queue = due;
        flip_all(context, queue);
    }
}

} // namespace wakesurf::core
