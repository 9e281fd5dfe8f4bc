// An EnSight Gold case file: the files that hold the mesh and each variable at each time-step. Format:
// EnSight User Manual, "EnSight Gold Casefile Format".
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "importer/sources/files/source_files.hpp"

#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Holds a file name, in which asterisks stand for a number of its time set.
struct EnsightFile {
    std::string pattern;
    std::optional<int> time_set;
};

struct EnsightVariable {
    core::FieldInfo field;
    EnsightFile file;
};

struct EnsightTimeSet {
    int id = 0;
    std::vector<double> times;
    std::vector<int> numbers; ///< of the files, one each
    std::string note{};       ///< on times that are listed again; may be empty
};

struct EnsightCase {
    std::filesystem::path folder;
    std::string name; ///< for people: of the case file
    EnsightFile geometry;
    std::vector<EnsightVariable> variables; ///< scalars and vectors with values at all of `times`
    std::vector<EnsightTimeSet> time_sets;
    std::vector<double> times; ///< of the velocity
    bool timeless = false;     ///< the case states none: `times` is 0
    std::string time_note;     ///< on times that are listed again; may be empty
    std::string note;

    const EnsightVariable* find(const core::FieldInfo& field) const;
    /// Returns the file at a time of `times`; for the mesh, which may change less often, the latest one at
    /// that time. Error: Unsupported, if it lies outside of the case's folder.
    core::Result<NamedFile> file_at(const EnsightFile& file, double time) const;
};

/// Reads a case. Error: NotFound, Io, Corrupt, Unsupported (EnSight 6, several time-steps in one file, no
/// vector).
/// @param velocity  asked for: the times are its; may be empty
core::Result<EnsightCase> read_ensight_case(const std::filesystem::path& path,
                                            const std::string& velocity = {});

/// Reads a case from a text. @param folder  of the case's files
core::Result<EnsightCase> parse_ensight_case(std::istream& in,
                                             const std::filesystem::path& folder,
                                             const std::string& name,
                                             const std::string& velocity = {});

} // namespace wakesurf::importer
