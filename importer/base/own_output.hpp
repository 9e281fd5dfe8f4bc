// The importer's own output, kept apart from that of libraries: those print to standard output and standard
// error, and would get between its lines of JSON and its one sentence about an error.
#pragma once

#include <cstdio>

namespace wakesurf::importer {

struct OwnOutput {
    std::FILE* results = nullptr; ///< the former standard output: progress, descriptions
    std::FILE* errors = nullptr;  ///< the former standard error
};

/// Moves both to descriptors that no library knows, for the rest of this process. Any other output is
/// discarded; with `show_libraries`, and for sanitizers' reports, it goes to standard error.
OwnOutput take_outputs(bool show_libraries);

} // namespace wakesurf::importer
