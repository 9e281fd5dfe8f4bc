// What a command says of work while it lasts: one line that moves on a terminal, plain lines now and then into a file. A function of the
// seconds gone and of what the work tells.
#pragma once

#include "core/base/work_done.hpp"
#include "server/service/base/forecast.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace wakesurf::server {

class ProgressText {
  public:
    struct Output {
        bool terminal = false;
        std::size_t columns = 80; ///< of the terminal
    };

    /// @param work  outlives it; null: there is nothing but the time to tell
    /// @param end   simulation time at which a streak or time surface will be whole
    ProgressText(std::string text,
                 const core::WorkDone* work,
                 std::optional<double> end,
                 Output output);

    /// What to write now, with the end of the line or the return to its begin; empty: nothing.
    /// @param seconds  since the work began; 0 in the first call
    std::string at(double seconds);

    /// What to write when the work has ended.
    std::string last() const;

  private:
    std::string details(double seconds) const;

    std::string text_;
    const core::WorkDone* work_;
    std::optional<double> end_;
    Output output_;
    Forecast forecast_;
    double next_ = 0.0; ///< second of the next plain line
};

} // namespace wakesurf::server
