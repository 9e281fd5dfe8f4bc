#include "server/sessions/journal/crash_loop_guard.hpp"

#include "server/base/private_file.hpp"

#include <sstream>
#include <string>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr int most_counted = 1000; ///< a file that says more is damaged

} // namespace

CrashLoopGuard::CrashLoopGuard(const std::filesystem::path& folder) : file_(folder / "starts") {
    constexpr std::size_t longest = 64;
    int before = 0;
    if (std::istringstream in(read_private_file(file_, longest).value_or(std::string()));
        in >> before && before > 0 && before < most_counted)
        died_ = static_cast<unsigned>(before);
    const auto counted = write_private_file(file_, std::to_string(died_ + 1) + "\n");
    static_cast<void>(counted); // where nothing can be written, nothing is counted
}

void CrashLoopGuard::good() {
    if (std::exchange(good_, true))
        return;
    std::error_code gone;
    std::filesystem::remove(file_, gone);
}

} // namespace wakesurf::server
