// Convergence: where two cells side by side are both narrow, the column between them stops and one cell takes
// their place. The mirror image of a strip's split: the vertex where the column stops hangs on the next
// cell's young side. Works on the finished quads of a sheet, so it knows no strips and merges inserted
// columns and seeds alike; vertices only go, they never move. Source: the merging of ribbons in Hultquist
// 1992; on quads McLoughlin, Laramee, Zhang, CGI 2009.
#pragma once

#include "core/surface/columns/zip.hpp"
#include "core/surface/quad_complex.hpp"

#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// A column in a numbering where its vertices follow one another from the rake on.
struct ColumnSpan {
    VertexId first;
    VertexId count;
};

struct MergeLimits {
    ZipRules rules;
    double each;         ///< both cells must be narrower
    double joined;       ///< and so must the one that takes their place
    double least_cosine; ///< of the angle at which the two meet
    /// Bounds the cosine of the angle at which the one then meets those beside it; -1: any.
    double neighbour_cosine = -1.0;
};

/// Merges cells across `columns`, in their order. Which vertices remain in use, the cells tell. Stopped: of
/// some columns.
///
/// @param cells  faces as a sheet zips them: sides 1 and 3 run along columns Cost: O(cells + vertices of the
///               columns).
void merge_columns(std::vector<Cell>& cells,
                   std::span<const ColumnSpan> columns,
                   std::span<const Vec3> position,
                   const MergeLimits& limits,
                   const std::stop_token& stop = {});

} // namespace wakesurf::core
