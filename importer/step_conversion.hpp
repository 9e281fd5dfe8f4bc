// One time-step of a source -> its files in a store. The parts of the first time-step that it needs are
// passed in and not changed, so that processes forked after planning share them.
#pragma once

#include "core/base/result.hpp"
#include "importer/assembly/grid_assembly.hpp"
#include "importer/assembly/obstacle_mask.hpp"
#include "importer/import_plan.hpp"
#include "store/store_writer.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace wakesurf::importer {

/// Holds the lowest and the highest value seen; empty at first.
struct Range {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();

    void include(const Range& other);

    bool empty() const { return !(lo <= hi); }
};

/// Holds the facts about a written time-step besides its files.
struct StepRecord {
    std::vector<std::uint32_t> checksums; ///< velocity, then the scalars
    Range speed;
    std::vector<Range> scalars;
    bool tears = false; ///< velocities jump at points that are one node, see MeetingPoints
};

/// Holds the mesh and the mask of the first time-step, which all others must have.
struct FirstStep {
    std::vector<vtkSmartPointer<vtkDataSet>> blocks; ///< without values
    ObstacleMask mask;
    GridAssembly assembly;
    core::PeriodicAxes periodic{};
    /// The nodes whose velocity is zero: no-slip walls and solid nodes.
    std::vector<std::uint32_t> still;
};

/// Brings a time-step whose mesh is that of the first in another order, or in other pieces, into its order.
/// Returns Unsupported, naming both time-steps, if the mesh or the mask is another one.
core::Result<void>
take_mesh_of(const ImportPlan& plan, const FirstStep& first, std::size_t index, SourceStep& step);

core::Result<std::vector<float>> velocity_of(const ImportPlan& plan,
                                             const FirstStep& first,
                                             std::size_t index,
                                             const SourceStep& step);

/// Writes the files of a time-step; the step is not ready before store::StoreWriter::finish_step. Error:
/// NotFound, Corrupt, Unsupported (beyond half precision), Io, naming the time-step. @param layout  of the
/// store
core::Result<StepRecord> write_step(const ImportPlan& plan,
                                    const FirstStep& first,
                                    std::size_t index,
                                    const SourceStep& step,
                                    const store::StoreLayout& layout,
                                    store::StoreWriter& writer);

/// Reads and writes a time-step. Error: also as Source::read and take_mesh_of.
/// @param read  the time-step, checked, if it was read already; else null
core::Result<StepRecord> convert_step(const ImportPlan& plan,
                                      const FirstStep& first,
                                      std::size_t index,
                                      const SourceStep* read,
                                      const store::StoreLayout& layout,
                                      store::StoreWriter& writer);

/// Returns the magnitudes of vectors of three numbers each; NaN if one of them is, infinite if it is too
/// large.
std::vector<float> magnitudes(const std::vector<float>& vectors);

/// Returns the largest error that half precision makes; infinite if a value is too large for it.
double rounding_error(std::span<const float> values);

/// Return the range of speeds outside of the solid, and that of values that are numbers.
Range speed_range(std::span<const float> velocity, std::span<const std::uint8_t> fluid);
Range value_range(std::span<const float> values);

} // namespace wakesurf::importer
