// Whether what a dataset was made from has changed on disk since: how a simulation that is still running, or
// was run again, is noticed. Files and folders that the dataset has nothing to do with are not looked at,
// however many there are beside it.
#pragma once

#include "store/store_manifest.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace wakesurf::server {

class SourceWatch {
  public:
    /// @param source  a file, a folder or a pattern; or a store's folder, of which its manifest and
    /// checksums are looked at
    SourceWatch(std::filesystem::path source, bool is_store);

    /// An import begins, or a store is about to be opened: what changes from here on is a change.
    void begin();

    /// It has ended: these are its files. Without any, everything in the source's folder and the folders in
    /// it counts.
    void made_from(const store::StoreSource& files);

    /// Something has changed since begin(). Looks at what all time-steps share, at the first and the newest
    /// ones, and at a part of the others, in turns: at no more than `most_looked_at` files.
    bool changed();

    static constexpr std::size_t most_looked_at = 1024;

    /// Files and folders looked at so far.
    std::uint64_t looked_at() const { return looked_at_; }

  private:
    struct Stamp {
        std::uint64_t size = 0;
        std::int64_t modified = 0; ///< nanoseconds since 1970; 0: not there

        bool operator==(const Stamp&) const = default;
    };

    Stamp stamp(const std::filesystem::path& path);
    std::uint64_t listing();
    bool differs(const std::filesystem::path& path);
    void find_indices();
    void take_folders(const std::filesystem::path& file,
                      std::map<std::filesystem::path, Stamp>& into);

    std::filesystem::path source_;
    std::filesystem::path folder_;
    bool is_store_;
    std::map<std::filesystem::path, Stamp> known_; ///< as they were at begin(), or in between
    std::vector<std::filesystem::path>
        indices_; ///< files that list others, which a reader does not name
    std::vector<std::filesystem::path> always_; ///< of these, what is looked at every time
    std::vector<std::filesystem::path> others_; ///< the rest
    std::size_t next_ = 0;                      ///< of others_
    std::optional<std::uint64_t> listing_;      ///< where the files are not known
    bool unsure_ = false; ///< a folder was not known at begin(): it may have changed before it was
    std::uint64_t looked_at_ = 0;
};

} // namespace wakesurf::server
