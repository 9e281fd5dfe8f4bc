#include "core/surface/playback/growing_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace wakesurf::core {

namespace {

constexpr std::size_t steps = 1024;

std::size_t step_of(const QuadComplex& mesh, const Cell& cell, double span) {
    double oldest = 0.0;
    for (const auto* ids : {&cell.corner, &cell.mid})
        for (const VertexId v : *ids)
            if (v != no_vertex)
                oldest = std::max(oldest, std::abs(mesh.t[v]));
    return std::min(steps, static_cast<std::size_t>(std::ceil(oldest / span * steps)));
}

template <class T, class Order>
void take(const std::vector<T>& from, const Order& order, std::vector<T>& to) {
    if (from.empty())
        return;
    to.reserve(order.size());
    for (const auto v : order)
        to.push_back(from[v]);
}

/// Returns the vertices `order` of `mesh`, without cells.
template <class Order>
QuadComplex vertices(const QuadComplex& mesh, const Order& order) {
    QuadComplex out;
    take(mesh.position, order, out.position);
    take(mesh.s, order, out.s);
    take(mesh.t, order, out.t);
    take(mesh.velocity, order, out.velocity);
    take(mesh.deformation, order, out.deformation);
    take(mesh.component, order, out.component);
    take(mesh.approximated, order, out.approximated);
    take(mesh.error, order, out.error);
    take(mesh.tangents, order, out.tangents);
    return out;
}

} // namespace

GrowingMesh::GrowingMesh(const QuadComplex& whole, double span, const VertexFields& fields)
    : span_(span), cells_(steps + 1, 0), vertices_(steps + 1, 0) {
    std::vector<std::size_t> step(whole.cells.size());
    for (std::size_t c = 0; c < step.size(); ++c)
        step[c] = step_of(whole, whole.cells[c], span);
    std::vector<std::size_t> cells(whole.cells.size());
    std::iota(cells.begin(), cells.end(), std::size_t{0});
    std::stable_sort(cells.begin(), cells.end(),
                     [&](std::size_t a, std::size_t b) { return step[a] < step[b]; });

    std::vector<VertexId> renumbered(whole.vertices(), no_vertex), order;
    std::vector<Cell> in_order;
    in_order.reserve(cells.size());
    order.reserve(whole.vertices());
    for (const std::size_t c : cells) {
        Cell cell = whole.cells[c];
        for (auto* ids : {&cell.corner, &cell.mid})
            for (VertexId& v : *ids) {
                if (v == no_vertex)
                    continue;
                if (renumbered[v] == no_vertex) {
                    renumbered[v] = static_cast<VertexId>(order.size());
                    order.push_back(v);
                }
                v = renumbered[v];
            }
        in_order.push_back(cell);
        cells_[step[c]] = in_order.size();
        vertices_[step[c]] = order.size();
    }
    for (std::size_t k = 1; k <= steps; ++k) { // steps without cells of their own
        cells_[k] = std::max(cells_[k], cells_[k - 1]);
        vertices_[k] = std::max(vertices_[k], vertices_[k - 1]);
    }
    mesh_ = vertices(whole, order);
    for (const auto& field : fields)
        take(field, order, fields_.emplace_back());
    mesh_.cells = std::move(in_order);
}

std::size_t GrowingMesh::step_at(double age) const {
    return static_cast<std::size_t>(
        std::clamp(std::floor(age / span_ * steps), 0.0, static_cast<double>(steps)));
}

VertexFields GrowingMesh::fields_at(double age) const {
    const auto count = static_cast<std::ptrdiff_t>(vertices_[step_at(age)]);
    VertexFields out;
    for (const auto& field : fields_)
        out.emplace_back(field.begin(), field.begin() + count);
    return out;
}

std::size_t GrowingMesh::bytes() const {
    return memory_of(mesh_) + fields_.size() * mesh_.vertices() * sizeof(float);
}

KeyedMesh GrowingMesh::at(double age) const {
    const std::size_t k = step_at(age);
    KeyedMesh out;
    out.vertex_id.resize(vertices_[k]);
    std::iota(out.vertex_id.begin(), out.vertex_id.end(), 0U);
    out.cell_id.resize(cells_[k]);
    std::iota(out.cell_id.begin(), out.cell_id.end(), 0U);
    out.mesh = vertices(mesh_, out.vertex_id);
    out.mesh.cells.assign(mesh_.cells.begin(),
                          mesh_.cells.begin() + static_cast<std::ptrdiff_t>(cells_[k]));
    return out;
}

} // namespace wakesurf::core
