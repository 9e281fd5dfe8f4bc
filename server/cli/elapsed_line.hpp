// Progress of work that takes its time: a line with the seconds gone, and the part done and how long the rest may take if it is counted,
// on a terminal; one plain line otherwise.
#pragma once

#include "core/base/work_done.hpp"

#include <string>
#include <thread>

namespace wakesurf::server {

/// Writes to standard error; the terminal's line is wiped at the end.
class ElapsedLine {
  public:
    /// @param work  outlives it; null: nothing to count
    explicit ElapsedLine(std::string text, const core::WorkDone* work = nullptr);
    ~ElapsedLine();
    ElapsedLine(const ElapsedLine&) = delete;
    ElapsedLine& operator=(const ElapsedLine&) = delete;

  private:
    std::string text_;
    const core::WorkDone* work_;
    std::jthread ticker_;
};

} // namespace wakesurf::server
