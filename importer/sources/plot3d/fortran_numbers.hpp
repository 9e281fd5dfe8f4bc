// Numbers as Fortran writes them: 1.0D+00, and 0.123-101 where the exponent has three digits.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::importer {

/// Inserts the E before the exponent that other readers expect; other words stay as they are.
std::string usual_number(std::string_view word);

/// Rewrites a file of such numbers as one of usual ones, in memory: its path is valid as long as this lives.
/// It is the file's own path if no number differs, or if there is no memory.
class UsualNumbers {
  public:
    explicit UsualNumbers(std::string path);
    ~UsualNumbers();

    UsualNumbers(const UsualNumbers&) = delete;
    UsualNumbers& operator=(const UsualNumbers&) = delete;

    const std::string& path() const { return path_; }

  private:
    std::string path_;
    int memory_ = -1;
};

} // namespace wakesurf::importer
