#include "server/data/levels/level_memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <limits>
#include <utility>
#include <variant>

namespace wakesurf::server {

using core::Error;

namespace {

std::uint64_t mesh_corners(const core::CellMesh& mesh) {
    std::uint64_t corners = 0;
    for (const core::MeshCell& cell : mesh.cells)
        corners += core::node_count(cell.shape);
    return corners;
}

/// Returns the offsets of all parts.
importer::LevelGrid memory_layout(const core::Grid& grid) {
    importer::LevelGrid head;
    head.nodes = core::node_count(grid);
    std::uint64_t at = sizeof(importer::LevelGrid);
    const auto place = [&at](std::uint64_t count, std::uint64_t size) {
        const std::uint64_t here = (at + 63) / 64 * 64;
        at = here + count * size;
        return here;
    };
    head.values = place(head.nodes, sizeof(float));
    if (const auto* uniform = std::get_if<core::UniformGrid>(&grid)) {
        for (std::size_t k = 0; k < 3; ++k)
            head.dimensions[k] = uniform->dimensions[k];
    } else if (const auto* rectilinear = std::get_if<core::RectilinearGrid>(&grid)) {
        for (std::size_t k = 0; k < 3; ++k)
            head.dimensions[k] = static_cast<std::uint32_t>(rectilinear->coordinates[k].size());
    } else {
        const auto& mesh = std::get<core::CellMesh>(grid);
        head.cells = mesh.cells.size();
        head.corners = mesh_corners(mesh);
        head.points = place(head.nodes, sizeof(core::Vec3));
        head.first = place(head.cells + 1, sizeof(std::int32_t));
        head.corner = place(head.corners, sizeof(std::int32_t));
        head.shape = place(head.cells, 1);
    }
    head.bytes = at;
    return head;
}

/// Returns VTK's cell type: VTK numbers the nodes of these shapes like us.
std::uint8_t vtk_shape(core::CellShape shape) {
    switch (shape) {
    case core::CellShape::Tetrahedron:
        return 10;
    case core::CellShape::Pyramid:
        return 14;
    case core::CellShape::Wedge:
        return 13;
    case core::CellShape::Hexahedron:
        break;
    }
    return 12;
}

void copy_mesh(const core::CellMesh& mesh, const importer::LevelGrid& head, std::byte* start) {
    std::memcpy(start + head.points, mesh.points.data(), mesh.points.size() * sizeof(core::Vec3));
    auto* first = reinterpret_cast<std::int32_t*>(start + head.first);
    auto* corner = reinterpret_cast<std::int32_t*>(start + head.corner);
    auto* shape = reinterpret_cast<std::uint8_t*>(start + head.shape);
    std::int32_t corners = 0;
    for (const core::MeshCell& cell : mesh.cells) {
        *first++ = corners;
        *shape++ = vtk_shape(cell.shape);
        const std::size_t count = core::node_count(cell.shape);
        for (std::size_t k = 0; k < count; ++k)
            *corner++ = static_cast<std::int32_t>(cell.node[k]);
        corners += static_cast<std::int32_t>(count);
    }
    *first = corners;
}

core::Error no_shared_memory() {
    return {Error::Code::Io, "cannot share memory with the process that extracts level sets", {}};
}

} // namespace

core::Result<std::size_t> level_memory_bytes(const core::Grid& grid) {
    const importer::LevelGrid head = memory_layout(grid);
    constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
    if (head.corners > most || head.nodes > most)
        return core::over_limit(most, "this mesh has too many cells for level sets");
    return static_cast<std::size_t>(head.bytes);
}

core::Result<LevelMemory> LevelMemory::of(const core::Grid& grid) {
    const auto bytes = level_memory_bytes(grid);
    if (!bytes)
        return tl::unexpected(bytes.error());
    LevelMemory memory;
    memory.file_ = ::memfd_create("wakesurf-levels", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (memory.file_ < 0 || ::ftruncate(memory.file_, static_cast<off_t>(*bytes)) != 0)
        return tl::unexpected(no_shared_memory());
    ::fcntl(memory.file_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL);
    void* const start =
        ::mmap(nullptr, *bytes, PROT_READ | PROT_WRITE, MAP_SHARED, memory.file_, 0);
    if (start == MAP_FAILED)
        return tl::unexpected(no_shared_memory());
    memory.start_ = start;
    memory.head_ = memory_layout(grid);
    std::memcpy(start, &memory.head_, sizeof(memory.head_));
    if (const auto* mesh = std::get_if<core::CellMesh>(&grid))
        copy_mesh(*mesh, memory.head_, static_cast<std::byte*>(start));
    return memory;
}

LevelMemory::~LevelMemory() {
    if (start_ != nullptr)
        ::munmap(start_, bytes());
    if (file_ >= 0)
        ::close(file_);
}

LevelMemory::LevelMemory(LevelMemory&& other) noexcept
    : file_(std::exchange(other.file_, -1)), start_(std::exchange(other.start_, nullptr)),
      head_(other.head_) {}

LevelMemory& LevelMemory::operator=(LevelMemory&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(start_, other.start_);
    std::swap(head_, other.head_);
    return *this;
}

std::span<float> LevelMemory::values() const {
    return {reinterpret_cast<float*>(static_cast<std::byte*>(start_) + head_.values),
            static_cast<std::size_t>(head_.nodes)};
}

} // namespace wakesurf::server
