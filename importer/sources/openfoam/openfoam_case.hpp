// An OpenFOAM case, found by listing its folders: the processors it was decomposed into, its regions and its times; and what its
// dictionaries say of them. A case may lack any dictionary: it is then read as a transient one in seconds, whose regions tell by
// their fields what they are.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/sources/files/source_files.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct FoamTime {
    double value = 0.0;
    std::string name; ///< of its folder
};

struct FoamRegion {
    std::string name; ///< empty: the only one, or OpenFOAM's region0
    bool fluid = false;
    std::vector<std::string> walls; ///< its patches of a type of wall, in any part
    /// Maps its patches that continue at another one, in any part, to the names of those; empty if the file
    /// does not say.
    std::map<std::string, std::string> cyclic{};
    std::set<std::string> conformal{}; ///< those of the type cyclic: faces match one by one
    /// The groups of its patches. Fields written by hand have entries for groups as well.
    std::map<std::string, std::vector<std::string>> groups{};
    std::string empty{};            ///< a patch of this type that has faces, if there is one
    std::set<std::string> wedges{}; ///< its patches of this type
    std::set<std::string>
        others{}; ///< those at which the fluid ends but for walls: inlets, outlets
};

struct FoamCase {
    std::filesystem::path folder;
    std::string name;     ///< for people: of the folder
    std::string file;     ///< the path given, for errors
    std::string velocity; ///< asked for, or of the first phase; else empty
    /// The folders with a mesh each: "" alone, or processor0 and so on.
    std::vector<std::string> parts;
    std::vector<FoamRegion> regions;
    /// The times at which every fluid region of every part has a velocity.
    std::vector<FoamTime> times;
    double time_scale = 1.0; ///< what `times` are multiplied by to be in `time_unit`
    std::string time_unit;   ///< if it is not that of the fields
    /// The fields that every fluid region of every part has at all of them; without ranges.
    std::vector<core::FieldInfo> fields;
    /// The folders with a polyMesh that counts at `times`, newest first.
    std::vector<FoamTime> mesh_times;
    std::string note;

    /// Returns the file of a field or mesh, relative to `folder` and without .gz; `instance` is a time or
    /// "constant".
    std::string relative(const std::string& part,
                         const std::string& instance,
                         const std::string& region,
                         const std::string& file) const;
    /// Returns a mesh's file as it counts at `times`: that of the newest time folder with one, else that of
    /// constant; relative as above.
    std::string
    mesh_file(const std::string& part, const std::string& region, const std::string& file) const;
    /// Returns the file that exists, plain or compressed; as named if neither does.
    NamedFile file_at(const std::string& relative) const;
};

/// Finds the parts of a case, its regions and times. `path`: its folder, its .foam or .OpenFOAM file or its system/controlDict.
/// Error: NotFound (no mesh, no times), Unsupported (a mesh that moves, collated files), Corrupt, Io.
/// @param velocity  names the one asked for; may be empty
core::Result<FoamCase> scan_openfoam_case(const std::filesystem::path& path,
                                          const std::string& velocity = {});

/// Returns the case's folder, if `path` is one of those that scan_openfoam_case takes.
std::filesystem::path openfoam_folder(const std::filesystem::path& path);

/// Returns the names of possible fields in a time folder, without .gz and without copies that OpenFOAM itself
/// ignores.
std::set<std::string> foam_fields(const std::filesystem::path& folder);

/// Lists the time folders of one part, by value. Error: Corrupt where two have the same value.
core::Result<std::vector<FoamTime>> list_foam_times(const std::filesystem::path& folder,
                                                    const std::string& part);

/// Sets `times` and the fluid regions: those with a velocity, which is U, or else the vector field of most
/// times. Times that not all processors have are left out, with a note; so is the last one if their files
/// differ. Error: NotFound (no velocity anywhere, or at no time on all processors), Corrupt.
core::Result<void> find_foam_times(FoamCase& found);

/// Sets `mesh_times`. Compares every mesh file in a time folder with the one used before; files that are
/// equal but for their headers are no change. snappyHexMesh leaves its mesh in a time folder, and a run from
/// there leaves the fields of the background mesh behind: only times with the last mesh stay, with a note on
/// the others. Error: Unsupported naming the first file that differs, if the mesh changes as the run goes:
/// its points move, or it is another one at every time. Cost: reads those files.
core::Result<void> keep_times_of_last_mesh(FoamCase& found);

/// Returns the regions that constant/regionProperties calls fluid; empty if it is not there or names none.
std::set<std::string> fluid_regions(const std::filesystem::path& folder);

/// Says whether times count a solver's iterations: system/fvSchemes of a region, or else of the case, has no
/// time derivative, or one that goes at another pace in each cell. @param regions  the fluid ones
bool times_are_iterations(const std::filesystem::path& folder,
                          const std::vector<std::string>& regions);

/// Describes times in degrees of an engine's crank.
struct CrankTimes {
    std::optional<double> revolutions_per_minute; ///< nothing: the case does not say it
};

/// Returns a value if times are degrees of the crank: `userTime` of system/controlDict is engine, or there is
/// a constant/engineGeometry, which only engines' solvers read.
std::optional<CrankTimes> crank_times(const std::filesystem::path& folder);

} // namespace wakesurf::importer
