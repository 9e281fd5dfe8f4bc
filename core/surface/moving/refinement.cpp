#include "core/surface/moving/refinement.hpp"

#include "core/surface/moving/cell_shape.hpp"
#include "core/surface/moving/insertion_error.hpp"
#include "core/surface/moving/reconnection.hpp"
#include "core/surface/moving/surface_tangents.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

namespace {

constexpr int most_cut_passes = 40;
constexpr double coarsening = 1.1;

template <class Visit>
void for_each_index(std::size_t count, Visit visit) {
    tbb::this_task_arena::isolate([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1024), [&](const auto& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i)
                visit(i);
        });
    });
}

/// Asks `decide` of every live cell in parallel; `decisions` gets the answers, 0 for empty slots.
template <class Decide>
void decide_all(const MovingMesh& mesh, std::vector<std::uint8_t>& decisions, Decide decide) {
    const auto slots = mesh.quads.slots();
    decisions.assign(slots.size(), 0);
    for_each_index(slots.size(), [&](std::size_t i) {
        if (slots[i].live)
            decisions[i] = decide(static_cast<CellIndex>(i));
    });
}

/// The cells whose decision has any of the bits of `wanted`, in ascending order.
std::vector<CellIndex> decided(const std::vector<std::uint8_t>& decisions, std::uint8_t wanted) {
    std::vector<CellIndex> found;
    for (std::size_t i = 0; i < decisions.size(); ++i)
        if ((decisions[i] & wanted) != 0)
            found.push_back(static_cast<CellIndex>(i));
    return found;
}

