#include "server/catalogue/shipped_files.hpp"

namespace wakesurf::server {

std::filesystem::path this_program() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

core::Result<std::filesystem::path> bundled_simulation() {
    const std::filesystem::path bin = this_program().parent_path();
    for (const char* place :
         {"../share/wakesurf/data/sqcyl/sqcyl.pvd", "../../../data/sqcyl/sqcyl.pvd"})
        if (std::error_code ignored; std::filesystem::exists(bin / place, ignored))
            return std::filesystem::weakly_canonical(bin / place);
    return core::fail(core::Error::Code::NotFound,
                      "the bundled simulation is not beside this program",
                      "name a dataset with --data");
}

} // namespace wakesurf::server
