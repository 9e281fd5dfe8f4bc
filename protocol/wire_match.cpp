#include "protocol/wire_match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace wakesurf::protocol {

namespace {

using core::no_vertex;

struct Matched {
    Runs removed;
    std::uint32_t stay = 0;
    Places places;
};

/// Those that stay close up in their order, new ones follow behind them in the order of their ids.
Matched match_ids(const Places& held, std::span<const std::uint32_t> ids) {
    const std::size_t before = held.id.size();
    Matched matched;
    std::vector<std::uint32_t> place(ids.size(), no_vertex);
    std::vector<std::uint8_t> found(before, 0);
    for (std::size_t i = 0, k = 0; i < ids.size(); ++i) {
        while (k < before && held.id[k] < ids[i])
            ++k;
        if (k < before && held.id[k] == ids[i]) {
            place[i] = held.place[k];
            found[held.place[k]] = 1;
            ++matched.stay;
        }
    }
    const bool all_stay = matched.stay == before;
    if (!all_stay) {
        for (std::uint32_t k = 0; k < before; ++k)
            if (found[k] == 0)
                matched.removed.take(k);
        const auto now = numbers_after(matched.removed, static_cast<std::uint32_t>(before));
        for (std::uint32_t& p : place)
            p = p == no_vertex ? no_vertex : now[p];
    }
    std::uint32_t next = matched.stay;
    for (std::uint32_t& p : place)
        if (p == no_vertex)
            p = next++;
    matched.places.id.assign(ids.begin(), ids.end());
    matched.places.place = std::move(place);
    return matched;
}

core::Cell placed(core::Cell cell, std::span<const std::uint32_t> place) {
    for (std::uint32_t& v : cell.corner)
        v = place[v];
    for (std::uint32_t& v : cell.mid)
        v = v == no_vertex ? no_vertex : place[v];
    return cell;
}

/// The cells that stay, as everybody has them once the vertices have closed up. A lost corner is no vertex of the new mesh, so
/// that such a cell differs.
std::vector<core::Cell> kept_cells(std::span<const core::Cell> before,
                                   const Runs& removed_cells,
                                   const Runs& removed_vertices,
                                   std::size_t vertices_before) {
    std::vector<core::Cell> cells = without(removed_cells, before);
    if (removed_vertices.count() > 0) {
        const auto now =
            numbers_after(removed_vertices, static_cast<std::uint32_t>(vertices_before));
        for (core::Cell& cell : cells)
            cell = placed(cell, now);
    }
    return cells;
}

} // namespace

MeshMatch match(const MeshPlaces& held, std::span<const core::Cell> before, const core::KeyedMesh& mesh) {
    MeshMatch result;
    Matched vertices = match_ids(held.vertices, mesh.vertex_id);
    Matched cells = match_ids(held.cells, mesh.cell_id);
    result.cells.resize(mesh.mesh.cells.size());
    for (std::size_t i = 0; i < result.cells.size(); ++i)
        result.cells[cells.places.place[i]] = placed(mesh.mesh.cells[i], vertices.places.place);
    const auto kept =
        kept_cells(before, cells.removed, vertices.removed, held.vertices.id.size());
    for (std::uint32_t i = 0; i < cells.stay; ++i)
        if (kept[i] != result.cells[i]) {
            result.edit.replaced_cells.take(i);
            result.edit.cells.push_back(result.cells[i]);
        }
    result.edit.cells.insert(result.edit.cells.end(), result.cells.begin() + cells.stay,
                             result.cells.end());
    result.edit.added_cells = static_cast<std::uint32_t>(result.cells.size()) - cells.stay;
    result.edit.removed_cells = std::move(cells.removed);
    result.edit.removed_vertices = std::move(vertices.removed);
    result.edit.added_vertices =
        static_cast<std::uint32_t>(mesh.vertex_id.size()) - vertices.stay;
    result.vertices_stay = vertices.stay;
    result.places = {std::move(vertices.places), std::move(cells.places)};
    return result;
}

core::Result<void> check_ids(const core::KeyedMesh& mesh) {
    const auto descends = [](const std::vector<std::uint32_t>& ids) {
        return std::ranges::adjacent_find(ids, std::ranges::greater_equal()) != ids.end();
    };
    if (mesh.vertex_id.size() == mesh.mesh.vertices() &&
        mesh.cell_id.size() == mesh.mesh.cells.size() && !descends(mesh.vertex_id) &&
        !descends(mesh.cell_id))
        return {};
    return core::fail(core::Error::Code::Corrupt,
                      fmt::format("the ids of a mesh of {} vertices and {} cells do not ascend, one "
                                  "for each",
                                  mesh.mesh.vertices(), mesh.mesh.cells.size()),
                      "this is a fault of the surface engine; please report it with the rake");
}

} // namespace wakesurf::protocol
