// A DATASET argument of the command line: a built-in flow, a store, or a source to import.
#pragma once

#include "core/base/result.hpp"
#include "store/command/source_options.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace wakesurf::server {

struct DatasetArgument {
    enum class Kind { Flow, Store, Source };
    Kind kind = Kind::Source;
    std::string name; ///< for people, without a path
    std::string flow; ///< the text behind `flow:`
    /// Canonical: the store's folder or web address, or the file, folder or pattern to import.
    std::filesystem::path path;
};

/// Resolves an argument. A folder that is no store stands for the one dataset in it, which the importer
/// finds; a last part with * or % for the files of a series; https://HOST/PATH/STORE for a store on the web,
/// which is not contacted yet. Error: NotFound, Io; as store_address().
core::Result<DatasetArgument> resolve_dataset(const std::string& argument);

/// Refuses times, velocities and periodic axes for anything but sources: stored and computed data have their own. Error:
/// InvalidArgument, beginning with the option.
core::Result<void> check_source_options(const DatasetArgument& argument,
                                        const command::SourceOptions& options);

/// Returns $WAKESURF_STORE, else $XDG_CACHE_HOME/wakesurf, else ~/.cache/wakesurf, else wakesurf-cache beside
/// the current directory.
std::filesystem::path default_store_root();

/// Returns <root>/<name>-<16 hex digits of the canonical source path>, so that equal names do not collide.
/// Another velocity of the same files has another folder, and so have a file without its series and a flow that
/// repeats: a server may show one of them.
std::filesystem::path store_folder(const std::filesystem::path& root,
                                   const DatasetArgument& source,
                                   const command::SourceOptions& options = {});

/// Returns letters, digits, dots, dashes and underscores of a name, for ids and folders; never empty.
std::string slug(std::string_view name);

} // namespace wakesurf::server
