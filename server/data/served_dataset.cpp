#include "server/data/served_dataset.hpp"

#include "server/base/log_text.hpp"
#include "store/store_layout.hpp"
#include "store/stored_families.hpp"
#include "store/stored_means.hpp"

#include <spdlog/spdlog.h>
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
    for (const auto name : {store::manifest_file_name, store::checksums_file_name,
                            store::families_list.file, store::means_list.file})
        always_.push_back(folder_ / name);
}

SourceWatch::Stamp SourceWatch::stamp(const fs::path& path) {
    ++files_checked_;

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
        take(file, always.size() < most_files_checked / 4);
    const std::size_t steps = files.steps.size();
    for (std::size_t i = 0; i < steps; ++i)
        for (const auto& file : files.steps[i])
            take(file, (i < first_steps || i + newest_steps >= steps) &&
                           always.size() < most_files_checked / 2);
    const auto missing = [this](const fs::path& path) {
        return !known_.contains(path) && stamp(path) == Stamp();
    };
    // The manifest names files relative to another folder.
    if ((always.empty() && others.empty()) || std::any_of(always.begin(), always.end(), missing))
        return;
    for (const auto& [folder, now] : folders) {
        known[folder] = now;
        (always.size() < most_files_checked * 3 / 4 ? always : others).push_back(folder);
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
    const std::size_t most = most_files_checked - std::min(most_files_checked, always_.size());
    for (std::size_t i = 0; i < std::min(most, others_.size()); ++i) {
        next_ = (next_ + 1) % others_.size();
        if (differs(others_[next_]))
            return true;
    }
    return false;
}

using core::Error;

namespace {

// Says whether a running import leaves the state alone: a ready dataset grows, and changes when it has grown.
// A failed one is imported again.
bool settled(DatasetState state) {
    return state == DatasetState::Ready || state == DatasetState::Stopped ||
           state == DatasetState::Incomplete;
}

Error incomplete(std::size_t ready, std::size_t total) {
    return {Error::Code::Io,
            "only " + std::to_string(ready) + " of " + std::to_string(total) +
                " time-steps are stored",
            "import it again into the same store: the import resumes where the last one ended"};
}

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

void ServedDataset::name_kept_fields() {
    status.families.clear();
    status.means.clear();
    for (const core::FieldInfo& each : open->info.fields)
        if (each.kept())
            (each.family ? status.families : status.means).push_back(each.name);
}

DatasetState ServedDataset::state() const {
    const std::scoped_lock lock(guard_);
    return status.state;
}

command::SourceOptions ServedDataset::taken_now() const {
    const std::scoped_lock lock(guard_);
    return taken;
}

// An open dataset stays open as long as it is the same series, of the same values. Its replacement may need
// its memory.
core::Result<LoadedDataset> ServedDataset::reopened(const std::filesystem::path& folder) {
    if (!open)
        return open_store(folder, options_);
    auto opened = open_again(*open, folder, options_);
    if (opened || opened.error().code != Error::Code::OverLimit || still_there(*open))
        return opened;
    {
        const std::scoped_lock lock(guard_);
        open.reset();
    }
    return open_store(folder, options_);
}

// Logs each error once, since a failed source is checked again and again; none when the server ends, or a
// client stopped the import.
void ServedDataset::keep_error(const core::Error& error) {
    const bool known = status.error && status.error->message == error.message;
    if (!known && error.code != Error::Code::Cancelled)
        spdlog::error("event=dataset_failed dataset={} message={} hint={}",
                      log_value(status.dataset), log_value(without_paths(error.message)),
                      log_value(without_paths(error.hint)));
    status.error = error;
}

void ServedDataset::log_library_words(std::string_view words) {
    if (std::exchange(library_words_, words) != words)
        spdlog::warn("event=library_words dataset={} message={}", log_value(status.dataset),
                     log_value(without_paths(words)));
}

// Time-steps before the one that could not be imported stay usable.
void ServedDataset::give_up(const std::filesystem::path& folder, const core::Error& error) {
    auto left = open ? reopened(folder) : tl::unexpected(error);
    if (!left)
        return finish(tl::unexpected(error));
    finish(std::move(left));
    const std::scoped_lock lock(guard_);
    keep_error(error);
    if (status.error->hint.empty())
        status.error->hint = "the other time-steps can be used; once the cause is fixed, the "
                             "import resumes by itself";
}

/// Data in use were recomputed: the open ones no longer exist, and their import begins at zero.
void ServedDataset::notice_replacement() {
    if (!open || std::exchange(compared, true) || still_there(*open))
        return;
    const std::scoped_lock lock(guard_);
    open.reset();
    if (status.state != DatasetState::Stopped)
        status.state = DatasetState::Importing;
    status.error.reset();
}

// Listeners use ready time-steps at once: they are counted once find() has them, and not before.
bool ServedDataset::show(const store::ImportProgress& progress,
                         const std::filesystem::path& folder) {
    if (!progress.velocities.empty()) {
        const std::scoped_lock lock(guard_);
        status.velocities = progress.velocities;
    }
    if (progress.done > 0)
        notice_replacement();
    if (settled(state()))
        return false;
    std::shared_ptr<const LoadedDataset> first;
    if (progress.done > 0 && !open)
        if (auto opened = open_store(folder, options_)) {
            opened->info.dataset = status.dataset;
            opened->info.name = status.name;
            first = std::make_shared<const LoadedDataset>(std::move(*opened));
        }
    const std::scoped_lock lock(guard_);
    if (first) {
        open = std::move(first);
        status.values = values_of(*open);
        name_kept_fields();
    }
    if (settled(status.state))
        return false;
    status.steps_ready = open ? progress.done : 0;
    status.steps_total = progress.total;
    status.progress = share(progress.done, progress.total);
    status.remaining = progress.remaining;
    return true;
}

void ServedDataset::finish(core::Result<LoadedDataset> opened, Ending how) {
    std::size_t ready = 0;
    if (opened) {
        opened->info.dataset = status.dataset;
        opened->info.name = status.name;
        ready = steps_ready(*opened);
    }
    const bool gone = !opened && open && !still_there(*open);
    const std::scoped_lock lock(guard_);
    if (gone) {
        open.reset();
        status.values.clear();
        status.families.clear();
        status.means.clear();
        status.steps_ready = 0;
    }
    if (!opened) {
        status.state = DatasetState::Failed;
        return keep_error(opened.error());
    }
    status.velocities.clear();
    if (how == Ending::Whole) {
        const std::size_t total = opened->info.times.size();
        status.state = ready < total ? DatasetState::Incomplete : DatasetState::Ready;
        status.error.reset();
        if (ready < total)
            status.error = incomplete(ready, total);
    }
    status.steps_ready = ready;
    status.steps_total = opened->info.times.size();
    status.progress = how == Ending::Whole ? 1.0 : share(ready, status.steps_total);
    status.values = values_of(*opened);
    open = std::make_shared<const LoadedDataset>(std::move(*opened));
    name_kept_fields();
}

void ServedDataset::refresh_kept_fields() {
    for (;;) {
        const auto before = [&] {
            const std::scoped_lock lock(guard_);
            return open;
        }();
        if (!before)
            return;
        auto now = std::make_shared<const LoadedDataset>(with_kept_fields(*before, options_.cache));
        const std::scoped_lock lock(guard_);
        if (open != before) // opened again meanwhile, perhaps without the newest of them
            continue;
        open = std::move(now);
        name_kept_fields();
        return;
    }
}

// Opens the result of a stopped or earlier import; it may be wanted again meanwhile.
void ServedDataset::show_what_is_there(const std::filesystem::path& folder) {
    auto opened = reopened(folder);
    if (!opened || (!open && steps_ready(*opened) == 0))
        return;
    finish(std::move(opened), Ending::Stopped);
}

} // namespace wakesurf::server
