#include "core/surface/moving/holes.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/moving/split_criteria.hpp"
#include "core/surface/moving/triangle_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace wakesurf::core {

namespace {

using Loop = std::vector<VertexId>;

constexpr std::size_t most_edges = 64; ///< of a hole that is closed or opened
/// The weight of a bridging triangle: one is made where there is no other way.
constexpr double bridging_weight = 100.0;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr std::size_t widest_bridge = 4; ///< triangles

/// The borders of the surface, the surface to the left, in order of their smallest ids, from where that is.
std::vector<Loop> borders(const MovingMesh& mesh) {
    const auto& ids = mesh.vertices.id;

    struct Open {
        VertexId from, to;
        bool seen;
    };

    const auto slots = mesh.triangles.slots();
    auto open = gather<Open>(slots.size(), [&](std::size_t i, std::vector<Open>& found) {
        const Triangle& t = slots[i];
        for (unsigned k = 0; t.live && k < 3; ++k)
            if (t.across[k] == no_triangle)
                found.push_back({t.begin(k), t.end(k), false});
    });
    const auto before = [&](const Open& edge, std::uint32_t id) { return ids[edge.from] < id; };
    std::sort(open.begin(), open.end(),
              [&](const Open& p, const Open& q) { return ids[p.from] < ids[q.from]; });
    std::vector<Loop> loops;
    for (Open& first : open) {
        if (first.seen)
            continue;
        Loop& loop = loops.emplace_back();
        for (auto edge = open.begin() + (&first - open.data()); edge != open.end() && !edge->seen;
             edge = std::lower_bound(open.begin(), open.end(), ids[edge->to], before)) {
            edge->seen = true;
            loop.push_back(edge->from);
        }
    }
    return loops;
}

/// A hole is gone round the other way than the surface's outer borders.
bool is_hole(const MovingMesh& mesh, const Loop& loop) {
    double s = 0.0, area = 0.0;
    const double t0 = mesh.vertices.t[loop.front()];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const VertexId a = loop[i];
        const ParameterStep step = mesh.parameter_step(a, loop[(i + 1) % loop.size()]);
        area += s * step.t - (mesh.vertices.t[a] - t0) * step.s;
        s += step.s;
    }
    return std::abs(s) < 0.5 && mesh.rectangle.facing * area < 0.0;
}

/// Of a polygon: the lightest of all ways to cut it into triangles.
class Filling {
  public:
    Filling(const RefinementContext& context, Loop polygon)
        : context_(context), mesh_(context.mesh), at_(std::move(polygon)), size_(at_.size()),
          weight_(size_ * size_, 0.0), middle_(size_ * size_, 0) {
        for (std::size_t width = 2; width < size_; ++width)
            for (std::size_t i = 0; i + width < size_; ++i)
                choose(i, i + width);
    }

    bool possible() const { return weight_[size_ - 1] < never; }

    void triangles(std::vector<std::array<VertexId, 3>>& out) const { add(0, size_ - 1, out); }

  private:
    void choose(std::size_t i, std::size_t j) {
        double& best = weight_[i * size_ + j];
        best = never;
        if (!(i == 0 && j + 1 == size_) && !allowed(at_[i], at_[j]))
            return;
        for (std::size_t k = i + 1; k < j; ++k) {
            const double parts = weight_[i * size_ + k] + weight_[k * size_ + j];
            if (!(parts < best))
                continue;
            const double whole = parts + triangle_weight(at_[i], at_[k], at_[j]);
            if (whole < best) {
                best = whole;
                middle_[i * size_ + j] = k;
            }
        }
    }

    /// Whether there may be an edge.
    bool allowed(VertexId a, VertexId b) const {
        const double length = squared_length(mesh_, a, b);
        return length <= context_.longest_allowed() &&
               mesh_.triangles.find(a, b).triangle == no_triangle &&
               mesh_.triangles.find(b, a).triangle == no_triangle &&
               !crosses_obstacle(context_, a, b, length);
    }

    double triangle_weight(VertexId a, VertexId b, VertexId c) const {
        if (!(material_area(mesh_, a, b, c) > least_material) || covers_obstacle(context_, a, b, c))
            return never;
        const double edges =
            squared_length(mesh_, a, b) + squared_length(mesh_, b, c) + squared_length(mesh_, c, a);
        return is_bridging(mesh_, a, b, c) ? bridging_weight * edges : edges;
    }

