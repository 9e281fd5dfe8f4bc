#include "server/app/progress_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
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

namespace {

/// The time before the first line, and the longest interval of plain lines (s); each interval doubles.
constexpr double long_work = 3.0, longest_silence = 60.0;

} // namespace

ProgressText::ProgressText(std::string text,
                           const core::WorkDone* work,
                           std::optional<double> end,
                           Output output)
    : text_(std::move(text)), work_(work), end_(end), output_(output) {}

std::string ProgressText::at(double seconds) {
    if (work_ != nullptr)
        forecast_.add(seconds, work_->fraction());
    if (output_.terminal) {
        const std::string more = details(seconds);
        const std::string all = text_ + " ... " + more;
        return "\r" + (all.size() < output_.columns ? all : more) + "\033[K";
    }
    if (seconds < next_)
        return {};
    const bool first = next_ == 0.0;
    next_ = first ? long_work : seconds + std::clamp(seconds, long_work, longest_silence);
    return text_ + (first ? "" : ": " + details(seconds)) + "\n";
}

std::string ProgressText::last() const {
    return output_.terminal ? "\r\033[K" : "";
}

std::string ProgressText::details(double seconds) const {
    if (work_ == nullptr)
        return fmt::format("{:.1f} s", seconds);
    std::string out = fmt::format("{} %", static_cast<int>(std::floor(100.0 * work_->fraction())));
    if (seconds >= long_work) {
        if (const auto time = work_->time())
            out +=
                fmt::format(", t = {:.4g}", *time) + (end_ ? fmt::format(" of {:.4g}", *end_) : "");
        if (work_->quads() > 0)
            out += fmt::format(", {} quads", work_->quads());
    }
    out += fmt::format(", {:.1f} s", seconds);
    if (const auto left = forecast_.left())
        out += ", " + words_for_left(*left);
    return out;
}

} // namespace wakesurf::server
