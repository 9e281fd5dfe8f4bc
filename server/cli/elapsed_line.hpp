// Progress of work that takes its time, on standard error: on a terminal a line that moves, otherwise plain lines now and then.
#pragma once

#include "core/base/work_done.hpp"

#include <optional>
#include <string>
#include <thread>

namespace wakesurf::server {

/// The terminal's line is wiped at the end.
class ElapsedLine {
  public:
    /// As those of ProgressText.
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
