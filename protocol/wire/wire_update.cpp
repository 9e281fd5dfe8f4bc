#include "protocol/wire/wire_update.hpp"

#include "protocol/wire/wire_points.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace wakesurf::protocol {

namespace {

using core::no_vertex;

struct Matched {
    Runs removed;
    std::uint32_t stay = 0;
    Places places;
};

/// Matches by ids. Elements that stay close up in their order, new ones follow in the order of their ids.
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

bool identity(std::span<const std::uint32_t> place) {
    for (std::uint32_t i = 0; i < place.size(); ++i)
        if (place[i] != i)
            return false;
    return true;
}

/// Returns the cells of a mesh by place, with places for vertices.
std::vector<core::Cell> placed_cells(std::span<const core::Cell> cells,
                                     std::span<const std::uint32_t> cell_place,
                                     std::span<const std::uint32_t> vertex_place) {
    if (identity(cell_place) && identity(vertex_place))
        return {cells.begin(), cells.end()};
    std::vector<core::Cell> result(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
        result[cell_place[i]] = placed(cells[i], vertex_place);
    return result;
}

/// Returns the place of each of `count` elements after sorting.
template <class Less>
std::vector<std::uint32_t> places_in_order(std::size_t count, Less less) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, less);
    std::vector<std::uint32_t> place(count);
    for (std::uint32_t i = 0; i < count; ++i)
        place[order[i]] = i;
    return place;
}

/// Orders vertices along the surface, column by column: neighbours are then coded together. Refined streak
/// surfaces in the order of their ids take twice as much for a KEY (`wire/move`, key_bytes_per_vertex: 3.4
/// and 6.7 on the bundled flow).
void put_in_order(const core::QuadComplex& mesh, Places& vertices) {
    vertices.place = places_in_order(mesh.vertices(), [&](std::uint32_t a, std::uint32_t b) {
        return mesh.s[a] < mesh.s[b] || (mesh.s[a] == mesh.s[b] && mesh.t[a] < mesh.t[b]);
    });
}

/// Orders new cells by their first corners: their differences are then small. By ids a playing streak surface
/// takes 2 % more.
void put_in_order(const core::QuadComplex& mesh,
                  std::span<const std::uint32_t> vertex_place,
                  std::uint32_t stay,
                  Places& cells) {
    std::vector<std::uint32_t> added;
    for (std::uint32_t i = 0; i < mesh.cells.size(); ++i)
        if (cells.place[i] >= stay)
            added.push_back(i);
    std::ranges::stable_sort(
        added, {}, [&](std::uint32_t i) { return vertex_place[mesh.cells[i].corner[0]]; });
    for (std::uint32_t k = 0; k < added.size(); ++k)
        cells.place[added[k]] = stay + k;
}

/// Replaces cells that stay but differ from the clients' once the vertices have closed up. A lost corner is
/// no vertex of the new mesh, so that such a cell differs.
void replace_changed(TopologyEdit& edit,
                     std::span<const core::Cell> kept,
                     std::span<const core::Cell> after) {
    for (std::uint32_t i = 0; i < kept.size(); ++i)
        if (kept[i] != after[i]) {
            edit.replaced_cells.take(i);
            edit.cells.push_back(after[i]);
        }
}

} // namespace

MeshMatch match(const MeshPlaces& held,
                std::span<const core::Cell> before,
                const core::KeyedMesh& mesh,
                bool in_order) {
    MeshMatch result;
    Matched vertices = match_ids(held.vertices, mesh.vertex_id);
    Matched cells = match_ids(held.cells, mesh.cell_id);
    result.places = {std::move(vertices.places), std::move(cells.places)};
    if (held.vertices.id.empty() && in_order)
        put_in_order(mesh.mesh, result.places.vertices);
    put_in_order(mesh.mesh, result.places.vertices.place, cells.stay, result.places.cells);
    result.cells =
        placed_cells(mesh.mesh.cells, result.places.cells.place, result.places.vertices.place);
    TopologyEdit& edit = result.edit;
    edit.removed_cells = std::move(cells.removed);
    edit.removed_vertices = std::move(vertices.removed);
    edit.added_vertices = static_cast<std::uint32_t>(mesh.vertex_id.size()) - vertices.stay;
    edit.added_cells = static_cast<std::uint32_t>(result.cells.size()) - cells.stay;
    const bool same_numbers = edit.removed_vertices.count() + edit.added_vertices +
                                  edit.removed_cells.count() + edit.added_cells ==
                              0;
    if (!same_numbers || !std::ranges::equal(before, result.cells)) {
        result.kept = kept_cells(edit.removed_vertices, edit.removed_cells,
                                 {static_cast<std::uint32_t>(held.vertices.id.size()), before});
        replace_changed(edit, result.kept, result.cells);
    }
    edit.cells.insert(edit.cells.end(), result.cells.begin() + cells.stay, result.cells.end());
    result.vertices_stay = vertices.stay;
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
    return core::fail(
        core::Error::Code::Corrupt,
        fmt::format("the ids of a mesh of {} vertices and {} cells do not ascend, one "
                    "for each",
                    mesh.mesh.vertices(), mesh.mesh.cells.size()),
        "this is a fault of the surface engine; please report it with the rake");
}

