// What the importer says itself, apart from what the libraries print that read files: those write to standard output and
// standard error as they like, and would get between its lines of JSON and its one sentence about an error.
#pragma once

#include <cstdio>

namespace wakesurf::importer {

struct OwnOutput {
    std::FILE* results = nullptr; ///< where standard output went: progress, descriptions
    std::FILE* errors = nullptr;  ///< where standard error went
};

/// Moves both to descriptors of their own, which no library knows, for the rest of this process. Whatever else is printed goes
/// nowhere; with `show_libraries`, and what sanitizers report, to standard error.
OwnOutput take_outputs(bool show_libraries);

} // namespace wakesurf::importer
