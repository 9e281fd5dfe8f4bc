// The interface of a format's reader to the conversion: the time-steps of a source, each as VTK holds it.
// There is one implementation for each family of formats, in sources/.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/cell_mesh.hpp"
#include "core/dataset/dataset_info.hpp"
#include "store/command/source_options.hpp"
#include "store/store_manifest.hpp"

#include <vtkDataSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::importer {

struct SourceDescription {
    /// Names the dataset for people.
    std::string name;
    /// Names VTK's class and what it reads, as `info` shows it.
    std::string reader;
    /// The times, strictly increasing.
    std::vector<double> times;
    /// A note for the user; may be empty.
    std::string note;
    /// Says where the times come from, if that is not plain; may be empty.
    std::string time_note;
    /// The place of each time-step in its series, if the source states no times: 0, 1, 2, further apart where
    /// numbers of files are missing. Else empty.
    std::vector<double> places;
    /// True if boundary values of the velocity are not used, except on walls at rest.
    bool ignores_boundary_values = false;
    /// The fields of the fluid at one time-step, the first unless describe_by took another; with units if the
    /// format has them, and its ranges.
    std::vector<core::FieldInfo> fields;
    /// The velocity to take unless the user names one, where names alone leave several: of the first phase. Else
    /// empty.
    std::string velocity{};
    /// The axis of an axisymmetric flow, of which the source has a wedge.
    std::optional<core::SymmetryAxis> axis{};
    /// Along these axes the files say that the flow repeats.
    core::PeriodicAxes periodic{};
    /// The scalars that the files state to be the components of a velocity: three names each.
    std::vector<std::array<std::string, 3>> velocities{};
    /// The unit of coordinates; empty if the files do not state it.
    std::string length_unit{};
    /// The unit of times; empty if the files do not state it.
    std::string time_unit{};
    /// Why time-steps cannot be read, by their index: those of which that is known already. A file cut off is
    /// one.
    std::map<std::size_t, core::Error> unreadable{};
};

/// Holds faces at which the fluid ends: a patch of its boundary.
struct WallFaces {
    /// The faces; their points have exactly the coordinates that they have in the blocks.
    vtkSmartPointer<vtkPolyData> faces;
    /// True if the velocity on them is zero, whatever averaging results in.
    bool no_slip = false;
    /// As the files have it; several may share a name, as the pieces of a patch do. May be empty.
    std::string name{};
};

struct SourceStep {
    /// The blocks of the fluid, in the same order at every time-step. They have three-dimensional cells only;
    /// point data are values at the nodes, cell data those the file has, never averaged by the reader.
    /// Blanked points and cells carry vtkGhostType.
    std::vector<vtkSmartPointer<vtkDataSet>> blocks;
    std::vector<WallFaces> walls;
    /// The surfaces of solid regions, for display only.
    std::vector<vtkSmartPointer<vtkPolyData>> solids;
    /// Inlets, outlets and the like, for display only.
    std::vector<WallFaces> others{};
};

/// A source of time-steps. Not thread-safe. Every error names the file (without its folder) and the
/// time-step.
class Source {
  public:
    virtual ~Source() = default;

    const SourceDescription& description() const { return description_; }

    /// Returns the files that all time-steps share (case files, mesh), then those of one time-step. An import
    /// is repeated when they change.
    virtual core::Result<std::vector<store::SourceFile>> shared_files() const = 0;
    virtual core::Result<std::vector<store::SourceFile>> files(std::size_t step) const = 0;

    /// Reads one time-step with the named fields only, and no others where the format allows that.
    /// Error: Corrupt, Io, NotFound (a field is missing at this time-step), Unsupported, OverLimit (memory).
    virtual core::Result<SourceStep> read(std::size_t step,
                                          const std::vector<core::FieldInfo>& fields) = 0;

    /// Returns the fields of one time-step; none if only reading it whole would tell, or if all time-steps have
    /// the same.
    virtual std::optional<std::vector<core::FieldInfo>> fields_at(std::size_t) {
        return std::nullopt;
    }

    /// Describes the fields by this time-step; opening does by the first. Does nothing if all have the same.
    /// Error: as read.
    virtual core::Result<void> describe_by(std::size_t) { return {}; }

  protected:
    SourceDescription description_;
};

/// Says whether an error is that the files of a time-step are cut off or damaged: a series ends before it then.
inline bool ends_series(const core::Error& error) {
    return error.code == core::Error::Code::Corrupt;
}

/// Makes the reader of a format and opens it: it looks at the first time-step. Fails as its `open` does.
template <class Reader, class... Arguments>
core::Result<std::unique_ptr<Source>> opened(Arguments&&... arguments) {
    auto source = std::make_unique<Reader>(std::forward<Arguments>(arguments)...);
    return source->open().map([&]() -> std::unique_ptr<Source> { return std::move(source); });
}

} // namespace wakesurf::importer