namespace {

constexpr std::uint32_t block_vertices = 1u << 15;
constexpr std::size_t body_budget = (512u << 10) - frame_header_bytes; ///< of a frame

struct Piece {
    const Residuals* residuals;
    std::uint32_t begin, end;
};

/// Cuts the residuals into pieces of about equal size.
std::vector<Piece> cut(std::span<const Residuals> points) {
    std::vector<Piece> pieces;
    for (const Residuals& residuals : points) {
        const std::uint32_t parts = (residuals.count + block_vertices - 1) / block_vertices;
        for (std::uint64_t i = 0; i < parts; ++i)
            pieces.push_back({&residuals, static_cast<std::uint32_t>(i * residuals.count / parts),
                              static_cast<std::uint32_t>((i + 1) * residuals.count / parts)});
    }
    return pieces;
}

core::Result<std::vector<PointBlock>> encode_all(std::span<const Residuals> points) {
    const auto pieces = cut(points);
    std::vector<core::Result<PointBlock>> results(pieces.size());
    tbb::parallel_for(std::size_t{0}, pieces.size(), [&](std::size_t i) {
        results[i] = write_block(*pieces[i].residuals, pieces[i].begin, pieces[i].end);
    });
    std::vector<PointBlock> blocks;
    for (auto& result : results) {
        if (!result)
            return tl::unexpected(result.error());
        blocks.push_back(std::move(*result));
    }
    return blocks;
}

/// Returns the bytes of an update, before they are cut into frames.
core::Result<Bytes> whole_update(std::vector<std::uint32_t> numbers,
                                 std::span<const Residuals> points) {
    return encode_all(points).and_then([&](const std::vector<PointBlock>& blocks) {
        for (const PointBlock& block : blocks)
            numbers.insert(numbers.end(), block.numbers.begin(), block.numbers.end());
        return pack_numbers(numbers).map([&](Bytes bytes) {
            for (const PointBlock& block : blocks)
                bytes.insert(bytes.end(), block.draco.begin(), block.draco.end());
            return bytes;
        });
    });
}

/// Returns the number of frames for so many bytes, but not fewer than readers demand for so many vertices.
std::size_t frames_for(std::size_t bytes, std::span<const Residuals> points) {
    std::size_t vertices = 0;
    for (const Residuals& residuals : points)
        vertices += residuals.count;
    return std::max({(bytes + body_budget - 1) / body_budget,
                     (vertices + max_block_vertices - 1) / max_block_vertices, std::size_t{1}});
}

} // namespace

core::Result<SharedFrames> write_update(FrameHeader header,
                                        std::vector<std::uint32_t> numbers,
                                        std::span<const Residuals> points) {
    const auto update = whole_update(std::move(numbers), points);
    if (!update)
        return tl::unexpected(update.error());
    const std::size_t count = frames_for(update->size(), points);
    if (count > std::numeric_limits<std::uint16_t>::max())
        return core::over_limit(std::numeric_limits<std::uint16_t>::max(),
                                "an update needs too many frames",
                                "ask for fewer quads or a larger separation");
    header.frame_count = static_cast<std::uint16_t>(count);
    SharedFrames frames;
    for (std::size_t i = 0; i < count; ++i) {
        header.frame_index = static_cast<std::uint16_t>(i);
        const std::size_t begin = i * update->size() / count;
        const std::size_t end = (i + 1) * update->size() / count;
        frames.push_back(std::make_shared<const Bytes>(
            write_frame({header, std::span(*update).subspan(begin, end - begin)})));
    }
    return frames;
}

} // namespace wakesurf::protocol
