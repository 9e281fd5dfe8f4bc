// Progress of work whose length is unknown: a line with the seconds gone on a terminal, one plain line otherwise.
#pragma once

#include <string>
#include <thread>

namespace wakesurf::server {

/// Writes to standard error; the terminal's line is wiped at the end.
class ElapsedLine {
  public:
    explicit ElapsedLine(std::string text);
    ~ElapsedLine();
    ElapsedLine(const ElapsedLine&) = delete;
    ElapsedLine& operator=(const ElapsedLine&) = delete;

  private:
    std::string text_;
    std::jthread ticker_;
};

} // namespace wakesurf::server
