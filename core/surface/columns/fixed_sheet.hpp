// A stream or path surface on the fixed grid of its rake: a column a seed, a row every so much time, quads
// between neighbours, and nothing inserted, joined or torn. Source: von Funck, Weinkauf, Theisel, Seidel,
// Smoke Surfaces, 2008.
#pragma once

#include "core/base/work_done.hpp"
#include "core/surface/columns/sheet_mesh.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface_statistics.hpp"

#include <span>
#include <stop_token>

namespace wakesurf::core {

struct FixedSheet {
    SheetMesh mesh;
    /// Columns by what ended them and steps; and the separation, which is larger where the grid would have
    /// had more quads than allowed.
    SurfaceStatistics statistics;
};

/// @param directions  one or two, of one separation and quad budget, as the plan returns them In a row the
///                    fastest particle goes 3/4 of the separation. A column ends at the last row that its
///                    particle reaches. Where the budget does not suffice rows are longer, then there are
///                    fewer columns. Error: Cancelled, OverLimit where there is no memory, and what tracing
///                    reports.
Result<FixedSheet> fixed_sheet(const SurfacePlan& plan,
                               std::span<const SheetOptions> directions,
                               const Clock& clock,
                               const std::stop_token& stop,
                               const WorkPart& work);

} // namespace wakesurf::core
