#include "server/cli/elapsed_line.hpp"

#include "server/cli/forecast.hpp"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>

namespace wakesurf::server {

ElapsedLine::ElapsedLine(std::string text, const core::WorkDone* work)
    : text_(std::move(text)), work_(work) {
    if (::isatty(STDERR_FILENO) == 0) {
        std::fprintf(stderr, "%s\n", text_.c_str());
        return;
    }
    ticker_ = std::jthread([this](const std::stop_token& done) {
        const auto start = std::chrono::steady_clock::now();
        std::mutex mutex;
        std::condition_variable_any ended;
        std::unique_lock lock(mutex);
        Forecast forecast;
        while (!done.stop_requested()) {
            const std::chrono::duration<double> gone = std::chrono::steady_clock::now() - start;
            if (work_ != nullptr) {
                const double fraction = work_->fraction();
                forecast.add(gone.count(), fraction);
                const auto left = forecast.left();
                std::fprintf(stderr, "\r%s ... %.0f %%, %.1f s%s\033[K", text_.c_str(),
                             std::floor(100.0 * fraction), gone.count(),
                             left ? (", " + words_for_left(*left)).c_str() : "");
            } else {
                std::fprintf(stderr, "\r%s ... %.1f s", text_.c_str(), gone.count());
            }
            ended.wait_for(lock, done, std::chrono::milliseconds(200), [] { return false; });
        }
        std::fprintf(stderr, "\r\033[K");
    });
}

ElapsedLine::~ElapsedLine() = default;

} // namespace wakesurf::server
