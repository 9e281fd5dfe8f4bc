// The files of a store that describe its grid, and back: node coordinates, cells, what lies beyond their
// faces.
#pragma once

#include "core/base/disk.hpp"
#include "core/dataset/grid.hpp"
#include "store/store_layout.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace wakesurf::store {

struct GridFile {
    std::string name;
    std::vector<std::byte> bytes;
};

/// Returns the description of a grid in store.json.
StoredGrid stored_grid(const core::Grid& grid, bool curvilinear = false);

/// Returns the files of the grid but store.json; none for a uniform one.
std::vector<GridFile> grid_files(const core::Grid& grid);

/// Checks that this process may ever have so much memory. Error: OverLimit. What a manifest or a web server
/// says of sizes is a stranger's word.
core::Result<void> check_fits(const std::string& what, std::uint64_t bytes);

/// Reads a file that all time-steps share, and takes no more memory than what has come and the next piece.
/// Error: NotFound, Io, Corrupt for another size or checksum than the layout says, and without a checksum;
/// OverLimit as check_fits.
core::Result<std::vector<std::byte>> read_fixed_file(const StoreLayout& layout,
                                                     const std::string& name,
                                                     std::uint64_t size,
                                                     const core::Disk& disk);

/// Reads the grid. Error: that of read_fixed_file; Corrupt for coordinates that are not finite or do not
/// rise, and cells with nodes, shapes or neighbours that do not exist. Memory: the files and the grid at the
/// same time.
core::Result<core::Grid> read_grid(const StoreLayout& layout, const core::Disk& disk);

} // namespace wakesurf::store
