// The progress that a command reports on standard error: one line that is rewritten on a terminal, plain lines at growing intervals
// into a file.
#pragma once

#include "core/base/work_done.hpp"
#include "server/base/forecast.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <thread>

namespace wakesurf::server {

/// The text of the line, as a function of the elapsed seconds and of the work's own counts.
class ProgressText {
  public:
    struct Output {
        bool terminal = false;
        std::size_t columns = 80; ///< of the terminal
    };

    /// @param work  outlives this; null: only the time is reported
    /// @param end   simulation time at which a streak or time surface is complete
    ProgressText(std::string text,
                 const core::WorkDone* work,
                 std::optional<double> end,
                 Output output);

    /// Returns the text to write now, with the end of the line or the return to its begin; may be empty.
    /// @param seconds  since the work began; 0 in the first call
    std::string at(double seconds);

    /// Returns the text to write when the work has ended.
    std::string last() const;

  private:
    std::string details(double seconds) const;

    std::string text_;
    const core::WorkDone* work_;
    std::optional<double> end_;
    Output output_;
    Forecast forecast_;
    double next_ = 0.0; ///< time of the next plain line, in s
};

/// Shows progress on standard error until destroyed, which clears the terminal's line.
class ElapsedLine {
  public:
    /// Takes the parameters of ProgressText.
    explicit ElapsedLine(std::string text,
                         const core::WorkDone* work = nullptr,
                         std::optional<double> end = std::nullopt);
    ~ElapsedLine();
    ElapsedLine(const ElapsedLine&) = delete;
    ElapsedLine& operator=(const ElapsedLine&) = delete;

  private:
    std::jthread ticker_;
};

} // namespace wakesurf::server
