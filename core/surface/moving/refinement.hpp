// Brings a moving surface back within its limits after a step: reconnect, cut, tear, join, until nothing is left to do.
// Decisions are made in parallel from the mesh as it is, and carried out one after the other in the order of the cells, so
// that the result does not depend on the number of threads.
#pragma once

#include "core/base/result.hpp"
#include "core/surface/moving/merge_criteria.hpp"
#include "core/surface/moving/origin.hpp"
#include "core/surface/moving/refinement_rules.hpp"
#include "core/surface/moving/split_criteria.hpp"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace wakesurf::core {

class Refinement {
  public:
    /// What is kept between steps is memory only, and what the budget has done to the rules.
    Refinement(const Flow& flow, const Origin& origin, RefinementRules rules, AdvanceOptions trace)
        : flow_(flow), origin_(origin), rules_(rules), trace_(trace) {}

    /// Error: Cancelled, and what tracing a vertex again reports.
    Result<void> run(MovingMesh& mesh, std::stop_token stop);

    /// As now in force: the quad budget raises the separation.
    const RefinementRules& rules() const { return rules_; }

    void coarsen_to(double separation) { rules_.separation = separation; }

  private:
    using Candidates = std::vector<std::pair<CellIndex, std::uint8_t>>;

    Result<void> cut_all(MovingMesh& mesh, const std::stop_token& stop);
    Result<bool> cut_pass(MovingMesh& mesh,
                          LocalOperations& operations,
                          std::vector<CellIndex>& dirty,
                          const std::stop_token& stop);
    bool merge_pass(MovingMesh& mesh, LocalOperations& operations, Axis axis);
    void reconnect_pass(MovingMesh& mesh, LocalOperations& operations);
    void keep_budget(MovingMesh& mesh, LocalOperations& operations);
    VertexId insert(MovingMesh& mesh, VertexId a, VertexId b);
    void find_normals(const MovingMesh& mesh);

    const Flow& flow_;
    const Origin& origin_;
    RefinementRules rules_;
    AdvanceOptions trace_;
    std::vector<Vec3f> normals_;
    std::vector<std::uint8_t> decisions_;
    std::vector<VertexId> to_retrace_;
};

/// Gives back the slots of vertices no cell uses, except attached ones.
void remove_unused_vertices(MovingMesh& mesh);

} // namespace wakesurf::core
