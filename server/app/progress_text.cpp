#include "server/app/progress_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace wakesurf::server {

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
