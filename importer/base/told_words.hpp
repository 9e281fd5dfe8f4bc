// The one place that cleans messages of libraries for users: those name files by their whole paths, objects
// by their addresses, and lines of their own source.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

/// Returns the text without folders: an absolute path becomes its last name, a path below one of `folders`
/// the rest.
std::string without_folders(std::string text, const std::vector<std::filesystem::path>& folders);

/// Keeps what libraries say out of errors, for the whole process: it may quote the content of any file that a source
/// names, and a server's errors are told to everybody with a link. It is printed to `own` instead, for the owner.
void tell_library_words_to(std::FILE* own);

constexpr std::string_view library_words_prefix = "library: "; ///< of each such line

/// Returns a library's message as one sentence of at most 200 characters, without folders, addresses, places
/// in source files, and characters that do not print. Empty if nothing in it is of use to a person, or after
/// tell_library_words_to().
std::string sentence_of_library(std::string text);

} // namespace wakesurf::importer
