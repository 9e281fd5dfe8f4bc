#include "store/store_grid.hpp"

#include "core/base/crc32c.hpp"
#include "core/base/machine_memory.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

namespace wakesurf::store {

using core::CellMesh;
using core::Disk;
using core::Error;
using core::fail;
using core::Grid;
using core::GridKind;
using core::RectilinearGrid;
using core::Result;
using core::UniformGrid;

namespace {

constexpr std::array<const char*, 3> axis_files{"x.f64", "y.f64", "z.f64"};
constexpr const char* points_file = "points.f64";
constexpr const char* cells_file = "cells.u32";
constexpr const char* beyond_file = "beyond.u32";
constexpr const char* shapes_file = "shapes.u8";
constexpr std::uint32_t no_node = 0xffffffffu;

template <class T>
std::vector<std::byte> bytes_of(std::span<const T> values) {
    const auto bytes = std::as_bytes(values);
    return {bytes.begin(), bytes.end()};
}

template <class T>
Result<std::vector<T>> read_values(const StoreLayout& layout,
                                   const std::string& name,
                                   std::uint64_t count,
                                   const Disk& disk) {
    return read_fixed_file(layout, name, count * sizeof(T), disk).map([&](const auto& bytes) {
        std::vector<T> values(static_cast<std::size_t>(count));
        std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    });
}

tl::unexpected<Error> damaged(const std::string& what) {
    return fail(Error::Code::Corrupt, what, "import the dataset again");
}

Result<Grid> read_rectilinear(const StoreLayout& layout, const Disk& disk) {
    RectilinearGrid grid;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto along =
            read_values<double>(layout, axis_files[axis], layout.grid.dimensions[axis], disk);
        if (!along)
            return tl::unexpected(along.error());
        const bool sound =
            std::all_of(along->begin(), along->end(), [](double x) { return std::isfinite(x); }) &&
            std::adjacent_find(along->begin(), along->end(),
                               [](double a, double b) { return !(a < b); }) == along->end();
        if (!sound)
            return damaged(std::string(axis_files[axis]) + " does not hold increasing coordinates");
        grid.coordinates[axis] = std::move(*along);
    }
    return grid;
}

bool sound(const core::MeshCell& cell, std::size_t points, std::size_t cells) {
    for (std::size_t i = 0; i < core::node_count(cell.shape); ++i)
        if (cell.node[i] >= points)
            return false;
    return std::all_of(cell.beyond.begin(), cell.beyond.end(),
                       [&](std::uint32_t b) { return b < cells || b >= core::beyond_wall; });
}

// Both are of length 1 and at right angles, to rounding.
bool sound(const core::SymmetryAxis& axis) {
    constexpr double rounding = 1e-9;
    return core::finite(axis.origin) && std::abs(glm::length(axis.direction) - 1.0) < rounding &&
           std::abs(glm::length(axis.radial) - 1.0) < rounding &&
           std::abs(glm::dot(axis.direction, axis.radial)) < rounding;
}

Result<Grid> read_cells(const StoreLayout& layout, const Disk& disk) {
    const auto points = static_cast<std::size_t>(layout.grid.points);
    const auto cells = static_cast<std::size_t>(layout.grid.cells);
    const auto coordinates = read_values<double>(layout, points_file, 3 * points, disk);
    const auto nodes = read_values<std::uint32_t>(layout, cells_file, 8 * cells, disk);
    const auto beyond = read_values<std::uint32_t>(layout, beyond_file, 6 * cells, disk);
    const auto shapes = read_values<std::uint8_t>(layout, shapes_file, cells, disk);
    if (!coordinates || !nodes || !beyond || !shapes)
        return tl::unexpected(!coordinates ? coordinates.error()
                              : !nodes     ? nodes.error()
                              : !beyond    ? beyond.error()
                                           : shapes.error());
    core::CellMesh mesh;
    mesh.axis = layout.grid.axis;
    if (mesh.axis && !sound(*mesh.axis))
        return damaged("the axis is none");
    mesh.points.resize(points);
    for (std::size_t i = 0; i < points; ++i) {
        mesh.points[i] = {(*coordinates)[3 * i], (*coordinates)[3 * i + 1],
                          (*coordinates)[3 * i + 2]};
        if (!core::finite(mesh.points[i]))
            return damaged(std::string(points_file) + " holds coordinates that are not numbers");
    }
    mesh.cells.resize(cells);
    for (std::size_t i = 0; i < cells; ++i) {
        core::MeshCell& cell = mesh.cells[i];
        if ((*shapes)[i] > static_cast<std::uint8_t>(core::CellShape::Hexahedron))
            return damaged(std::string(shapes_file) + " names shapes that do not exist");
        cell.shape = static_cast<core::CellShape>((*shapes)[i]);
        std::copy_n(nodes->begin() + static_cast<std::ptrdiff_t>(8 * i), 8, cell.node.begin());
        std::copy_n(beyond->begin() + static_cast<std::ptrdiff_t>(6 * i), 6, cell.beyond.begin());
        if (!sound(cell, points, cells))
            return damaged("cell " + std::to_string(i) +
                           " names nodes or neighbours that do not exist");
    }
    return mesh;
}

std::vector<GridFile> files_of(const RectilinearGrid& grid) {
    std::vector<GridFile> files;
    for (std::size_t axis = 0; axis < 3; ++axis)
        files.push_back(
            {axis_files[axis], bytes_of(std::span<const double>(grid.coordinates[axis]))});
    return files;
}

// Writes the first `used` of N entries a cell, `filler` for the others.
template <std::size_t N>
void put(const std::array<std::uint32_t, N>& entries,
         std::size_t used,
         std::uint32_t filler,
         std::byte* to) {
    std::array<std::uint32_t, N> whole = entries;
    std::fill(whole.begin() + static_cast<std::ptrdiff_t>(used), whole.end(), filler);
    std::memcpy(to, whole.data(), sizeof(whole));
}

std::vector<GridFile> files_of(const core::CellMesh& mesh) {
    static_assert(sizeof(core::Vec3) == 3 * sizeof(double));
    constexpr std::size_t node_bytes = sizeof(core::MeshCell::node);
    constexpr std::size_t beyond_bytes = sizeof(core::MeshCell::beyond);
    std::vector<std::byte> nodes(node_bytes * mesh.cells.size());
    std::vector<std::byte> beyond(beyond_bytes * mesh.cells.size());
    std::vector<std::byte> shapes(mesh.cells.size());
    for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
        const core::MeshCell& cell = mesh.cells[i];
        put(cell.node, core::node_count(cell.shape), no_node, nodes.data() + node_bytes * i);
        put(cell.beyond, face_count(cell.shape), core::beyond_domain,
            beyond.data() + beyond_bytes * i);
        shapes[i] = static_cast<std::byte>(cell.shape);
    }
    std::vector<GridFile> files; // an initializer list would copy them
    files.push_back({points_file, bytes_of(std::span<const core::Vec3>(mesh.points))});
    files.push_back({cells_file, std::move(nodes)});
    files.push_back({beyond_file, std::move(beyond)});
    files.push_back({shapes_file, std::move(shapes)});
    return files;
}

} // namespace

