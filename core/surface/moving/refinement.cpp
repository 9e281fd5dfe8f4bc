#include "core/surface/moving/refinement.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/radix_sort.hpp"
#include "core/surface/moving/clipping.hpp"
#include "core/surface/moving/edge_changes.hpp"
#include "core/surface/moving/edit_round.hpp"
#include "core/surface/moving/holes.hpp"
#include "core/surface/moving/insertion.hpp"
#include "core/surface/moving/joins.hpp"
#include "core/surface/moving/pairing.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

constexpr int most_cut_passes = 40;
/// The passes that test bends and bulges: the rest waits a step. A triangle that is nearly straight in (s, t)
/// but open in space would be cut in every pass.
constexpr int shape_passes = 3;
constexpr double coarsening = 1.1;
constexpr double beside_middle = 0.49;

/// The list, which is empty afterwards; each once, in order.
std::vector<TriangleId> take(std::vector<TriangleId>& list) {
    std::vector<TriangleId> taken;
    taken.swap(list);
    return distinct(std::move(taken));
}

/// Says whether an edge has triangles beside it that cannot be cut any further.
bool is_hopeless(const RefinementContext& here, TriangleId t, unsigned k) {
    const TriangleId u = here.mesh.triangles[t].across[k];
    return is_torn(here, t, k) || is_crumb(here, t) || (u != no_triangle && is_crumb(here, u));
}

} // namespace

/// Returns whether an interpolated vertex may be too far off to stay where it is.
bool Refinement::wants_trace(const MovingMesh& mesh, VertexId made) const {
    if (mesh.vertices.role[made] != VertexRole::Free)
        return false;
    if (rules_.policy == InsertionPolicy::Exact)
        return true;
    // Only its own particle says whether a place in a wall is where the surface has come to.
    return rules_.retrace && (distance(mesh, made) > rules_.trusted_error * rules_.separation ||
                              flow_.status(mesh.vertices.position[made]) != PointStatus::Inside);
}

/// Returns its error in any direction; NaN counts as too large.
double Refinement::distance(const MovingMesh& mesh, VertexId v) const {
    const double error = mesh.vertices.error[v].apart.length(mesh.vertices.tangents(v));
    return error >= 0.0 ? error : std::numeric_limits<double>::infinity();
}

/// A traced vertex between interpolated ones shows their error as a fold, which is cut, and so on. They are
/// traced as well, unless they are much better than it was.
void Refinement::trace_with_ends(MovingMesh& mesh, VertexId made, VertexId a, VertexId b) {
    to_retrace_.push_back(made);
    if (rules_.policy == InsertionPolicy::Exact)
        return;
    for (const VertexId end : {a, b})
        if (mesh.vertices.approximated[end] != 0 &&
            distance(mesh, end) > 0.25 * rules_.trusted_error * rules_.separation) {
            mesh.vertices.approximated[end] = 0; // once
            to_retrace_.push_back(end);
        }
}

/// Fills the slot of a vertex that was taken for an edge.
void Refinement::begin_on_edge(
    MovingMesh& mesh, VertexId made, TriangleId t, unsigned k, double part) const {
    const VertexId a = mesh.triangles[t].begin(k), b = mesh.triangles[t].end(k);
    MaterialVertices& vertices = mesh.vertices;
    MaterialPoint point = point_on_edge(mesh, t, k, part);
    const bool attached =
        vertices.role[a] == VertexRole::Attached && vertices.role[b] == VertexRole::Attached;
    if (attached) { // on the rake itself: nothing is approximate there
        point.carried.position = origin_.position(point.s, point.t);
        point.approximated = false;
        point.error = {};
    }
    vertices.begin(made, point, attached ? VertexRole::Attached : VertexRole::Free, mesh.time);
}

