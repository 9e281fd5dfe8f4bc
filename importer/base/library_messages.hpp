// What libraries print and throw. Their output is kept apart from the importer's own, which would otherwise be torn by it, and
// their messages become one sentence for users: without whole paths, addresses of objects and lines of the library's source.
#pragma once

#include "core/base/result.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::importer {

/// The importer's own output, kept apart from that of libraries: those print to standard output and standard
/// error, and would get between its lines of JSON and its one sentence about an error.
struct OwnOutput {
    std::FILE* results = nullptr; ///< the former standard output: progress, descriptions
    std::FILE* errors = nullptr;  ///< the former standard error
};

/// Moves both to descriptors that no library knows, for the rest of this process. Any other output is
/// discarded; with `show_libraries`, and for sanitizers' reports, it goes to standard error.
OwnOutput take_outputs(bool show_libraries);

/// Returns the text without folders: an absolute path becomes its last name, a path below one of `folders`
/// the rest.
std::string without_folders(std::string text, const std::vector<std::filesystem::path>& folders);

/// Keeps what libraries say out of errors, for the whole process: it may quote the content of any file that a source
/// names, and a server shows its errors to everybody with a link. It is printed to `own` instead, for the owner.
void send_library_messages_to(std::FILE* own);

constexpr std::string_view library_message_prefix = "library: "; ///< of each such line

/// Returns a library's message as one sentence of at most 200 characters, without folders, addresses, places
/// in source files, and characters that do not print. Empty if nothing in it is of use to a person, or after
/// send_library_messages_to().
std::string sentence_of_library(std::string text);

/// Returns an error about `what`, a file or a time-step: OverLimit for memory, else Corrupt or Io.
core::Error error_of(const std::exception& thrown, const std::string& what);

/// Catches what VTK would print while it lives: its readers report damage only there, and go on with what they have. Only one may
/// live at a time.
class VtkMessages {
  public:
    /// @param expected  words of messages that are no fault
    explicit VtkMessages(std::vector<std::string> expected = {});
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    /// Returns Corrupt with VTK's first error or warning, as one sentence about `file`, if there was one.
    core::Result<void> verdict(const std::string& file) const;
};

} // namespace wakesurf::importer
