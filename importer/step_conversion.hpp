// One time-step of a source -> its files in a store. What it needs of the first time-step is handed over and not changed,
// so that processes forked after planning share it.
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

/// Lowest and highest of what has been seen; empty at first.
struct Range {
    double lo = std::numeric_limits<double>::infinity();
    double hi = -std::numeric_limits<double>::infinity();

    void include(const Range& other);

    bool empty() const { return !(lo <= hi); }
};

/// What a written time-step tells besides its files.
struct StepRecord {
    std::vector<std::uint32_t> checksums; ///< velocity, then the scalars
    Range speed;
    std::vector<Range> scalars;
};

/// All time-steps have the mesh and the mask of the first.
struct FirstStep {
    std::vector<vtkSmartPointer<vtkDataSet>> blocks; ///< without values
    ObstacleMask mask;
    GridAssembly assembly;
    std::vector<std::uint32_t>
        still; ///< nodes whose velocity is zero: no-slip walls and solid nodes
};

/// Error: Unsupported, naming both time-steps, where the mesh or the mask is another one than at the first.
core::Result<void> check_mesh_of(const ImportPlan& plan,
                                 const FirstStep& first,
                                 std::size_t index,
                                 const SourceStep& step);

core::Result<std::vector<float>> velocity_of(const ImportPlan& plan,
                                             const FirstStep& first,
                                             std::size_t index,
                                             const SourceStep& step);

/// Writes the files of a time-step; the step is not ready before store::StoreWriter::finish_step. Error: NotFound, Corrupt,
/// Unsupported (beyond half precision), Io, naming the time-step. @param layout  of the store
core::Result<StepRecord> write_step(const ImportPlan& plan,
                                    const FirstStep& first,
                                    std::size_t index,
                                    const SourceStep& step,
                                    const store::StoreLayout& layout,
                                    store::StoreWriter& writer);

/// Reads and writes a time-step. Error: also as Source::read and check_mesh_of.
/// @param read  the time-step, checked, where it was read already; null else
core::Result<StepRecord> convert_step(const ImportPlan& plan,
                                      const FirstStep& first,
                                      std::size_t index,
                                      const SourceStep* read,
                                      const store::StoreLayout& layout,
                                      store::StoreWriter& writer);

/// Of vectors, three numbers each; NaN where one of them is, infinite where it is too large.
std::vector<float> magnitudes(const std::vector<float>& vectors);

/// Largest error that half precision makes; infinite where a value is too large for it.
double rounding_error(std::span<const float> values);

/// Of speeds outside of the solid, and of values that are numbers.
Range speed_range(std::span<const float> velocity, std::span<const std::uint8_t> fluid);
Range value_range(std::span<const float> values);

} // namespace wakesurf::importer
