// Detects changes on disk of a dataset's source: a simulation that is still running, or was run again.
// Unrelated files and folders beside it are not read, however many there are.
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
    /// @param source  a file, a folder or a pattern; or a store's folder, whose manifest and checksums are
    /// checked
    SourceWatch(std::filesystem::path source, bool is_store);

    /// Marks the beginning of an import, or of opening a store: later changes count.
    void begin();

    /// Sets the files of a finished import. Without any, everything in the source's folder and its folders
    /// counts.
    void made_from(const store::StoreSource& files);

    /// Says whether anything has changed since begin(). Checks what all time-steps share, the first and the
    /// newest ones, and a part of the others, in rotation: at most `most_looked_at` files.
    bool changed();

    static constexpr std::size_t most_looked_at = 1024;

    /// Returns the number of files and folders checked so far.
    std::uint64_t looked_at() const { return looked_at_; }

  private:
    struct Stamp {
        std::uint64_t size = 0;
        std::int64_t modified = 0; ///< nanoseconds since 1970; 0: missing

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
    std::map<std::filesystem::path, Stamp> known_; ///< as they were at begin(), or later
    /// Files that list others, which a reader does not name.
    std::vector<std::filesystem::path> indices_;
    /// The files that are checked every time.
    std::vector<std::filesystem::path> always_;
    std::vector<std::filesystem::path> others_; ///< the rest
    std::size_t next_ = 0;                      ///< of others_
    /// The sum of a listing, if the files are not known.
    std::optional<std::uint64_t> listing_;
    bool unsure_ = false; ///< a folder was unknown at begin(): it may have changed before
    std::uint64_t looked_at_ = 0;
};

} // namespace wakesurf::server
