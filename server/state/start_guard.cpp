#include "server/state/start_guard.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <utility>

namespace wakesurf::server {

namespace {

constexpr int most_counted = 1000; ///< a file that says more is damaged

} // namespace

StartGuard::StartGuard(const std::filesystem::path& folder) : file_(folder / "starts") {
    int before = 0;
    if (std::ifstream in(file_); in >> before && before > 0 && before < most_counted)
        died_ = static_cast<unsigned>(before);
    const int file = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0)
        return;
    const std::string text = std::to_string(died_ + 1) + "\n";
    if (::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()))
        ::fsync(file);
    ::close(file);
}

void StartGuard::good() {
    if (std::exchange(good_, true))
        return;
    std::error_code gone;
    std::filesystem::remove(file_, gone);
}

} // namespace wakesurf::server
