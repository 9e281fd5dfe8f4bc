// Which Exodus II files are one dataset, by their names: run.e, run.e-s002, run.e-s003 continue one another;
// run.e.2.0 and run.e.2.1 are the two pieces of one, as parallel programs write them.
#pragma once

#include "core/base/result.hpp"
#include "importer/sources/files/source_files.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct ExodusName {
    std::string base;     ///< run.e
    unsigned restart = 1; ///< 2 of -s002
    unsigned pieces = 0;  ///< 0: not in pieces
    unsigned piece = 0;
    std::string of_restart{}; ///< "-s002"; empty for the first
};

/// Takes a file's name apart; what has no such ending is its own base.
ExodusName exodus_name(const std::string& name);

struct ExodusSet {
    std::string name;                          ///< of the dataset
    std::vector<std::vector<NamedFile>> parts; ///< the pieces of each restart, in order
    std::string note;                          ///< on a restart that is missing
};

/// Finds the files that belong together with one of them. @param alone  no other restarts. Error: NotFound
/// naming a piece that is missing, Io.
core::Result<ExodusSet> find_exodus_set(const std::filesystem::path& path, bool alone);

} // namespace wakesurf::importer
