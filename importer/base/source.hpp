// What a reader of a format offers the conversion: the time-steps of a source, each as VTK holds it. One
// implementation a family of formats, in sources/.
#pragma once

#include "command/source_options.hpp"
#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "store/store_manifest.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct SourceDescription {
    std::string name;          ///< of the dataset, for people
    std::string reader;        ///< VTK's class and what it reads, as `info` shows it
    std::vector<double> times; ///< strictly increasing
    std::string note;          ///< what a user should know; may be empty
    std::string time_note;     ///< where the times come from, if that is not plain; may be empty
    /// Where no time is stated: where each time-step stands in its series, 0, 1, 2, further apart where numbers of files are missing.
    /// Empty where the source states its times.
    std::vector<double> places;
    bool ignores_boundary_values = false; ///< of the velocity, but for walls at rest
    std::vector<core::FieldInfo>
        fields; ///< of the fluid, units where the format has them, ranges of the first time-step
    std::string length_unit{}; ///< of coordinates; empty where the files do not state it
    std::string time_unit{};   ///< of times; empty where the files do not state it
};

/// Faces on which the fluid ends.
struct WallFaces {
    vtkSmartPointer<vtkPolyData>
        faces;            ///< points have exactly the coordinates they have in the blocks
    bool no_slip = false; ///< the velocity is zero on them, whatever averaging says
};

struct SourceStep {
    /// Of the fluid, in the same order at every time-step. Three-dimensional cells only; point data are values at the nodes, cell data
    /// those the file has, never averaged by the reader. Blanked points and cells carry vtkGhostType.
    std::vector<vtkSmartPointer<vtkDataSet>> blocks;
    std::vector<WallFaces> walls;
    std::vector<vtkSmartPointer<vtkPolyData>>
        solids; ///< surfaces of solid regions, for display only
};

/// Not thread-safe. Every error names the file (without its folder) and the time-step it is about.
class Source {
  public:
    virtual ~Source() = default;

    virtual const SourceDescription& description() const = 0;

    /// What all time-steps share (case files, mesh), then those of one time-step: an import is repeated when they change.
    virtual core::Result<std::vector<store::SourceFile>> shared_files() const = 0;
    virtual core::Result<std::vector<store::SourceFile>> files(std::size_t step) const = 0;

    /// Reads one time-step with the named fields only, and no others where the format allows that.
    /// Error: Corrupt, Io, NotFound (a field is missing at this time-step), Unsupported, OverLimit (memory).
    virtual core::Result<SourceStep> read(std::size_t step,
                                          const std::vector<core::FieldInfo>& fields) = 0;
};

} // namespace wakesurf::importer
