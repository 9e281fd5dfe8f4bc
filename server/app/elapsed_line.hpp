// Progress of long work, on standard error: on a terminal a line that is rewritten, otherwise plain lines at
// growing intervals.
#pragma once

#include "core/base/work_done.hpp"

#include <optional>
#include <string>
#include <thread>

namespace wakesurf::server {

/// Shows progress until destroyed, which clears the terminal's line.
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
