// Turns zipped strips into one quad complex: columns shared by neighbouring strips become shared vertices.
#pragma once

#include "core/surface/columns/sheet.hpp"
#include "core/surface/quad_complex.hpp"

#include <map>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// A mesh under construction, and what is known of its vertices beyond the mesh's own arrays.
struct SheetMesh {
    QuadComplex complex;
    std::vector<Vec3> stretch; ///< transported tangent dx/ds of every vertex
    /// Vertices by seed parameter: sheets of both directions share the rake.
    std::map<double, VertexId> on_rake;
};

/// Merges what converges (column_merge.hpp), then appends the vertices some cell uses, column by column along
/// the rake, so that neighbours in space are neighbours in memory, and all cells. Cost: O(vertices + cells).
/// False: it was stopped, and the mesh is of no use.
bool append_sheet(SheetMesh& mesh, const Sheet& sheet, const std::stop_token& stop = {});

} // namespace wakesurf::core