/// Pairs what has no other half. Odd triangles are handed out with a vertex in the middle of an edge.
Result<void> Refinement::pair(MovingMesh& mesh) {
    MaterialTriangles& triangles = mesh.triangles;
    const RefinementContext here = context(mesh);
    const std::vector<TriangleId> loose = triangles.loose();
    const std::vector<TriangleId> odd = pair_all(here, loose);

    struct Hanging {
        VertexId vertex, a, b;
        unsigned k;
        bool traced;
    };

    std::vector<Hanging> made(odd.size());
    const std::size_t fresh = mesh.vertices.fresh().size();
    const std::vector<VertexId> slots = mesh.vertices.take_slots(odd.size());
    mesh.vertices.fresh().resize(fresh); // they hang on a triangle each
    for_each_index(
        odd.size(),
        [&](std::size_t i) {
            const unsigned k = side_to_halve(here, odd[i]);
            const Triangle& t = triangles[odd[i]];
            begin_on_edge(mesh, slots[i], odd[i], k, 0.5);
            made[i] = {slots[i], t.begin(k), t.end(k), k, wants_trace(mesh, slots[i])};
        },
        few_triangles);
    std::vector<MaterialTriangles::Odd> left;
    for (std::size_t i = 0; i < odd.size(); ++i) {
        left.push_back({odd[i], made[i].k, made[i].vertex});
        if (made[i].traced)
            to_retrace_.push_back(made[i].vertex);
    }
    triangles.leave_odd(left);
    if (auto traced = trace_again(mesh); !traced)
        return traced;
    // Where its own particle has gone elsewhere it is only drawn: on the edge.
    for_each_index(made.size(), [&](std::size_t i) {
        MaterialVertices& v = mesh.vertices;
        const auto& [m, a, b, k, traced] = made[i];
        const double far = std::max(squared_length(mesh, m, a), squared_length(mesh, m, b));
        if (v.end[m] == CurveEnd::Running && far <= here.longest_allowed())
            return;
        v.position[m] = 0.5 * (v.position[a] + v.position[b]);
        v.end[m] = CurveEnd::Running;
        v.time[m] = mesh.time;
        v.approximated[m] = 1;
        v.error[m].placed.add(v.tangents(m), mesh.edge_length(a, b));
        v.error[m].apart.add(v.tangents(m), mesh.edge_length(a, b));
    });
    triangles.touched().clear();
    return {};
}

/// Joins what is beside a hopeless edge, or tears the surface there: it cannot be followed.
void Refinement::give_up(const RefinementContext& here, TriangleId t, unsigned k) {
    MaterialTriangles& triangles = here.mesh.triangles;
    const TriangleId u = triangles[t].across[k];
    const bool torn = is_torn(here, t, k);
    const bool crumb_t = is_crumb(here, t), crumb_u = u != no_triangle && is_crumb(here, u);
    if (!torn && !crumb_t && !crumb_u) // any more
        return;
    if ((crumb_t && join_needle(here, t)) || (crumb_u && join_needle(here, u)))
        return;
    const std::size_t before = triangles.live();
    if (torn || crumb_t)
        triangles.tear(t);
    if ((torn || crumb_u) && u != no_triangle && triangles[u].live)
        triangles.tear(u);
    unresolved_ += (before - triangles.live() + 1) / 2;
}

/// Closes holes among living particles: they are not torn then. What is left beside a body is a tear in the making.
void Refinement::close_torn(MovingMesh& mesh) {
    const std::uint64_t quads = (close_holes(context(mesh)) + 1) / 2;
    unresolved_ -= std::min(unresolved_, quads);
    if (!mesh.rectangle.patch && rules_.obstacle)
        unresolved_ += (open_holes(context(mesh)) + 1) / 2;
}

