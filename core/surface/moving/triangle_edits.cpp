// How a moving surface's triangles change: each edit takes a few, and those beside them.
#include "core/base/with_spare.hpp"
#include "core/surface/moving/material_triangles.hpp"

#include <algorithm>

namespace wakesurf::core {

std::vector<std::array<TriangleId, 2>> MaterialTriangles::slots_to_split(std::size_t count,
                                                                         std::size_t vertices) {
    make_room(vertices);
    const std::size_t free = changes_.free.size();
    if (const std::size_t needed = slots_.size() + 2 * count - std::min(free, 2 * count);
        needed > slots_.capacity())
        slots_.reserve(with_spare(needed + 512));
    std::vector<std::array<TriangleId, 2>> slots(count);
    for (auto& [first, second] : slots) {
        first = empty_slot();
        second = empty_slot();
    }
    return slots;
}

void MaterialTriangles::split(TriangleId t,
                              unsigned k,
                              VertexId m,
                              const std::array<TriangleId, 2>& slots,
                              TriangleChanges& changes) {
    change(t, changes);
    const auto [a, b, c] = std::array{slots_[t].begin(k), slots_[t].end(k), slots_[t].opposite(k)};
    const TriangleId beyond_b = slots_[t].across[(k + 1) % 3];
    const TriangleId beyond_a = slots_[t].across[(k + 2) % 3];
    const TriangleId u = slots_[t].across[k];
    const auto [tb, ua] = slots;
    make(tb, {m, b, c}, changes);
    slots_[t].vertex = {a, m, c};
    slots_[t].across = {no_triangle, tb, beyond_a};
    slots_[tb].across = {no_triangle, beyond_b, t};
    if (beyond_b != no_triangle)
        relink(beyond_b, c, tb);
    --uses_[b];
    ++uses_[m];
    of_[b] = tb;
    of_[a] = of_[m] = of_[c] = t;
    if (u == no_triangle) {
        changes.free.push_back(ua);
        return;
    }
    change(u, changes);
    const unsigned j = slots_[u].edge_from(b);
    const VertexId d = slots_[u].opposite(j);
    const TriangleId before_a = slots_[u].across[(j + 1) % 3];
    const TriangleId before_b = slots_[u].across[(j + 2) % 3];
    make(ua, {m, a, d}, changes);
    slots_[u].vertex = {b, m, d};
    slots_[u].across = {tb, ua, before_b};
    slots_[ua].across = {t, before_a, u};
    slots_[t].across[0] = ua;
    slots_[tb].across[0] = u;
    if (before_a != no_triangle)
        relink(before_a, d, ua);
    --uses_[a];
    ++uses_[m];
    of_[a] = t;
    of_[d] = u;
}

void MaterialTriangles::flip(TriangleId t, unsigned k, TriangleChanges& changes) {
    const TriangleId u = slots_[t].across[k];
    const unsigned j = facing(t, k);
    const auto [a, b, c] = std::array{slots_[t].begin(k), slots_[t].end(k), slots_[t].opposite(k)};
    const VertexId d = slots_[u].opposite(j);
    const TriangleId beyond_b = slots_[t].across[(k + 1) % 3];
    const TriangleId beyond_a = slots_[t].across[(k + 2) % 3];
    const TriangleId before_a = slots_[u].across[(j + 1) % 3];
    const TriangleId before_b = slots_[u].across[(j + 2) % 3];
    const bool diagonal = slots_[t].paired() && slots_[t].mate == k;
    if (diagonal) { // the quad is the same
        changes.touched.push_back(t);
        changes.touched.push_back(u);
    } else {
        change(t, changes);
        change(u, changes);
    }
    slots_[t].vertex = {a, d, c};
    slots_[t].across = {before_a, u, beyond_a};
    slots_[u].vertex = {d, b, c};
    slots_[u].across = {before_b, beyond_b, t};
    if (diagonal) {
        slots_[t].mate = 1;
        slots_[u].mate = 2;
    }
    if (before_a != no_triangle)
        relink(before_a, d, t);
    if (beyond_b != no_triangle)
        relink(beyond_b, c, u);
    of_[a] = t;
    of_[b] = of_[c] = of_[d] = u;
    --uses_[a];
    --uses_[b];
    ++uses_[c];
    ++uses_[d];
}

bool MaterialTriangles::collapsible(VertexId gone,
                                    VertexId kept,
                                    std::vector<TriangleId>& ring) const {
    const bool boundary = fan(gone, ring);
    std::size_t shared = 0;
    for (const TriangleId t : ring)
        shared += slots_[t].edge_from(kept) < 3;
    if (shared == 0 || shared == ring.size())
        return false;
    std::vector<TriangleId> others;
    const bool other_boundary = fan(kept, others);
    if (boundary && other_boundary && shared != 1)
        return false; // the edge goes from one boundary to another, or along a bridge
    const auto has = [&](std::span<const TriangleId> triangles, VertexId v) {
        return std::ranges::any_of(triangles,
                                   [&](TriangleId t) { return slots_[t].edge_from(v) < 3; });
    };
    std::size_t common = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const unsigned k = slots_[ring[i]].edge_from(gone);
        const VertexId next = slots_[ring[i]].end(k);
        common += next != kept && has(others, next);
        if (boundary && i + 1 == ring.size())
            if (const VertexId last = slots_[ring[i]].opposite(k); last != kept)
                common += has(others, last);
    }
    // A hole of three edges, one of which shrinks, closes.
    return common == shared ||
           (boundary && other_boundary && common == shared + 1 &&
            beyond_boundary(gone, ring, kept) == beyond_boundary(kept, others, gone));
}

