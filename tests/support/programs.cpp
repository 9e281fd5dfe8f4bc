#include "tests/support/programs.hpp"

#include <filesystem>

namespace wakesurf::tests {

std::string server_program() {
    return WAKESURF_BINARY;
}

std::string importer_program() {
    return WAKESURF_IMPORT_BINARY;
}

std::string bricks_program() {
    return std::filesystem::path(server_program()).replace_filename("wakesurf-bricks");
}

} // namespace wakesurf::tests
