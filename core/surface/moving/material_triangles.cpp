#include "core/surface/moving/material_triangles.hpp"

#include <algorithm>

namespace wakesurf::core {

namespace {

std::uint64_t directed(VertexId from, VertexId to) {
    return std::uint64_t{from} << 32 | to;
}

} // namespace

TriangleId MaterialTriangles::add(VertexId a, VertexId b, VertexId c) {
    TriangleId t;
    if (free_.empty()) {
        t = static_cast<TriangleId>(slots_.size());
        // The vector grows by an eighth at a time: doubling would hold twice what the surface needs.
        if (slots_.size() == slots_.capacity())
            slots_.reserve(slots_.size() + slots_.size() / 8 + 512);
        slots_.emplace_back();
    } else {
        t = free_.back();
        free_.pop_back();
    }
    slots_[t] = Triangle{};
    slots_[t].vertex = {a, b, c};
    slots_[t].live = true;
    if (const std::size_t wanted = std::max({a, b, c}) + std::size_t{1}; wanted > of_.size()) {
        if (wanted > of_.capacity()) {
            of_.reserve(wanted + wanted / 8 + 256);
            uses_.reserve(wanted + wanted / 8 + 256);
        }
        of_.resize(wanted, no_triangle);
        uses_.resize(wanted, 0);
    }
    for (const VertexId v : slots_[t].vertex) {
        of_[v] = t;
        ++uses_[v];
    }
    touched_.push_back(t);
    loose_.push_back(t);
    return t;
}

void MaterialTriangles::remove(TriangleId t) {
    Triangle& gone = slots_[t];
    part(t);
    for (unsigned k = 0; k < 3; ++k)
        if (gone.across[k] != no_triangle) {
            relink(gone.across[k], t, no_triangle);
            touched_.push_back(gone.across[k]);
        }
    for (unsigned k = 0; k < 3; ++k) {
        const VertexId v = gone.vertex[k];
        if (--uses_[v] == 0)
            left_.push_back(v);
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
    free_.push_back(t);
}

void MaterialTriangles::relink(TriangleId t, TriangleId from, TriangleId to) {
    auto& across = slots_[t].across;
    if (const auto found = std::find(across.begin(), across.end(), from); found != across.end())
        *found = to;
}

/// The triangle is about to become another one.
void MaterialTriangles::change(TriangleId t) {
    part(t);
    touched_.push_back(t);
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
    std::vector<TriangleId> round;
    fan(v, round);
    return round.size() == uses_[v];
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

/// What is about to be linked: the edges of the boundary at some vertices.
void MaterialTriangles::add_open(VertexId v, OpenEdges& open) const {
    std::vector<TriangleId> round;
    if (unused(v) || !fan(v, round))
        return;
    for (const TriangleId t : {round.front(), round.back()})
        for (unsigned k = 0; k < 3; ++k)
            if (slots_[t].across[k] == no_triangle)
                open[directed(slots_[t].begin(k), slots_[t].end(k))] = t;
}

/// Links triangles among themselves and to open edges.
void MaterialTriangles::link(std::span<const TriangleId> made, OpenEdges& open) {
    for (const TriangleId t : made)
        for (unsigned k = 0; k < 3; ++k)
            open[directed(slots_[t].begin(k), slots_[t].end(k))] = t;
    for (const TriangleId t : made)
        for (unsigned k = 0; k < 3; ++k)
            if (const auto twin = open.find(directed(slots_[t].end(k), slots_[t].begin(k)));
                twin != open.end()) {
                slots_[t].across[k] = twin->second;
                slots_[twin->second].across[slots_[twin->second].edge_from(slots_[t].end(k))] = t;
            }
}

void MaterialTriangles::fill(std::span<const std::array<VertexId, 3>> triangles) {
    OpenEdges open;
    for (const auto& triangle : triangles)
        for (const VertexId v : triangle)
            add_open(v, open);
    std::vector<TriangleId> made;
    for (const auto& [a, b, c] : triangles)
        made.push_back(add(a, b, c));
    link(made, open);
}

void MaterialTriangles::append(std::span<const std::array<VertexId, 4>> quads) {
    OpenEdges open;
    for (const auto& quad : quads)
        for (const VertexId v : quad)
            add_open(v, open);
    std::vector<TriangleId> made;
    for (const auto& [a, b, c, d] : quads) {
        made.push_back(add(a, b, c));
        made.push_back(add(a, c, d));
    }
    link(made, open);
    for (std::size_t i = 0; i < made.size(); i += 2)
        pair(made[i], 2, take_id());
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

void MaterialTriangles::split(TriangleId t, unsigned k, VertexId m) {
    change(t);
    const auto [a, b, c] = std::array{slots_[t].begin(k), slots_[t].end(k), slots_[t].opposite(k)};
    const TriangleId beyond_b = slots_[t].across[(k + 1) % 3];
    const TriangleId beyond_a = slots_[t].across[(k + 2) % 3];
    const TriangleId u = slots_[t].across[k];
    const TriangleId tb = add(m, b, c);
    slots_[t].vertex = {a, m, c};
    slots_[t].across = {no_triangle, tb, beyond_a};
    slots_[tb].across = {no_triangle, beyond_b, t};
    if (beyond_b != no_triangle)
        relink(beyond_b, t, tb);
    --uses_[b];
    ++uses_[m];
    of_[b] = tb;
    of_[a] = of_[m] = of_[c] = t;
    if (u == no_triangle)
        return;
    change(u);
    const unsigned j = slots_[u].edge_from(b);
    const VertexId d = slots_[u].opposite(j);
    const TriangleId before_a = slots_[u].across[(j + 1) % 3];
    const TriangleId before_b = slots_[u].across[(j + 2) % 3];
    const TriangleId ua = add(m, a, d);
    slots_[u].vertex = {b, m, d};
    slots_[u].across = {tb, ua, before_b};
    slots_[ua].across = {t, before_a, u};
    slots_[t].across[0] = ua;
    slots_[tb].across[0] = u;
    if (before_a != no_triangle)
        relink(before_a, u, ua);
    --uses_[a];
    ++uses_[m];
    of_[a] = t;
    of_[d] = u;
}

void MaterialTriangles::flip(TriangleId t, unsigned k) {
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
        touched_.push_back(t);
        touched_.push_back(u);
    } else {
        change(t);
        change(u);
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
        relink(before_a, u, t);
    if (beyond_b != no_triangle)
        relink(beyond_b, t, u);
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

void MaterialTriangles::collapse(VertexId gone, VertexId kept, std::span<const TriangleId> ring) {
    for (const TriangleId t : ring) {
        const unsigned k = slots_[t].edge_from(gone);
        if (slots_[t].edge_from(kept) == 3) {
            slots_[t].vertex[k] = kept;
            ++uses_[kept];
            if (slots_[t].odd()) // its hanging vertex is no longer on its edge
                part(t);
            touched_.push_back(t);
            continue;
        }
        change(t);
        const unsigned edge = slots_[t].end(k) == kept ? k : (k + 2) % 3;
        const VertexId apex = slots_[t].opposite(edge);
        const TriangleId p = slots_[t].across[(edge + 1) % 3];
        const TriangleId q = slots_[t].across[(edge + 2) % 3];
        if (p != no_triangle) {
            relink(p, t, q);
            touched_.push_back(p);
        }
        if (q != no_triangle) {
            relink(q, t, p);
            touched_.push_back(q);
        }
        --uses_[kept];
        if (--uses_[apex] == 0)
            left_.push_back(apex);
        of_[apex] = of_[kept] = p != no_triangle ? p : q;
        slots_[t].live = false;
        free_.push_back(t);
    }
    for (const TriangleId t : ring)
        if (slots_[t].live)
            of_[kept] = t;
    of_[gone] = no_triangle;
    uses_[gone] = 0;
    left_.push_back(gone);
    zip(kept);
}

/// Two boundary edges between the same vertices, one from v and one to it, are what is left of a hole: they
/// become one edge.
void MaterialTriangles::zip(VertexId v) {
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
    touched_.push_back(first);
    touched_.push_back(last);
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

void MaterialTriangles::leave_odd(TriangleId t, unsigned k, VertexId hanging, std::uint32_t quad) {
    slots_[t].mate = static_cast<std::uint8_t>(k);
    slots_[t].hanging = hanging;
    slots_[t].quad = quad;
    ++odd_;
}

void MaterialTriangles::part(TriangleId t) {
    Triangle& here = slots_[t];
    if (here.mate == Triangle::alone)
        return;
    if (here.odd()) {
        left_.push_back(here.hanging);
        here.hanging = no_vertex;
        --odd_;
    } else {
        const TriangleId other = here.across[here.mate];
        slots_[other].mate = Triangle::alone;
        touched_.push_back(other);
        loose_.push_back(other);
    }
    here.mate = Triangle::alone;
    loose_.push_back(t);
}

void MaterialTriangles::renumber(std::span<const TriangleId> order,
                                 std::span<const VertexId> vertex_slot) {
    std::vector<TriangleId> slot(slots_.size(), no_triangle);
    for (std::size_t i = 0; i < order.size(); ++i)
        slot[order[i]] = static_cast<TriangleId>(i);
    std::vector<Triangle> sorted;
    sorted.reserve(order.size() + order.size() / 8);
    VertexId last = 0;
    for (const TriangleId old : order) {
        Triangle t = slots_[old];
        for (unsigned k = 0; k < 3; ++k) {
            t.vertex[k] = vertex_slot[t.vertex[k]];
            last = std::max(last, t.vertex[k]);
            if (t.across[k] != no_triangle)
                t.across[k] = slot[t.across[k]];
        }
        if (t.odd())
            t.hanging = vertex_slot[t.hanging];
        sorted.push_back(t);
    }
    slots_ = std::move(sorted);
    free_.clear();
    touched_.clear();
    loose_.clear();
    left_.clear();
    of_.assign(last + 1, no_triangle);
    uses_.assign(last + 1, 0);
    for (TriangleId t = 0; t < slots_.size(); ++t)
        for (const VertexId v : slots_[t].vertex) {
            of_[v] = t;
            ++uses_[v];
        }
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
