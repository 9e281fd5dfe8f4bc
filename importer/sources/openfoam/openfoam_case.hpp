// The parts of an OpenFOAM case, found by listing its folders: the processors it was decomposed into, its
// regions and its times.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/sources/files/source_files.hpp"

#include <filesystem>
#include <map>
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

} // namespace wakesurf::importer
