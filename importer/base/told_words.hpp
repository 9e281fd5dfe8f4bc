// The one place that cleans messages of libraries for users: those name files by their whole paths, objects
// by their addresses, and lines of their own source.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Returns the text without folders: an absolute path becomes its last name, a path below one of `folders`
/// the rest.
std::string without_folders(std::string text, const std::vector<std::filesystem::path>& folders);

/// Returns a library's message as one sentence of at most 200 characters, without folders, addresses, places
/// in source files, and characters that do not print. Empty if nothing in it is of use to a person.
std::string sentence_of_library(std::string text);

} // namespace wakesurf::importer