/// The living among `cells` and their neighbours, ascending, each once.
std::vector<CellIndex> with_neighbours(const MovingMesh& mesh, std::span<const CellIndex> cells) {
    std::vector<CellIndex> all;
    for (const CellIndex cell : cells) {
        if (!mesh.quads[cell].live)
            continue;
        all.push_back(cell);
        for (const auto& side : mesh.quads[cell].across)
            for (const CellIndex neighbour : side)
                if (neighbour != no_cell)
                    all.push_back(neighbour);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

/// Longest sub-edge of the sides that a cut across `axis` halves.
double width(const MovingMesh& mesh, CellIndex cell, Axis axis) {
    const SquaredLengths lengths = squared_lengths(mesh, mesh.quads[cell].cell);
    const auto side = static_cast<std::size_t>(axis);
    return std::sqrt(std::max(lengths.longest[side], lengths.longest[side + 2]));
}

} // namespace

void Refinement::find_normals(const MovingMesh& mesh) {
    const auto slots = mesh.quads.slots();
    normals_.resize(slots.size());
    if (rules_.cosine <= -1.0)
        return;
    for_each_index(slots.size(), [&](std::size_t i) {
        if (slots[i].live)
            normals_[i] = normal(mesh, slots[i].cell);
    });
}

/// Whether `made`, in the middle of a side, may be too far off to stay where it was interpolated.
bool Refinement::trace_interpolated(MovingMesh& mesh,
                                    VertexId made,
                                    CellIndex index,
                                    std::size_t side) {
    if (!rules_.retrace)
        return false;
    MaterialVertices& vertices = mesh.vertices;
    const Cell& cell = mesh.quads[index].cell;
    const std::array corners{side, (side + 1) % 4};
    std::array<SurfaceTangents, 2> at;
    for (std::size_t i = 0; i < 2; ++i) {
        const VertexId end = cell.corner[corners[i]];
        at[i] = rules_.tangents ? SurfaceTangents{vertices.along_s[end], vertices.along_t[end]}
                                : tangents_in(mesh, cell, corners[i]);
    }
    const double trusted = rules_.trusted_error * rules_.separation;
    const SurfaceTangents between{0.5 * (at[0].s + at[1].s), 0.5 * (at[0].t + at[1].t)};
    if (!(vertices.error[made].apart.length(between) > trusted))
        return false;
    // A traced vertex between interpolated ones shows their error as a fold, which is cut, and so on. They are traced as well, unless
    // they are much better than it was.
    for (std::size_t i = 0; i < 2; ++i) {
        const VertexId end = cell.corner[corners[i]];
        if (vertices.approximated[end] != 0 &&
            vertices.error[end].apart.length(at[i]) > 0.25 * trusted) {
            vertices.approximated[end] = 0; // once
            to_retrace_.push_back(end);
            moved_ = true;
        }
    }
    return true;
}

VertexId Refinement::insert(MovingMesh& mesh, CellIndex index, std::size_t side) {
    const Cell& cell = mesh.quads[index].cell;
    const VertexId a = cell.corner[side];
    const VertexId b = cell.corner[(side + 1) % 4];
    MaterialVertices& vertices = mesh.vertices;
    const bool attached =
        vertices.role[a] == VertexRole::Attached && vertices.role[b] == VertexRole::Attached;
    Midpoint mid = middle_of_side(mesh, index, side, rules_.policy);
    if (attached) { // on the rake itself: nothing is approximate there
        mid.point.carried.position = origin_.position(mid.point.s, mid.point.t);
        mid.point.approximated = false;
        mid.point.error = {};
        mid.bulge = 0.0;
    }
    const VertexId v =
        vertices.add(mid.point, attached ? VertexRole::Attached : VertexRole::Free, mesh.time);
    bool traced = rules_.policy == InsertionPolicy::Exact;
    if (!traced && !attached) {
        add_insertion_error(mesh, v, index, side, rules_.policy);
        traced = trace_interpolated(mesh, v, index, side);
    }
    if (traced) {
        if (!attached)
            to_retrace_.push_back(v);
    } else if (const PointStatus status = flow_.status(mid.point.carried.position);
               status != PointStatus::Inside) {
        vertices.end[v] = status == PointStatus::InObstacle ? CurveEnd::Obstacle : CurveEnd::Domain;
    }
    return v;
}

/// One pass over the cells in `dirty` (all when it is empty); leaves there the cells the next pass must look at.
Result<bool> Refinement::cut_pass(MovingMesh& mesh,
                                  LocalOperations& operations,
                                  std::vector<CellIndex>& dirty,
                                  const std::stop_token& stop,
                                  const WorkPart& work) {
    const auto decide = [&](CellIndex cell) -> std::uint8_t {
        return needed_cut(mesh, cell, rules_, flow_, normals_) != Cut::None;
    };
    std::vector<CellIndex> wanted;
    if (dirty.empty()) {
        find_normals(mesh);
        decide_all(mesh, decisions_, decide);
        wanted = decided(decisions_, 1);
    } else {
        normals_.resize(mesh.quads.slots().size());
        for (const CellIndex cell : dirty)
            normals_[cell] = normal(mesh, mesh.quads[cell].cell);
        std::copy_if(dirty.begin(), dirty.end(), std::back_inserter(wanted), decide);
    }
    if (!work.holds(memory_while_moving(mesh, wanted.size())))
        return fail(Error::Code::Cancelled, "there is not enough memory for the surface");
    operations.touched().clear();
    to_retrace_.clear();
    moved_ = false;
    for (const CellIndex cell : wanted) {
        if (!mesh.quads[cell].live)
            continue;
        const Cut cut = needed_cut(mesh, cell, rules_, flow_, normals_);
        const std::size_t before = operations.touched().size();
        if (cut == Cut::Tear) {
            unresolved_ += !has_dead_vertex(mesh, mesh.quads[cell].cell);
            operations.tear(cell);
            torn_ = true;
        } else if (cut != Cut::None) {
            const Axis axis = cut == Cut::AcrossS ? Axis::S : Axis::T;
            const Axis other = axis == Axis::S ? Axis::T : Axis::S;
            // Hanging nodes may forbid a cut until the cell is cut the other way; small cells wait for the next step instead.
            bool done = operations.split(cell, axis);
            const bool too_long = width(mesh, cell, axis) > rules_.separation;
            if (!done && (too_long || width(mesh, cell, other) > 0.25 * rules_.separation))
                done = operations.split(cell, other);
            if (!done && has_dead_vertex(mesh, mesh.quads[cell].cell)) {
                operations.tear(cell); // what is dead must not stay
                torn_ = true;
            }
        }
        normals_.resize(mesh.quads.slots().size());
        for (std::size_t i = before; i < operations.touched().size(); ++i)
            if (const CellIndex made = operations.touched()[i]; mesh.quads[made].live)
                normals_[made] = normal(mesh, mesh.quads[made].cell);
    }
    if (!to_retrace_.empty())
        if (auto traced = retrace(mesh, origin_, flow_, to_retrace_, trace_, rules_.tangents, stop);
            !traced)
            return tl::unexpected(traced.error());
    dirty = with_neighbours(mesh, operations.touched());
    if (moved_) // all round the vertices that have been traced again
        dirty = with_neighbours(mesh, dirty);
    return !dirty.empty();
}

/// Twice where it did something: what one reconnection makes possible the next may need.
void Refinement::reconnect_pass(MovingMesh& mesh, LocalOperations& operations) {
    const auto reconnect = [&](std::span<const CellIndex> cells) {
        for (const CellIndex cell : cells)
            if (mesh.quads[cell].live)
                if (const auto how = worthwhile_reconnection(mesh, operations, cell, rules_))
                    operations.reconnect(cell, *how);
    };
    operations.touched().clear();
    decide_all(mesh, decisions_, [&](CellIndex cell) -> std::uint8_t {
        return worthwhile_reconnection(mesh, operations, cell, rules_).has_value();
    });
    reconnect(decided(decisions_, 1));
    reconnect(with_neighbours(mesh, operations.touched()));
}

/// REQUIRES: normals_ of the mesh as it is.
bool Refinement::merge_pass(MovingMesh& mesh, LocalOperations& operations) {
    if (rules_.merge <= 0.0)
        return false;
    const auto decide = [&](CellIndex cell, Axis axis) {
        return should_merge(mesh, operations, cell, axis, rules_, flow_, normals_);
    };
    decide_all(mesh, decisions_, [&](CellIndex cell) -> std::uint8_t {
        return static_cast<std::uint8_t>((decide(cell, Axis::S) ? 1 : 0) |
                                         (decide(cell, Axis::T) ? 2 : 0));
    });
    const auto drop = [&](VertexId before, VertexId mid, VertexId after) {
        return droppable(mesh, before, mid, after, rules_);
    };
    bool merged = false;
    for (const Axis axis : {Axis::S, Axis::T})
        for (const CellIndex cell : decided(decisions_, axis == Axis::S ? 1 : 2)) {
            if (!mesh.quads[cell].live || !decide(cell, axis))
                continue;
            operations.merge(cell, axis, drop);
            normals_[cell] = normal(mesh, mesh.quads[cell].cell);
            merged = true;
        }
    return merged;
}

/// Larger cells are joined until there are few enough. False: that is not allowed, or joining does not help.
bool Refinement::keep_budget(MovingMesh& mesh, LocalOperations& operations) {
    if (mesh.quads.live() <= rules_.max_quads)
        return true;
    if (!rules_.coarsens)
        return false;
    RefinementRules kept = rules_;
    rules_.merge = std::max(rules_.merge, 0.35);
    rules_.cosine = -1.0; // a small budget is kept at the cost of the shape
    while (mesh.quads.live() > rules_.max_quads &&
           rules_.separation * coarsening <= rules_.coarsest) {
        rules_.separation *= coarsening;
        find_normals(mesh);
        while (mesh.quads.live() > rules_.max_quads && merge_pass(mesh, operations))
            kept.separation = rules_.separation;
    }
    rules_ = kept;
    return mesh.quads.live() <= rules_.max_quads;
}

Result<bool> Refinement::run(MovingMesh& mesh, std::stop_token stop, const WorkPart& work) {
    LocalOperations operations(
        mesh, [&](CellIndex cell, std::size_t side) { return insert(mesh, cell, side); });
    if (!keep_budget(mesh, operations))
        return false;
    if (rules_.reconnect)
        reconnect_pass(mesh, operations);
    torn_ = false;
    std::vector<CellIndex> dirty;
    for (int pass = 0; pass < most_cut_passes; ++pass) {
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        const auto more = cut_pass(mesh, operations, dirty, stop, work);
        if (!more)
            return tl::unexpected(more.error());
        if (mesh.quads.live() > rules_.max_quads) {
            if (!keep_budget(mesh, operations))
                return false;
            dirty.clear();
            continue;
        }
        if (!*more)
            break;
    }
    merge_pass(mesh, operations);
    if (torn_)
        remove_unused_vertices(mesh);
    return true;
}

void remove_unused_vertices(MovingMesh& mesh) {
    std::vector<std::uint8_t> used(mesh.vertices.slots(), 0);
    for (const LinkedCell& slot : mesh.quads.slots())
        if (slot.live)
            for_each_vertex(slot.cell, [&](VertexId v) { used[v] = 1; });
    for (VertexId v = 0; v < used.size(); ++v)
        if (used[v] == 0 && mesh.vertices.role[v] == VertexRole::Free)
            mesh.vertices.remove(v);
}

} // namespace wakesurf::core
