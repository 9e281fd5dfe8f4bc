// Numbers as Fortran writes them: 1.0D+00, and 0.123-101 where the exponent has three digits.
#pragma once

#include <string>
#include <string_view>

namespace wakesurf::importer {

/// With an E before the exponent, as everyone else reads it; other words stay as they are.
std::string usual_number(std::string_view word);

/// The file of such numbers as one of usual ones, in memory: its path as long as this lives. The file's own path where no number differs,
/// or there is no memory to be had.
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
