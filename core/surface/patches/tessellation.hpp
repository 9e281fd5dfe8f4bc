// A surface whose cells are cut into smaller ones that lie on its patches (cell_patch.hpp): what is drawn and
// written is then of fourth order, as its vertices are, and no longer of second.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/quad_complex.hpp"
#include "core/surface/request/surface_plan.hpp"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Limits how finely cells may be cut, and how many quads that may make: 20 GB of them.
inline constexpr std::uint32_t most_tessellated = 64;
inline constexpr std::uint64_t most_tessellated_quads = 100'000'000;

/// A mesh whose cells were cut.
struct Tessellation {
    /// The vertices there were keep their numbers and values; those between are `approximated`. It has
    /// normals. Its velocity between vertices is linear.
    QuadComplex mesh;
    std::uint64_t flat_cells = 0; ///< cells with a side that stayed flat
};

/// Each cell becomes `pieces` times as many quads each way; a mid node stays one, or becomes a corner. As
/// watertight as before: what two cells share is made once. One piece: the mesh as it is.
///
/// @param creases  values of s where the rake has corners, ascending. @param closed  s goes round REQUIRES:
///                 the mesh has tangents, and 1 to most_tessellated pieces Error: OverLimit, for more than
///                 most_tessellated_quads or where there is no memory; InvalidArgument for a mesh without
///                 cells. Same input, same bytes, on any number of threads. Cost: 0.3 microseconds a quad.
Result<Tessellation> tessellate(const QuadComplex& mesh,
                                std::uint32_t pieces,
                                const std::vector<double>& creases,
                                bool closed,
                                const WorkPart& work = {});

/// Tessellates a surface that a plan with tangents has made; velocities are those of the flow. Error: as
/// above; InvalidArgument for a level surface.
/// @param times  at which each vertex is there, as vertex_times; becomes that of all vertices
Result<Tessellation> tessellate(const SurfacePlan& plan,
                                const QuadComplex& mesh,
                                std::vector<double>& times,
                                std::uint32_t pieces,
                                const std::stop_token& stop,
                                const WorkPart& work = {});

} // namespace wakesurf::core
