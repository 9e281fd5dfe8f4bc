#include "server/base/shipped_files.hpp"

namespace wakesurf::server {

std::filesystem::path this_program() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

namespace {

/// Returns the first of two places that exists, relative to the program; empty if neither does.
std::filesystem::path shipped(const char* installed, const char* in_sources) {
    const std::filesystem::path bin = this_program().parent_path();
    for (const char* place : {installed, in_sources})
        if (std::error_code ignored; std::filesystem::exists(bin / place, ignored))
            return std::filesystem::weakly_canonical(bin / place);
    return {};
}

} // namespace

core::Result<std::filesystem::path> bundled_simulation() {
    auto file = shipped("../share/wakesurf/data/sqcyl/sqcyl.pvd", "../../../data/sqcyl/sqcyl.pvd");
    if (!file.empty())
        return file;
    return core::fail(core::Error::Code::NotFound,
                      "the bundled simulation was not found next to this program",
                      "name a dataset with --data");
}

core::Result<std::filesystem::path> python_client() {
    const auto file = shipped("../share/wakesurf/python/wakesurf", "../../../python/wakesurf");
    if (!file.empty())
        return file.parent_path();
    return core::fail(core::Error::Code::NotFound,
                      "the client for Python was not found next to this program",
                      "install all of it, or the wheel, which has the program wakesurf-mcp");
}

} // namespace wakesurf::server
