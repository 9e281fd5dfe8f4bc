#include "server/app/elapsed_line.hpp"

#include "server/app/progress_text.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <utility>

namespace wakesurf::server {

namespace {

ProgressText::Output standard_error() {
    ProgressText::Output output{::isatty(STDERR_FILENO) != 0};
    winsize size{};
    if (output.terminal && ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        output.columns = size.ws_col;
    return output;
}

} // namespace

ElapsedLine::ElapsedLine(std::string text, const core::WorkDone* work, std::optional<double> end) {
    ProgressText progress(std::move(text), work, end, standard_error());
    std::fputs(progress.at(0.0).c_str(), stderr);
    ticker_ = std::jthread([progress = std::move(progress)](const std::stop_token& done) mutable {
        const auto start = std::chrono::steady_clock::now();
        std::mutex mutex;
        std::condition_variable_any ended;
        std::unique_lock lock(mutex);
        while (!done.stop_requested()) {
            const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
            std::fputs(progress.at(gone.count()).c_str(), stderr);
            ended.wait_for(lock, done, std::chrono::milliseconds(200), [] { return false; });
        }
        std::fputs(progress.last().c_str(), stderr);
    });
}

ElapsedLine::~ElapsedLine() = default;

} // namespace wakesurf::server
