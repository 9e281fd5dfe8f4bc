// Exodus II files through vtkExodusIIReader: all element blocks, all times, values at nodes and elements.
#pragma once

#include "importer/base/source.hpp"

namespace wakesurf::importer {

bool is_exodus(const std::filesystem::path& path);

/// Blocks: element blocks of three dimensions, those without the velocity as solids. Walls: side sets and flat blocks called wall. Displacements are not applied: the mesh
/// stands still. Values are VTK's, 64 bits. Error: NotFound, Io, Corrupt, Unsupported, OverLimit.
core::Result<std::unique_ptr<Source>> open_exodus(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