    void add(std::size_t i, std::size_t j, std::vector<std::array<VertexId, 3>>& out) const {
        if (j - i < 2)
            return;
        const std::size_t k = middle_[i * size_ + j];
        out.push_back({at_[i], at_[k], at_[j]});
        add(i, k, out);
        add(k, j, out);
    }

    const RefinementContext& context_;
    const MovingMesh& mesh_;
    Loop at_;
    std::size_t size_;
    std::vector<double> weight_; ///< of the polygon from i to j, at i * size + j
    std::vector<std::size_t> middle_;
};

/// Returns the triangles of a shortest way from a hole to a border that is none, or nothing where that is long.
/// @param outer  for each vertex, whether it is on such a border
std::vector<TriangleId> bridge_beside(const MaterialTriangles& triangles,
                                      const Loop& hole,
                                      const std::vector<bool>& outer) {
    struct Reached {
        TriangleId triangle;
        std::size_t before, depth;
    };

    std::vector<Reached> reached;
    const auto reach = [&](TriangleId t, std::size_t before, std::size_t depth) {
        if (t != no_triangle && std::none_of(reached.begin(), reached.end(),
                                             [&](const Reached& r) { return r.triangle == t; }))
            reached.push_back({t, before, depth});
    };
    std::vector<TriangleId> fan;
    for (const VertexId v : hole) {
        triangles.fan(v, fan);
        for (const TriangleId t : fan)
            reach(t, 0, 1);
    }
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const Triangle& here = triangles[reached[i].triangle];
        if (std::any_of(here.vertex.begin(), here.vertex.end(),
                        [&](VertexId v) { return outer[v]; })) {
            std::vector<TriangleId> bridge{reached[i].triangle};
            for (std::size_t at = i; reached[at].depth > 1;) {
                at = reached[at].before;
                bridge.push_back(reached[at].triangle);
            }
            return bridge;
        }
        for (unsigned k = 0; reached[i].depth < widest_bridge && k < 3; ++k)
            reach(here.across[k], i, reached[i].depth + 1);
    }
    return {};
}

} // namespace

std::size_t open_holes(const RefinementContext& context) {
    const MaterialVertices& v = context.mesh.vertices;
    MaterialTriangles& triangles = context.mesh.triangles;
    std::vector<Loop> loops = borders(context.mesh);
    const auto holes = std::stable_partition(
        loops.begin(), loops.end(), [&](const Loop& loop) { return !is_hole(context.mesh, loop); });
    if (holes == loops.end())
        return 0;
    std::vector<bool> outer(v.slots(), false);
    for (auto loop = loops.begin(); loop != holes; ++loop)
        for (const VertexId x : *loop) // a tear does not begin at the rake
            outer[x] = v.role[x] == VertexRole::Free;
    const std::size_t before = triangles.live();
    for (auto hole = holes; hole != loops.end(); ++hole) {
        const auto any = [&](const auto& holds) {
            return std::any_of(hole->begin(), hole->end(), holds);
        };
        if (hole->size() > most_edges || any([&](VertexId x) { return triangles.unused(x); }) ||
            !any([&](VertexId x) { return beside_obstacle(context, v.position[x]); }))
            continue;
        for (const TriangleId t : bridge_beside(triangles, *hole, outer)) {
            triangles.tear(t);
            for (const VertexId x : *hole)
                outer[x] = true;
        }
    }
    return before - triangles.live();
}

std::size_t close_holes(const RefinementContext& context) {
    MovingMesh& mesh = context.mesh;
    std::vector<std::array<VertexId, 3>> made;
    std::size_t count = 0;
    for (Loop& loop : borders(mesh)) {
        if (loop.size() > most_edges || context.stop.stop_requested() || !is_hole(mesh, loop))
            continue;
        std::reverse(loop.begin(), loop.end());
        const Filling filling(context, std::move(loop));
        if (!filling.possible())
            continue;
        made.clear();
        filling.triangles(made);
        mesh.triangles.fill(made);
        count += made.size();
    }
    return count;
}

} // namespace wakesurf::core
