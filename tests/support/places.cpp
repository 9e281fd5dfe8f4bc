#include "tests/support/places.hpp"

namespace wakesurf::tests {

std::filesystem::path source_folder() {
    return WAKESURF_SOURCE_DIR;
}

} // namespace wakesurf::tests