/// Ends the surface where it has left the fluid.
Result<void> Refinement::clip_at_the_dead(MovingMesh& mesh,
                                          std::span<const TriangleId> candidates) {
    const RefinementContext here = context(mesh);
    std::vector<EdgeCrossing> crossings = edges_to_the_dead(here, candidates);
    if (auto found = find_crossings(here, crossings, before_, trace_, stop_); !found)
        return found;
    std::erase_if(crossings, [](const EdgeCrossing& crossing) { return !crossing.found; });
    const std::vector<VertexId> made = mesh.vertices.take_slots(crossings.size());
    for_each_index(
        made.size(),
        [&](std::size_t i) {
            const EdgeCrossing& at = crossings[i];
            const MaterialPoint point =
                point_between(mesh, at.living, at.dead, at.part, at.carried, at.edge);
            mesh.vertices.begin(made[i], point, VertexRole::Free, mesh.time);
        },
        few_triangles);
    clip(here, candidates, crossings, made);
    if (rules_.policy != InsertionPolicy::Exact)
        return {};
    // Its particle ends about now: only the place counts. One that has ended long ago, elsewhere, is not the
    // wanted one.
    std::vector<MaterialPoint> found_there;
    for (const VertexId v : made)
        found_there.push_back(mesh.vertices.point(v));
    if (auto traced = retrace(mesh, origin_, flow_, made, trace_, stop_); !traced)
        return traced;
    for (std::size_t i = 0; i < made.size(); ++i) {
        const VertexId v = made[i];
        const Vec3 moved = mesh.vertices.position[v] - found_there[i].carried.position;
        if (!(squared(moved) <= context(mesh).squared_separation(0.25)))
            mesh.vertices.set(v, found_there[i]);
        mesh.vertices.end[v] = CurveEnd::Running;
        mesh.vertices.time[v] = mesh.time;
    }
    return {};
}

/// Cuts among `candidates`.
void Refinement::cut_pass(MovingMesh& mesh, std::span<const TriangleId> candidates, bool shape) {
    struct Cut {
        TriangleId t;
        unsigned k;
        VertexId a, b;
    };

    const RefinementContext here = context(mesh);
    MaterialTriangles& triangles = mesh.triangles;
    std::vector<WantedCut> wanted = wanted_cuts(here, candidates, shape);
    // First what cannot be cut, while what lies beside it can still be joined. A tear may make others hopeless.
    for (std::size_t before = 0; before != triangles.live() && !stop_.stop_requested();) {
        before = triangles.live();
        const auto hopeless = gather<WantedCut>(
            wanted.size(),
            [&](std::size_t i, std::vector<WantedCut>& found) {
                if (!wanted[i].must)
                    return;
                const auto [t, k] = triangles.find_either_way(wanted[i].a, wanted[i].b);
                if (t != no_triangle && is_hopeless(here, t, k))
                    found.push_back(wanted[i]);
            },
            few_triangles);
        for (const WantedCut& edge : hopeless)
            if (const auto [t, k] = triangles.find_either_way(edge.a, edge.b); t != no_triangle)
                give_up(here, t, k);
    }
    const auto ask = [&](std::size_t i, std::vector<VertexId>& claimed) -> std::optional<Cut> {
        // An edge that was turned away meanwhile, or has become hopeless, is left to the next pass.
        const auto [t, k] = triangles.find_either_way(wanted[i].a, wanted[i].b);
        if (t == no_triangle || is_hopeless(here, t, k))
            return std::nullopt;
        const Triangle& at = triangles[t];
        claimed.insert(claimed.end(), at.vertex.begin(), at.vertex.end());
        if (at.across[k] != no_triangle)
            claimed.push_back(triangles.opposite_beyond(t, k));
        return Cut{t, k, at.begin(k), at.end(k)};
    };
    for (int round = 0; !wanted.empty() && !stop_.stop_requested(); ++round) {
        std::vector<VertexId> made;
        std::vector<std::array<TriangleId, 2>> slots;
        std::vector<std::uint8_t> far;
        triangles.claims().make_room(mesh.vertices.slots());
        const auto cuts = edit_round<Cut>(
            round, wanted.size(), triangles, ask, [](const Cut&) { return std::size_t{1}; },
            [&](std::size_t count) {
                const auto vertices = mesh.vertices.take_slots(count);
                made.insert(made.end(), vertices.begin(), vertices.end());
                const auto more = triangles.slots_to_split(count, mesh.vertices.slots());
                slots.insert(slots.end(), more.begin(), more.end());
                far.resize(made.size());
            },
            [&](const Cut& cut, std::size_t i, TriangleChanges& changes) {
                // An edge that has been torn may have been cut in its middle: two vertices at one place would be a crack.
                const bool torn = triangles[cut.t].across[cut.k] == no_triangle &&
                                  !on_rectangle_border(mesh, cut.a, cut.b);
                const VertexId v = made[i];
                begin_on_edge(mesh, v, cut.t, cut.k, torn ? beside_middle : 0.5);
                triangles.split(cut.t, cut.k, v, slots[i], changes);
                far[i] = wants_trace(mesh, v);
                if (const PointStatus status =
                        far[i] ? PointStatus::Inside : flow_.status(mesh.vertices.position[v]);
                    status != PointStatus::Inside)
                    mesh.vertices.end[v] =
                        status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
            });
        for (std::size_t i = 0; i < made.size(); ++i)
            if (far[i])
                trace_with_ends(mesh, made[i], cuts.made[i].a, cuts.made[i].b);
        wanted = cuts.again(wanted);
    }
}

