#include "server/data/served_dataset.hpp"

#include "server/base/log_text.hpp"

#include <spdlog/spdlog.h>

#include <utility>

namespace wakesurf::server {

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

std::vector<std::string> family_names(const LoadedDataset& open) {
    std::vector<std::string> names;
    if (open.scalars)
        for (const core::FamilyRecord& each : open.scalars->families())
            names.push_back(each.name);
    return names;
}

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

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
    const bool told = status.error && status.error->message == error.message;
    if (!told && error.code != Error::Code::Cancelled)
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
        status.families = family_names(*open);
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
    status.families = family_names(*opened);
    open = std::make_shared<const LoadedDataset>(std::move(*opened));
}

void ServedDataset::look_for_families() {
    for (;;) {
        const auto before = [&] {
            const std::scoped_lock lock(guard_);
            return open;
        }();
        if (!before)
            return;
        auto now = std::make_shared<const LoadedDataset>(with_families(*before, options_.cache));
        const std::scoped_lock lock(guard_);
        if (open != before) // opened again meanwhile, perhaps without the newest of them
            continue;
        open = std::move(now);
        status.families = family_names(*open);
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
