// The one place that cleans what people are told of libraries' messages: those name files by their whole paths, objects
// by their addresses, and lines of their own source.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

/// Without folders: of each absolute path its last name stays, and of paths that begin with one of `folders` what follows.
std::string without_folders(std::string text, const std::vector<std::filesystem::path>& folders);

/// A library's message as one sentence of at most 200 characters: without folders, addresses, places in source files, and
/// characters that do not print. Empty where nothing of it tells a person anything.
std::string sentence_of_library(std::string text);

} // namespace wakesurf::importer
