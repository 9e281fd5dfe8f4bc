// The points of a rake in a file: rows of a table, or a line that another program drew.
#pragma once

#include "core/base/result.hpp"
#include "core/base/vec3.hpp"

#include <filesystem>
#include <vector>

namespace wakesurf::importer {

/// Returns the points of a .csv or .txt (columns x, y and z, by a header or the first three), or of a .vtp, .vtk
/// or .obj: those of its one line in their order, else all of them. A point that repeats the one before it is
/// left out. Error: Io, Corrupt, Unsupported (another extension, faces), OverLimit (more than 100,000 points),
/// InvalidArgument (several lines, unless `separate`: the points need not lie on a line).
/// REQUIRES: no VtkMessages lives.
core::Result<std::vector<core::Vec3>> read_rake_file(const std::filesystem::path& path,
                                                     bool separate);

} // namespace wakesurf::importer
