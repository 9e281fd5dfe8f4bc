// The messages between the server and the process that extracts level sets, and the memory that they share: a
// grid, and the values of one field at its nodes. Both are of one build, so these are plain structures.
#pragma once

#include <cstdint>
#include <type_traits>

namespace wakesurf::importer {

/// The file descriptor of the shared memory in the process.
inline constexpr int level_memory = 3;

inline constexpr std::uint64_t level_magic = 0x57534c4556454c31; // "WSLEVEL1"

/// Stands at the beginning of the memory. Offsets are in bytes from there.
struct LevelGrid {
    std::uint64_t magic = level_magic;
    std::uint64_t bytes = 0; ///< of all
    std::uint64_t nodes = 0;
    /// Nodes along each axis of a uniform or rectilinear grid; 0: a mesh of cells. Such a grid is extracted
    /// in units of its spacing.
    std::uint32_t dimensions[3] = {0, 0, 0};
    std::uint64_t cells = 0;   ///< of a mesh
    std::uint64_t corners = 0; ///< of all its cells
    std::uint64_t values = 0;  ///< offset: a float a node
    std::uint64_t points = 0;  ///< offset: 3 doubles a node
    std::uint64_t first = 0;   ///< offset: cells + 1 int32, where a cell's corners begin
    std::uint64_t corner = 0;  ///< offset: an int32 a corner
    std::uint64_t shape = 0;   ///< offset: VTK's type of a cell, a byte each
};

struct LevelRequest {
    std::uint64_t number = 0;
    std::uint64_t version = 0; ///< of the values: another number if they have changed
    std::uint64_t most_triangles = 0;
    double level = 0.0;
    std::uint64_t gaps = 0; ///< 1: some nodes have no value
};

/// Is followed by 3 doubles a point and 3 uint32 a triangle, unless there are too many.
struct LevelAnswer {
    std::uint64_t magic = level_magic;
    std::uint64_t number = 0; ///< of the request
    std::uint64_t points = 0;
    std::uint64_t triangles = 0;
};

static_assert(std::is_trivially_copyable_v<LevelGrid>);
static_assert(std::is_trivially_copyable_v<LevelRequest>);
static_assert(std::is_trivially_copyable_v<LevelAnswer>);

} // namespace wakesurf::importer
