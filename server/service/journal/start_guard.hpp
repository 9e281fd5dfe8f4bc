// Notices a server that dies again and again while it starts, so that the next start can leave out what may
// be killing it.
#pragma once

#include <filesystem>

namespace wakesurf::server {

/// The number of starts that have not come to a good end is a file in the folder of `--state`. A folder that
/// cannot be written to counts nothing. Loop thread only.
class StartGuard {
  public:
    /// After so many deaths the next start is a careful one.
    static constexpr unsigned most = 3;

    /// Begins a start. @param folder  held by this process
    explicit StartGuard(const std::filesystem::path& folder);

    /// Returns how many starts before this one died, in a row.
    unsigned died() const { return died_; }

    bool careful() const { return died_ >= most; }

    /// Forgets them: the server has served for a while, or ends as it should. Waits for the disk.
    void good();

  private:
    std::filesystem::path file_;
    unsigned died_ = 0;
    bool good_ = false;
};

} // namespace wakesurf::server
