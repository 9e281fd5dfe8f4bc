// Memory shared with the process that extracts level sets: a dataset's grid, and room for the values of one
// field.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"
#include "importer/level_message.hpp"

#include <cstddef>
#include <span>

namespace wakesurf::server {

/// Returns the bytes for sharing a grid. Error: OverLimit for a mesh with more corners than can be numbered.
core::Result<std::size_t> level_memory_bytes(const core::Grid& grid);

/// Holds the memory. Only a process that is given its descriptor can map it, and its size is sealed.
class LevelMemory {
  public:
    /// Copies the grid. Error: as level_memory_bytes; Io.
    static core::Result<LevelMemory> of(const core::Grid& grid);
    ~LevelMemory();
    LevelMemory(LevelMemory&& other) noexcept;
    LevelMemory& operator=(LevelMemory&& other) noexcept;

    int file() const { return file_; }

    std::size_t bytes() const { return static_cast<std::size_t>(head_.bytes); }

    /// Returns the values, one a node.
    std::span<float> values() const;

  private:
    LevelMemory() = default;

    int file_ = -1;
    void* start_ = nullptr;
    importer::LevelGrid head_; ///< not read again from memory that the process may write
};

} // namespace wakesurf::server
