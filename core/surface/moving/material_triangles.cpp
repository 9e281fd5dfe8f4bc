#include "core/surface/moving/material_triangles.hpp"

#include "core/base/for_each_index.hpp"
#include "core/base/radix_sort.hpp"
#include "core/base/with_spare.hpp"

#include <algorithm>
#include <tuple>

namespace wakesurf::core {

TriangleId MaterialTriangles::empty_slot() {
    if (!changes_.free.empty()) {
        const TriangleId t = changes_.free.back();
        changes_.free.pop_back();
        return t;
    }
    if (slots_.size() == slots_.capacity())
        slots_.reserve(with_spare(slots_.size() + 512));
    slots_.emplace_back();
    return static_cast<TriangleId>(slots_.size() - 1);
}

void MaterialTriangles::make_room(std::size_t vertices) {
    if (vertices <= of_.size())
        return;
    if (vertices > of_.capacity()) {
        of_.reserve(with_spare(vertices + 256));
        uses_.reserve(with_spare(vertices + 256));
    }
    of_.resize(vertices, no_triangle);
    uses_.resize(vertices, 0);
}

void MaterialTriangles::make(TriangleId t,
                             const std::array<VertexId, 3>& vertices,
                             TriangleChanges& changes) {
    slots_[t] = Triangle{};
    slots_[t].vertex = vertices;
    slots_[t].live = true;
    for (const VertexId v : vertices) {
        of_[v] = t;
        ++uses_[v];
    }
    changes.touched.push_back(t);
    changes.loose.push_back(t);
}

TriangleId MaterialTriangles::add(VertexId a, VertexId b, VertexId c) {
    const TriangleId t = empty_slot();
    make_room(std::max({a, b, c}) + std::size_t{1});
    make(t, {a, b, c}, changes_);
    return t;
}

void MaterialTriangles::add(const TriangleChanges& changes) {
    const auto append = [](auto& to, const auto& more) {
        to.insert(to.end(), more.begin(), more.end());
    };
    append(changes_.touched, changes.touched);
    append(changes_.loose, changes.loose);
    append(changes_.left, changes.left);
    append(changes_.free, changes.free);
    changes_.odd += changes.odd;
}

void MaterialTriangles::remove(TriangleId t) {
    Triangle& gone = slots_[t];
    part(t);
    for (unsigned k = 0; k < 3; ++k)
        if (gone.across[k] != no_triangle) {
            relink(gone.across[k], gone.end(k), no_triangle);
            changes_.touched.push_back(gone.across[k]);
        }
    for (unsigned k = 0; k < 3; ++k) {
        const VertexId v = gone.vertex[k];
        if (--uses_[v] == 0)
            changes_.left.push_back(v);
        if (of_[v] != t)
            continue;
        // The edges from v and to v lead to the others that have it.
        of_[v] = gone.across[k] != no_triangle ? gone.across[k] : gone.across[(k + 2) % 3];
        // Another part touches this one there: that is rare, so it is searched.
        if (uses_[v] > 0 && of_[v] == no_triangle)
            for (TriangleId other = 0; other < slots_.size(); ++other)
                if (other != t && slots_[other].live && slots_[other].edge_from(v) < 3) {
                    of_[v] = other;
                    break;
                }
    }
    gone.live = false;
    changes_.free.push_back(t);
}

/// Says what is beyond the edge of `t` from `begin`. Looks at the vertices alone: what is beyond its other edges may change meanwhile.
void MaterialTriangles::relink(TriangleId t, VertexId begin, TriangleId to) {
    slots_[t].across[slots_[t].edge_from(begin)] = to;
}

/// The triangle is about to become another one.
void MaterialTriangles::change(TriangleId t, TriangleChanges& changes) {
    part(t, changes);
    changes.touched.push_back(t);
}

bool MaterialTriangles::fan(VertexId v, std::vector<TriangleId>& out) const {
    out.clear();
    const TriangleId any = of_[v];
    TriangleId t = any;
    bool boundary = false;
    for (;;) { // clockwise, to the boundary
        const TriangleId next = slots_[t].across[slots_[t].edge_from(v)];
        if (next == no_triangle) {
            boundary = true;
            break;
        }
        t = next;
        if (t == any)
            break;
    }
    const TriangleId first = t;
    do {
        out.push_back(t);
        t = slots_[t].across[(slots_[t].edge_from(v) + 2) % 3];
    } while (t != no_triangle && t != first);
    return boundary;
}

bool MaterialTriangles::one_fan(VertexId v) const {
    const TriangleId first = of_[v];
    std::size_t reached = 0;
    for (const unsigned way : {0u, 2u})
        for (TriangleId t = first;;) {
            reached += way == 0 || t != first;
            t = slots_[t].across[(slots_[t].edge_from(v) + way) % 3];
            if (t == first)
                return reached == uses_[v];
            if (t == no_triangle)
                break;
        }
    return reached == uses_[v];
}

MaterialTriangles::Edge MaterialTriangles::find(VertexId a, VertexId b) const {
    if (unused(a))
        return {no_triangle, 0};
    const TriangleId first = of_[a];
    // Clockwise, and where that meets a boundary the other way as well.
    for (const unsigned way : {0u, 2u})
        for (TriangleId t = first;;) {
            const unsigned k = slots_[t].edge_from(a);
            if (slots_[t].end(k) == b)
                return {t, k};
            t = slots_[t].across[(k + way) % 3];
            if (t == first)
                return {no_triangle, 0};
            if (t == no_triangle)
                break;
        }
    return {no_triangle, 0};
}

/// Adds the edges of the boundary at a vertex.
void MaterialTriangles::add_open(VertexId v, std::vector<OpenEdge>& open) const {
    std::vector<TriangleId> round;
    if (unused(v) || !fan(v, round))
        return;
    for (const TriangleId t : {round.front(), round.back()})
        for (unsigned k = 0; k < 3; ++k)
            if (slots_[t].across[k] == no_triangle)
                open.push_back({slots_[t].begin(k), slots_[t].end(k), t});
}

void MaterialTriangles::fill(std::span<const std::array<VertexId, 3>> triangles) {
    std::vector<OpenEdge> open;
    std::vector<VertexId> corners;
    for (const auto& triangle : triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    for (const VertexId v : distinct(std::move(corners)))
        add_open(v, open);
    for (const auto& [a, b, c] : triangles) {
        const TriangleId t = add(a, b, c);
        open.insert(open.end(), {{a, b, t}, {b, c, t}, {c, a, t}});
    }
    const auto before = [](const OpenEdge& p, const OpenEdge& q) {
        return std::tie(p.from, p.to) < std::tie(q.from, q.to);
    };
    std::sort(open.begin(), open.end(), before);
    for (const auto& [from, to, t] : open)
        if (const auto twin =
                std::lower_bound(open.begin(), open.end(), OpenEdge{to, from, t}, before);
            twin != open.end() && twin->from == to && twin->to == from)
            relink(t, from, twin->triangle);
}

void MaterialTriangles::append(std::span<const std::array<VertexId, 4>> quads) {
    std::vector<std::array<VertexId, 3>> halves;
    for (const auto& [a, b, c, d] : quads)
        halves.insert(halves.end(), {{a, b, c}, {a, c, d}});
    fill(halves);
    const std::vector<TriangleId> made(changes_.touched.end() -
                                           static_cast<std::ptrdiff_t>(halves.size()),
                                       changes_.touched.end());
    for (std::size_t i = 0; i < made.size(); i += 2)
        pair(made[i], 2, take_ids(1));
    for (std::size_t i = 0; i < made.size() && !contacts_; ++i) {
        const TriangleId t = made[i];
        for (const VertexId v : std::array(slots_[t].vertex))
            if (slots_[t].live && !one_fan(v)) {
                tear(t);
                if (slots_[made[i ^ 1]].live)
                    tear(made[i ^ 1]);
            }
    }
}

void MaterialTriangles::renumber(std::span<const TriangleId> order,
                                 std::span<const VertexId> vertex_slot) {
    std::vector<TriangleId> slot(slots_.size(), no_triangle);
    for_each_index(order.size(),
                   [&](std::size_t i) { slot[order[i]] = static_cast<TriangleId>(i); });
    std::vector<Triangle> sorted;
    sorted.reserve(with_spare(order.size()));
    sorted.resize(order.size());
    for_each_index(order.size(), [&](std::size_t i) {
        Triangle& t = sorted[i] = slots_[order[i]];
        for (unsigned k = 0; k < 3; ++k) {
            t.vertex[k] = vertex_slot[t.vertex[k]];
            if (t.across[k] != no_triangle)
                t.across[k] = slot[t.across[k]];
        }
    });
    std::vector<Odd> odd;
    for (TriangleId t = 0; t < sorted.size(); ++t)
        if (sorted[t].odd())
            odd.push_back({t, sorted[t].mate, vertex_slot[hanging(order[t])]});
    odd_ = std::move(odd);
    slots_ = std::move(sorted);
    std::vector<TriangleId> of(vertex_slot.size(), no_triangle);
    std::vector<std::uint16_t> uses(vertex_slot.size(), 0);
    for_each_index(of_.size(), [&](std::size_t v) {
        if (uses_[v] == 0)
            return;
        of[vertex_slot[v]] = slot[of_[v]];
        uses[vertex_slot[v]] = uses_[v];
    });
    of_ = std::move(of);
    uses_ = std::move(uses);
    changes_ = {};
    changes_.odd = static_cast<std::ptrdiff_t>(odd_.size());
}

std::string MaterialTriangles::violation() const {
    const auto at = [](TriangleId t, const char* what) {
        return "triangle " + std::to_string(t) + " " + what;
    };
    std::vector<std::uint16_t> uses(uses_.size(), 0);
    for (TriangleId t = 0; t < slots_.size(); ++t) {
        const Triangle& here = slots_[t];
        if (!here.live)
            continue;
        for (unsigned k = 0; k < 3; ++k) {
            if (here.vertex[k] >= uses.size())
                return at(t, "has a vertex that nothing counts");
            ++uses[here.vertex[k]];
            const TriangleId u = here.across[k];
            if (u == no_triangle)
                continue;
            if (u >= slots_.size() || !slots_[u].live)
                return at(t, "has a neighbour that does not exist");
            const unsigned j = slots_[u].edge_from(here.end(k));
            if (j == 3 || slots_[u].end(j) != here.begin(k) || slots_[u].across[j] != t)
                return at(t, "is not known to a neighbour it knows");
        }
        if (here.odd() && std::count_if(odd_.begin(), odd_.end(),
                                        [t](const Odd& each) { return each.triangle == t; }) != 1)
            return at(t, "has not one vertex that hangs on it");
        if (!here.paired())
            continue;
        const TriangleId u = here.across[here.mate];
        if (u == no_triangle || !slots_[u].paired() || slots_[u].across[slots_[u].mate] != t ||
            slots_[u].quad != here.quad)
            return at(t, "is not the other half of its other half");
    }
    for (VertexId v = 0; v < uses.size(); ++v) {
        if (uses[v] != uses_[v])
            return "vertex " + std::to_string(v) + " is not used as often as counted";
        if (uses[v] > 0 && !contacts_ &&
            (!slots_[of_[v]].live || slots_[of_[v]].edge_from(v) == 3 || !one_fan(v)))
            return "vertex " + std::to_string(v) + " has more than one fan";
    }
    return {};
}

} // namespace wakesurf::core
