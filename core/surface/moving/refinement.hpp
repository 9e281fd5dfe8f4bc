// Brings a moving surface back within its limits after a step: flip, clip, cut or tear, join, and pair. What
// may need anything is found in parallel from the mesh as it is, and carried out in rounds (edit_round.hpp).
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/moving/moving_mesh.hpp"
#include "core/surface/moving/origin.hpp"
#include "core/surface/moving/refinement_context.hpp"
#include "core/surface/moving/scan.hpp"

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Memory kept from step to step; nothing in it outlives one, and a copy has its own.
struct RefinementMemory {
    RefinementMemory() = default;

    RefinementMemory(const RefinementMemory&) {}

    RefinementMemory(RefinementMemory&&) = default;

    RefinementMemory& operator=(const RefinementMemory&) { return *this; }

    RefinementMemory& operator=(RefinementMemory&&) = default;
    ~RefinementMemory() = default;

    ScanMemory scan;
    std::vector<VertexId> to_retrace;
};

class Refinement {
  public:
    /// @param before  simulation time at which the step began
    /// @param turn    counts the steps
    /// @param trace   as the mesh was carried with
    Refinement(const Flow& flow,
               const Origin& origin,
               RefinementRules rules,
               double before,
               std::uint64_t turn,
               AdvanceOptions trace,
               RefinementMemory& memory)
        : flow_(flow), origin_(origin), rules_(rules), before_(before), turn_(turn), trace_(trace),
          scan_(memory.scan), to_retrace_(memory.to_retrace) {}

    /// Refines the mesh. Returns false if it has more quads than the rules allow, and no separation that they
    /// allow changes that. Error: Cancelled, OverLimit where there is no memory, and what tracing a vertex
    /// again reports.
    /// @param work  told what memory the mesh takes
    Result<bool> run(MovingMesh& mesh, std::stop_token stop, const WorkPart& work = {});

    /// Returns the rules now in force: the quad budget raises the separation.
    const RefinementRules& rules() const { return rules_; }

    /// Cells that were deleted although all their particles live: the surface could not be followed there.
    std::uint64_t unresolved() const { return unresolved_; }

  private:
    RefinementContext context(MovingMesh& mesh) const { return {mesh, flow_, rules_, stop_}; }

    bool keep_budget(MovingMesh& mesh);
    Result<bool> cut_until_done(MovingMesh& mesh,
                                std::vector<TriangleId> candidates,
                                int with_shape,
                                const WorkPart& work);
    Result<void> clip_at_the_dead(MovingMesh& mesh, std::span<const TriangleId> candidates);
    void cut_pass(MovingMesh& mesh, std::span<const TriangleId> candidates, bool shape);
    void give_up(const RefinementContext& here, TriangleId t, unsigned k);
    void close_torn(MovingMesh& mesh);
    void
    begin_on_edge(MovingMesh& mesh, VertexId made, TriangleId t, unsigned k, double part) const;
    Result<void> pair(MovingMesh& mesh);
    bool wants_trace(const MovingMesh& mesh, VertexId made) const;
    double distance(const MovingMesh& mesh, VertexId v) const;
    void trace_with_ends(MovingMesh& mesh, VertexId made, VertexId a, VertexId b);
    Result<void> trace_again(MovingMesh& mesh);

    const Flow& flow_;
    const Origin& origin_;
    RefinementRules rules_;
    double before_;
    std::uint64_t turn_;
    AdvanceOptions trace_;
    ScanMemory& scan_;
    std::vector<VertexId>& to_retrace_;
    std::stop_token stop_; ///< of run()
    std::uint64_t unresolved_ = 0;
};

/// Removes the cells with a dead vertex, which never comes back, and the vertices that no other cell has: the
/// whole refinement of a grid that stays as it was released. Cost: O(cells + vertices). Source: von Funck,
/// Weinkauf, Theisel, Seidel, Smoke Surfaces, 2008.
void leave_out_dead(MovingMesh& mesh);

/// Frees the slots of vertices that no triangle has and none is handed out with, except attached ones.
void remove_unused_vertices(MovingMesh& mesh);

} // namespace wakesurf::core
