// Brings a moving surface back within its limits after a step: reconnect, cut, tear, join, until nothing is left to do.
// Decisions are made in parallel from the mesh as it is, and carried out one after the other in the order of the cells, so
// that the result does not depend on the number of threads.
#pragma once

#include "core/base/result.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/moving/merge_criteria.hpp"
#include "core/surface/moving/origin.hpp"
#include "core/surface/moving/refinement_rules.hpp"
#include "core/surface/moving/split_criteria.hpp"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

/// Memory kept from step to step; nothing in it outlives one.
struct RefinementMemory {
    std::vector<Vec3f> normals;          ///< of cell slots
    std::vector<std::uint8_t> decisions; ///< likewise
    std::vector<VertexId> to_retrace;
};

class Refinement {
  public:
    Refinement(const Flow& flow,
               const Origin& origin,
               RefinementRules rules,
               AdvanceOptions trace,
               RefinementMemory& memory)
        : flow_(flow), origin_(origin), rules_(rules), trace_(trace), normals_(memory.normals),
          decisions_(memory.decisions), to_retrace_(memory.to_retrace) {}

    /// False: the mesh has more quads than the rules allow, and no separation that they allow changes that.
    /// Error: Cancelled (also where there is no memory), and what tracing a vertex again reports.
    /// @param work  told what memory the mesh takes
    Result<bool> run(MovingMesh& mesh, std::stop_token stop, const WorkPart& work = {});

    /// As now in force: the quad budget raises the separation.
    const RefinementRules& rules() const { return rules_; }

    /// Cells that were deleted although all their particles live: the surface could not be followed there.
    std::uint64_t unresolved() const { return unresolved_; }

  private:
    Result<bool> cut_pass(MovingMesh& mesh,
                          LocalOperations& operations,
                          std::vector<CellIndex>& dirty,
                          const std::stop_token& stop,
                          const WorkPart& work);
    bool merge_pass(MovingMesh& mesh, LocalOperations& operations);
    void reconnect_pass(MovingMesh& mesh, LocalOperations& operations);
    bool keep_budget(MovingMesh& mesh, LocalOperations& operations);
    VertexId insert(MovingMesh& mesh, CellIndex index, std::size_t side);
    bool trace_interpolated(MovingMesh& mesh, VertexId made, CellIndex index, std::size_t side);
    void find_normals(const MovingMesh& mesh);

    const Flow& flow_;
    const Origin& origin_;
    RefinementRules rules_;
    AdvanceOptions trace_;
    std::vector<Vec3f>& normals_;
    std::vector<std::uint8_t>& decisions_;
    std::vector<VertexId>& to_retrace_;
    bool moved_ = false; ///< vertices the mesh had have been traced again
    bool torn_ = false;  ///< cells have been deleted: vertices may be left alone
    std::uint64_t unresolved_ = 0;
};

/// Frees the slots of vertices no cell uses, except attached ones.
void remove_unused_vertices(MovingMesh& mesh);

} // namespace wakesurf::core
