#include "server/data/source_watch.hpp"

#include "store/store_layout.hpp"
#include "store/stored_families.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace wakesurf::server {

namespace fs = std::filesystem;

namespace {

/// The time-steps that are checked every time: a solver that runs again begins with the first, one that
/// continues writes the last.
constexpr std::size_t first_steps = 4, newest_steps = 16;

constexpr std::uint64_t with(std::uint64_t so_far, std::uint64_t number) {
    for (int shift = 0; shift < 64; shift += 8)
        so_far = (so_far ^ (number >> shift & 0xffu)) * 0x100000001b3u; // FNV-1a
    return so_far;
}

} // namespace

SourceWatch::SourceWatch(fs::path source, bool is_store)
    : source_(std::move(source)), is_store_(is_store) {
    std::error_code error;
    folder_ = is_store_ || fs::is_directory(source_, error) ? source_ : source_.parent_path();
    if (!is_store_)
        return;
    for (const auto name :
         {store::manifest_file_name, store::checksums_file_name, store::families_file_name})
        always_.push_back(folder_ / name);
}

SourceWatch::Stamp SourceWatch::stamp(const fs::path& path) {
    ++looked_at_;

    struct stat found {};

    if (::stat(path.c_str(), &found) != 0)
        return {};
    const std::int64_t modified =
        std::int64_t{found.st_mtim.tv_sec} * 1'000'000'000 + std::int64_t{found.st_mtim.tv_nsec};
    // The size of a folder means nothing.
    return {S_ISDIR(found.st_mode) ? 0 : static_cast<std::uint64_t>(found.st_size),
            std::max<std::int64_t>(1, modified)};
}

/// Returns a sum over everything in the folder and its folders, in any order.
std::uint64_t SourceWatch::listing() {
    std::uint64_t sum = 0;
    const auto add = [&](const fs::path& path) {
        const Stamp found = stamp(path);
        std::uint64_t print = with(0xcbf29ce484222325u, found.size);
        print = with(print, static_cast<std::uint64_t>(found.modified));
        for (const char c : path.string())
            print = with(print, static_cast<unsigned char>(c));
        sum += print;
    };
    std::error_code error;
    for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        add(it->path());
        std::error_code deeper;
        if (!it->is_directory(deeper))
            continue;
        for (fs::directory_iterator in(it->path(), deeper), last; !deeper && in != last;
             in.increment(deeper))
            add(in->path());
    }
    return sum;
}

/// Finds files that list others: writing them in place changes no folder.
void SourceWatch::find_indices() {
    constexpr std::array<std::string_view, 6> endings{".pvd",   ".series", ".case",
                                                      ".encas", ".foam",   ".vtm"};
    constexpr std::size_t most = 64;
    indices_.clear();
    std::error_code error;
    if (fs::is_regular_file(source_, error))
        indices_.push_back(source_);
    for (fs::directory_iterator it(folder_, error), end;
         !error && it != end && indices_.size() < most; it.increment(error))
        if (std::find(endings.begin(), endings.end(), it->path().extension().string()) !=
            endings.end())
            indices_.push_back(it->path());
    for (const auto& path : indices_)
        known_[path] = stamp(path);
}

void SourceWatch::begin() {
    unsure_ = false;
    if (!is_store_)
        find_indices();
    if (always_.empty())
        listing_ = listing();
    known_[folder_] = stamp(folder_);
    for (const auto* paths : {&always_, &others_})
        for (const auto& path : *paths)
            known_[path] = stamp(path);
}

/// Adds the folders from the source's down to the file: what appears there is a time-step, or a part of one.
void SourceWatch::take_folders(const fs::path& file, std::map<fs::path, Stamp>& into) {
    const auto below = file.lexically_relative(folder_);
    if (below.empty() || *below.begin() == "..")
        return; // outside of the source
    for (auto folder = file.parent_path(); !into.contains(folder); folder = folder.parent_path()) {
        const auto known = known_.find(folder);
        unsure_ = unsure_ || known == known_.end();
        into[folder] = known == known_.end() ? stamp(folder) : known->second;
        if (folder == folder_)
            return;
    }
}

void SourceWatch::made_from(const store::StoreSource& files) {
    std::map<fs::path, Stamp> folders;
    std::map<fs::path, Stamp> known;
    std::set<fs::path> seen;
    std::vector<fs::path> always;
    std::vector<fs::path> others;
    for (const auto& path : indices_) {
        seen.insert(path);
        known[path] = known_[path];
        always.push_back(path);
    }
    folders[folder_] = known_[folder_];
    const auto take = [&](const store::SourceFile& file, bool every_time) {
        const auto path = (folder_ / file.name).lexically_normal();
        if (!seen.insert(path).second)
            return;
        const auto before = known_.find(path);
        known[path] = before == known_.end() ? Stamp{file.size, file.mtime} : before->second;
        (every_time ? always : others).push_back(path);
        take_folders(path, folders);
    };
    for (const auto& file : files.files)
        take(file, always.size() < most_looked_at / 4);
    const std::size_t steps = files.steps.size();
    for (std::size_t i = 0; i < steps; ++i)
        for (const auto& file : files.steps[i])
            take(file, (i < first_steps || i + newest_steps >= steps) &&
                           always.size() < most_looked_at / 2);
    const auto missing = [this](const fs::path& path) {
        return !known_.contains(path) && stamp(path) == Stamp();
    };
    // The manifest names files relative to another folder.
    if ((always.empty() && others.empty()) || std::any_of(always.begin(), always.end(), missing))
        return;
    for (const auto& [folder, now] : folders) {
        known[folder] = now;
        (always.size() < most_looked_at * 3 / 4 ? always : others).push_back(folder);
    }
    known_ = std::move(known);
    always_ = std::move(always);
    others_ = std::move(others);
    listing_.reset();
    next_ = 0;
}

bool SourceWatch::differs(const fs::path& path) {
    return stamp(path) != known_[path];
}

bool SourceWatch::changed() {
    if (always_.empty())
        return !listing_ || listing() != *listing_;
    if (std::exchange(unsure_, false))
        return true;
    const auto other = [this](const auto& path) { return differs(path); };
    if (std::any_of(always_.begin(), always_.end(), other))
        return true;
    const std::size_t most = most_looked_at - std::min(most_looked_at, always_.size());
    for (std::size_t i = 0; i < std::min(most, others_.size()); ++i) {
        next_ = (next_ + 1) % others_.size();
        if (differs(others_[next_]))
            return true;
    }
    return false;
}

} // namespace wakesurf::server