/// Returns the end of the boundary edge at v that does not lead to `other`. @param ring  v's, open
VertexId MaterialTriangles::beyond_boundary(VertexId v,
                                            std::span<const TriangleId> ring,
                                            VertexId other) const {
    const Triangle& first = slots_[ring.front()];
    const Triangle& last = slots_[ring.back()];
    const VertexId next = first.end(first.edge_from(v));
    return next != other ? next : last.opposite(last.edge_from(v));
}

void MaterialTriangles::collapse(VertexId gone,
                                 VertexId kept,
                                 std::span<const TriangleId> ring,
                                 TriangleChanges& changes) {
    for (const TriangleId t : ring) {
        const unsigned k = slots_[t].edge_from(gone);
        if (slots_[t].edge_from(kept) == 3) {
            slots_[t].vertex[k] = kept;
            ++uses_[kept];
            if (slots_[t].odd()) // its hanging vertex is no longer on its edge
                part(t, changes);
            changes.touched.push_back(t);
            continue;
        }
        change(t, changes);
        const unsigned edge = slots_[t].end(k) == kept ? k : (k + 2) % 3;
        const VertexId apex = slots_[t].opposite(edge);
        const TriangleId p = slots_[t].across[(edge + 1) % 3];
        const TriangleId q = slots_[t].across[(edge + 2) % 3];
        if (p != no_triangle) {
            relink(p, apex, q);
            changes.touched.push_back(p);
        }
        if (q != no_triangle) {
            slots_[q].across[(slots_[q].edge_from(apex) + 2) % 3] = p; // its edge to the apex
            changes.touched.push_back(q);
        }
        --uses_[kept];
        if (--uses_[apex] == 0)
            changes.left.push_back(apex);
        of_[apex] = of_[kept] = p != no_triangle ? p : q;
        slots_[t].live = false;
        changes.free.push_back(t);
    }
    for (const TriangleId t : ring)
        if (slots_[t].live)
            of_[kept] = t;
    of_[gone] = no_triangle;
    uses_[gone] = 0;
    changes.left.push_back(gone);
    zip(kept, changes);
}

/// Two boundary edges between the same vertices, one from v and one to it, are what is left of a hole: they
/// become one edge.
void MaterialTriangles::zip(VertexId v, TriangleChanges& changes) {
    std::vector<TriangleId> round;
    if (!fan(v, round))
        return;
    const TriangleId first = round.front(), last = round.back();
    const unsigned from = slots_[first].edge_from(v);
    const unsigned to = (slots_[last].edge_from(v) + 2) % 3;
    if (slots_[first].end(from) != slots_[last].begin(to))
        return;
    slots_[first].across[from] = last;
    slots_[last].across[to] = first;
    changes.touched.push_back(first);
    changes.touched.push_back(last);
}

void MaterialTriangles::tear(TriangleId first) {
    std::vector<TriangleId> pending{first}, before, after;
    while (!pending.empty()) {
        const TriangleId t = pending.back();
        pending.pop_back();
        if (!slots_[t].live)
            continue;
        const auto vertices = slots_[t].vertex;
        const auto across = slots_[t].across;
        remove(t);
        for (unsigned k = 0; k < 3; ++k) {
            const VertexId v = vertices[k];
            const TriangleId p = across[k];
            const TriangleId q = across[(k + 2) % 3];
            if (p == no_triangle || q == no_triangle || unused(v) || !slots_[p].live ||
                !slots_[q].live || one_fan(v))
                continue;
            // Two fans are left at this vertex: the smaller goes as well.
            of_[v] = p;
            fan(v, before);
            of_[v] = q;
            fan(v, after);
            auto& fewer = before.size() < after.size() ? before : after;
            of_[v] = before.size() < after.size() ? q : p;
            pending.insert(pending.end(), fewer.begin(), fewer.end());
        }
    }
}

void MaterialTriangles::pair(TriangleId t, unsigned k, std::uint32_t quad) {
    const TriangleId u = slots_[t].across[k];
    slots_[u].mate = static_cast<std::uint8_t>(facing(t, k));
    slots_[t].mate = static_cast<std::uint8_t>(k);
    slots_[t].quad = slots_[u].quad = quad;
}

void MaterialTriangles::leave_odd(std::span<const Odd> triangles) {
    std::erase_if(odd_, [&](const Odd& each) {
        return !slots_[each.triangle].live || !slots_[each.triangle].odd();
    });
    odd_.insert(odd_.end(), triangles.begin(), triangles.end());
    std::sort(odd_.begin(), odd_.end(),
              [](const Odd& a, const Odd& b) { return a.triangle < b.triangle; });
    for (const auto& [t, k, hanging] : triangles) {
        slots_[t].mate = static_cast<std::uint8_t>(k);
        slots_[t].is_odd = true;
        slots_[t].quad = take_ids(1);
    }
    changes_.odd += static_cast<std::ptrdiff_t>(triangles.size());
}

VertexId MaterialTriangles::hanging(TriangleId t) const {
    return std::lower_bound(odd_.begin(), odd_.end(), t,
                            [](const Odd& each, TriangleId its) { return each.triangle < its; })
        ->hanging;
}

void MaterialTriangles::part(TriangleId t, TriangleChanges& changes) {
    Triangle& here = slots_[t];
    if (here.mate == Triangle::alone)
        return;
    if (here.odd()) {
        changes.left.push_back(hanging(t));
        here.is_odd = false;
        --changes.odd;
    } else {
        const TriangleId other = here.across[here.mate];
        slots_[other].mate = Triangle::alone;
        changes.touched.push_back(other);
        changes.loose.push_back(other);
    }
    here.mate = Triangle::alone;
    changes.loose.push_back(t);
}

} // namespace wakesurf::core
