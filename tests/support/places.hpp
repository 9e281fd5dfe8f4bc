// The path of the sources, where the fixtures and the bundled simulation are. One file is compiled with it,
// so that all others compile to the same objects in every clone and are found in the compiler's cache.
#pragma once

#include <filesystem>

namespace wakesurf::tests {

std::filesystem::path source_folder();

} // namespace wakesurf::tests
