// What an OpenFOAM case is made of, found by looking at its folders: the parts it was decomposed into, its
// regions and the times there are.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/sources/files/source_files.hpp"

#include <filesystem>
#include <map>
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
    /// Its patches that continue at another one, in any part, and the names of those; empty where the file
    /// does not say.
    std::map<std::string, std::string> cyclic{};
};

struct FoamCase {
    std::filesystem::path folder;
    std::string name;               ///< for people: of the folder
    std::string file;               ///< what was given, for errors
    std::string velocity;           ///< asked for; may be empty
    std::vector<std::string> parts; ///< folders with a mesh each: "" alone, or processor0 and so on
    std::vector<FoamRegion> regions;
    std::vector<FoamTime> times; ///< where every fluid region of every part has a velocity
    std::vector<core::FieldInfo>
        fields; ///< which every fluid region of every part has at all of them; without ranges
    std::vector<FoamTime>
        mesh_times; ///< folders with a polyMesh that counts at `times`, newest first
    std::string note;

    /// The file of a field or mesh, relative to `folder` and without .gz; `instance` is a time or "constant".
    std::string relative(const std::string& part,
                         const std::string& instance,
                         const std::string& region,
                         const std::string& file) const;
    /// A mesh's file as it counts at `times`: that of the newest time folder with one, else that of constant;
    /// relative as above.
    std::string
    mesh_file(const std::string& part, const std::string& region, const std::string& file) const;
    /// The file as it is, plain or compressed; as named where it is not there.
    NamedFile file_at(const std::string& relative) const;
};

} // namespace wakesurf::importer
