// The files of a source: their names for people, their state, which decides whether an import of them is still good, and the
// paths that files name. If confined, the author of such a file cannot make the importer read other files of the machine: paths
// outside of its folder are refused. Secrets are refused in any case.
#pragma once

#include "core/base/result.hpp"
#include "store/store_manifest.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct NamedFile {
    std::filesystem::path path;
    std::string name; ///< without the folder of the source
};

/// Returns size and modification time of every file, in the order given. Error: NotFound naming the missing
/// file, Io.
core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<NamedFile>& files);

/// Allows, for the whole process and before its first source is opened, files anywhere that the user may
/// read, named by .., an absolute path or a link. It is for sources that the user named on a command line.
/// Until this is called, paths are confined.
void allow_paths_out_of_folder();

/// Refuses what lies in these files and folders, canonical paths, for the whole process.
void refuse_secrets(const std::vector<std::filesystem::path>& secrets);

/// Returns a name for messages: of an absolute path, whose folders are private, the file's name only.
std::string name_for_messages(const std::string& name);

/// Error: Unsupported, if the path leads to a secret, or to a file of HDF5 while paths are confined and the kernel has
/// no Landlock: its library follows links. @param what  begins the message: "u.pvd names v.vti"
core::Result<void> check_readable(const std::filesystem::path& path, const std::string& what);

/// Returns `folder` / `name`, without following links. Error: Unsupported, if .., an absolute path or a
/// symbolic link leads out of the folder while paths are confined; as check_readable. @param named_by  the file that names it, for
/// the message
core::Result<std::filesystem::path> named_path(const std::filesystem::path& folder,
                                               const std::string& name,
                                               const std::string& named_by);

/// Checks as named_path does every symbolic link in a folder and below. Error: of the first that is refused.
core::Result<void> check_links(const std::filesystem::path& folder, const std::string& named_by);

} // namespace wakesurf::importer