Result<void> Refinement::trace_again(MovingMesh& mesh) {
    if (to_retrace_.empty())
        return {};
    std::sort(to_retrace_.begin(), to_retrace_.end());
    to_retrace_.erase(std::unique(to_retrace_.begin(), to_retrace_.end()), to_retrace_.end());
    std::erase_if(to_retrace_,
                  [&](VertexId v) { return mesh.vertices.role[v] != VertexRole::Free; });
    if (auto traced = retrace(mesh, origin_, flow_, to_retrace_, trace_, stop_); !traced)
        return traced;
    std::vector<TriangleId> round;
    for (const VertexId v : to_retrace_)
        if (!mesh.triangles.unused(v)) {
            mesh.triangles.fan(v, round);
            for (const TriangleId t : round)
                mesh.triangles.touched().push_back(t);
        }
    to_retrace_.clear();
    return {};
}

/// Returns whether the mesh is within its budget.
Result<bool> Refinement::cut_until_done(MovingMesh& mesh,
                                        std::vector<TriangleId> candidates,
                                        int with_shape,
                                        const WorkPart& work) {
    std::vector<TriangleId> all = candidates; // what is left over for the strict passes
    for (int pass = 0; pass < most_cut_passes; ++pass) {
        if (stop_.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        if (auto room = work.holds(memory_while_moving(mesh, candidates.size() / 3)); !room)
            return tl::unexpected(room.error());
        const bool shape = pass < with_shape;
        if (auto clipped = clip_at_the_dead(mesh, candidates); !clipped)
            return tl::unexpected(clipped.error());
        cut_pass(mesh, candidates, shape);
        if (auto traced = trace_again(mesh); !traced)
            return tl::unexpected(traced.error());
        std::vector<TriangleId> touched = take(mesh.triangles.touched());
        std::vector<TriangleId> queue = touched;
        flip_all(context(mesh), queue);
        touched.insert(touched.end(), mesh.triangles.touched().begin(),
                       mesh.triangles.touched().end());
        mesh.triangles.touched().clear();
        all.insert(all.end(), touched.begin(), touched.end());
        candidates = distinct(std::move(touched));
        // Much of what is cut is joined again before the step ends.
        if (mesh.triangles.quads() > 2 * rules_.max_quads) {
            if (!keep_budget(mesh))
                return false;
            candidates.insert(candidates.end(), mesh.triangles.touched().begin(),
                              mesh.triangles.touched().end());
            candidates = distinct(std::move(candidates));
            all.insert(all.end(), candidates.begin(), candidates.end());
            mesh.triangles.touched().clear();
        }
        if (candidates.empty() && !shape)
            break;
        if (shape && (candidates.empty() || pass + 1 == with_shape)) {
            pass = with_shape - 1;
            candidates = distinct(all); // waiting candidates are tested strictly
        }
    }
    if (auto clipped = clip_at_the_dead(mesh, candidates); !clipped)
        return tl::unexpected(clipped.error());
    all.insert(all.end(), mesh.triangles.touched().begin(), mesh.triangles.touched().end());
    mesh.triangles.touched() = std::move(all);
    return true;
}

/// Larger cells are joined until there are few enough. False: that is not allowed, or joining does not help.
bool Refinement::keep_budget(MovingMesh& mesh) {
    // Odd triangles, which are not known yet, are quads of their own.
    const std::uint64_t most = rules_.max_quads - rules_.max_quads / 64;
    if (mesh.triangles.quads() <= most)
        return true;
    if (!rules_.coarsens)
        return mesh.triangles.quads() <= rules_.max_quads;
    RefinementRules kept = rules_;
    rules_.merge = std::max(rules_.merge, 0.55);
    rules_.cosine = -1.0; // a small budget is kept at the cost of the shape
    while (mesh.triangles.quads() > most && !stop_.stop_requested() &&
           rules_.separation * coarsening <= rules_.coarsest) {
        rules_.separation *= coarsening;
        kept.separation = rules_.separation;
        std::vector<TriangleId> all;
        for (TriangleId t = 0; t < mesh.triangles.slots().size(); ++t)
            if (mesh.triangles[t].live)
                all.push_back(t);
        join_all(context(mesh), all);
    }
    rules_ = kept;
    return mesh.triangles.quads() <= rules_.max_quads;
}

Result<bool> Refinement::run(MovingMesh& mesh, std::stop_token stop, const WorkPart& work) {
    stop_ = std::move(stop);
    if (auto room = work.holds(memory_while_moving(mesh)); !room)
        return tl::unexpected(room.error());
    if (!keep_budget(mesh))
        return false;
    to_retrace_.clear();
    MaterialTriangles& triangles = mesh.triangles;
    const RefinementContext here = context(mesh);
    Needs needs = scan(here, turn_, scan_);
    flip_all(here, needs.flipping);
    std::vector<TriangleId> candidates = std::move(needs.cutting);
    candidates.insert(candidates.end(), triangles.touched().begin(), triangles.touched().end());
    triangles.touched().clear();
    if (auto within = cut_until_done(mesh, distinct(std::move(candidates)), shape_passes, work);
        !within || !*within)
        return within;
    close_torn(mesh);
    if (rules_.merge > 0.0) {
        std::vector<TriangleId> small = std::move(needs.joining);
        small.insert(small.end(), triangles.touched().begin(), triangles.touched().end());
        small = distinct(std::move(small));
        erode(here, small);
        small.insert(small.end(), triangles.touched().begin(), triangles.touched().end());
        small = distinct(std::move(small));
        join_all(here, small);
        small = take(triangles.touched());
        erode(here, small);
        small.insert(small.end(), triangles.touched().begin(), triangles.touched().end());
        // Long inner edges that are no diagonals any more.
        if (auto within = cut_until_done(mesh, distinct(std::move(small)), 0, work);
            !within || !*within)
            return within;
        close_torn(mesh);
    }
    std::vector<TriangleId> changed = take(triangles.touched());
    drop_specks(here, changed);
    if (!keep_budget(mesh))
        return false;
    changed.insert(changed.end(), triangles.touched().begin(), triangles.touched().end());
    changed.insert(changed.end(), needs.pairing.begin(), needs.pairing.end());
    changed = distinct(std::move(changed));
    const auto add_poor = [&](std::size_t i, std::vector<TriangleId>& found) {
        if (triangles[changed[i]].live && is_poor_pair(here, changed[i]))
            found.push_back(changed[i]);
    };
    for (const TriangleId t : gather<TriangleId>(changed.size(), add_poor, few_triangles))
        triangles.part(t); // nothing, where its other half has been
    if (auto paired = pair(mesh); !paired)
        return tl::unexpected(paired.error());
    remove_unused_vertices(mesh);
    if (stop_.stop_requested())
        return fail(Error::Code::Cancelled, "the surface was cancelled");
    return triangles.quads() <= rules_.max_quads;
}

void remove_unused_vertices(MovingMesh& mesh) {
    std::vector<VertexId>& fresh = mesh.vertices.fresh();
    std::vector<VertexId>& left = mesh.triangles.left();
    left.insert(left.end(), fresh.begin(), fresh.end());
    for (const VertexId v : distinct(std::move(left)))
        if (mesh.triangles.unused(v) && mesh.vertices.role[v] == VertexRole::Free)
            mesh.vertices.remove(v);
    left.clear();
    fresh.clear();
}

void leave_out_dead(MovingMesh& mesh) {
    for (TriangleId t = 0; t < mesh.triangles.slots().size(); ++t)
        if (mesh.triangles[t].live && has_dead_vertex(mesh, t)) {
            const TriangleId other = mesh.triangles[t].across[mesh.triangles[t].mate];
            mesh.triangles.remove(t);
            mesh.triangles.remove(other);
        }
    mesh.triangles.touched().clear();
    mesh.triangles.loose().clear();
    remove_unused_vertices(mesh);
}

} // namespace wakesurf::core