StoredGrid stored_grid(const Grid& grid, bool curvilinear) {
    StoredGrid stored;
    if (const auto* uniform = std::get_if<UniformGrid>(&grid)) {
        stored.uniform = *uniform;
    } else if (const auto* rectilinear = std::get_if<RectilinearGrid>(&grid)) {
        stored.kind = GridKind::Rectilinear;
        for (std::size_t axis = 0; axis < 3; ++axis)
            stored.dimensions[axis] =
                static_cast<std::uint32_t>(rectilinear->coordinates[axis].size());
    } else {
        stored.kind = curvilinear ? GridKind::Curvilinear : GridKind::Unstructured;
        stored.points = core::node_count(grid);
        stored.cells = cell_count(grid);
        stored.axis = std::get<CellMesh>(grid).axis;
    }
    return stored;
}

std::vector<GridFile> grid_files(const Grid& grid) {
    if (const auto* rectilinear = std::get_if<RectilinearGrid>(&grid))
        return files_of(*rectilinear);
    if (const auto* mesh = std::get_if<core::CellMesh>(&grid))
        return files_of(*mesh);
    return {};
}

Result<void> check_fits(const std::string& what, std::uint64_t bytes) {
    const std::uint64_t granted = core::granted_memory();
    if (granted == 0 || bytes <= granted)
        return {};
    return core::over_limit(granted, what + " takes " + std::to_string(bytes) +
                                         " bytes, more than the memory that this process may have");
}

Result<std::vector<std::byte>> read_fixed_file(const StoreLayout& layout,
                                               const std::string& name,
                                               std::uint64_t size,
                                               const Disk& disk) {
    const auto checksum = layout.checksums.find(name);
    if (checksum == layout.checksums.end())
        return damaged("the store's manifest has no checksum of " + name);
    const auto file = layout.folder / name;
    const auto found = disk.size(file);
    if (!found)
        return tl::unexpected(found.error());
    if (*found != size)
        return damaged(name + " has " + std::to_string(*found) + " bytes instead of " +
                       std::to_string(size));
    if (auto fits = check_fits(name, size); !fits)
        return tl::unexpected(fits.error());
    constexpr std::uint64_t piece = std::uint64_t{16} << 20;
    std::vector<std::byte> bytes;
    bytes.reserve(static_cast<std::size_t>(size)); // taken when it is written to
    while (bytes.size() < size) {
        const std::size_t at = bytes.size();
        bytes.resize(at + static_cast<std::size_t>(std::min(piece, size - at)));
        if (auto read = disk.read(file, at, std::span(bytes).subspan(at)); !read)
            return tl::unexpected(read.error());
    }
    if (checksum->second != core::crc32c(bytes))
        return damaged(name + " has changed since it was written: its checksum differs");
    return bytes;
}

Result<Grid> read_grid(const StoreLayout& layout, const Disk& disk) {
    switch (layout.grid.kind) {
    case GridKind::Uniform:
        return layout.grid.uniform;
    case GridKind::Rectilinear:
        return read_rectilinear(layout, disk);
    default:
        return read_cells(layout, disk);
    }
}

} // namespace wakesurf::store
