#include "server/data/dataset_catalogue.hpp"

#include "server/base/private_file.hpp"
#include "server/data/import_process.hpp"
#include "server/remote/remote_dataset.hpp"
#include "store/store_manifest.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <exception>
#include <new>
#include <stop_token>
#include <string>

namespace wakesurf::server {

using core::Error;

namespace {

constexpr std::size_t longest_choice = 4096; // bytes

// The least memory an importer is given, in bytes: with less, none could begin.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t smallest_import = std::size_t{1} << 30;
#else
constexpr std::size_t smallest_import = std::size_t{64} << 20;
#endif

// All imports together take one part in so many of the memory.
constexpr std::size_t import_part = 4;

/// Takes what an import under way needs from the account, as it is another process of the same machine, and
/// waits until others have given it back. @param nth  the share is one `nth` of what there is for imports
core::Result<core::MemoryAccount::Share>
import_memory(const OpenOptions& options, std::size_t nth, const std::stop_token& stop) {
    constexpr std::chrono::seconds patience{30};
    if (!options.cache.account)
        return core::MemoryAccount::Share();
    auto share = options.cache.account->open(core::MemoryUse::Importers);
    const std::size_t bytes = options.cache.account->budget() / import_part / nth;
    if (share.grow_to(bytes, stop, patience) || stop.stop_requested())
        return share;
    return tl::unexpected(options.cache.account->refusal("importing", bytes));
}

/// What is said where opening or importing throws, as where memory runs out.
Error thrown(const std::exception& problem) {
    if (dynamic_cast<const std::bad_alloc*>(&problem) != nullptr)
        return {Error::Code::OverLimit, "there is not enough memory to open the dataset",
                "start with fewer datasets, or on a machine with more memory"};
    return {Error::Code::Io, std::string("the dataset could not be opened: ") + problem.what(), ""};
}

} // namespace

core::Result<std::unique_ptr<DatasetCatalogue>> DatasetCatalogue::open(
    const std::vector<std::string>& arguments, OpenOptions options, Listener listener) {
    const auto stored = std::count_if(arguments.begin(), arguments.end(),
                                      [](const std::string& a) { return !a.starts_with("flow:"); });
    if (!options.cache.account)
        options.cache.budget_bytes /= static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, stored));
    std::unique_ptr<DatasetCatalogue> catalogue(
        new DatasetCatalogue(std::move(options), std::move(listener)));
    for (const auto& argument : arguments)
        if (auto added = catalogue->add(argument); !added)
            return tl::unexpected(added.error());
    const std::size_t lanes = catalogue->wanted_lanes();
    catalogue->lanes_.emplace(lanes);
    for (const auto kind : {Work::Import, Work::OfDisk, Work::OfWeb})
        for (std::size_t i = 0; i < lanes; ++i)
            catalogue->importers_.emplace_back(
                [self = catalogue.get(), kind](const std::stop_token& stop) {
                    self->work(kind, stop);
                });
    return catalogue;
}

DatasetCatalogue::~DatasetCatalogue() {
    closing_.request_stop();
    for (auto& each : importers_) // all are stopped before the first is joined
        each.request_stop();
}

/// Returns the number wanted, but not more than have the least memory of an import each.
std::size_t DatasetCatalogue::wanted_lanes() const {
    const auto sources = std::count_if(entries_.begin(), entries_.end(), [](const auto& entry) {
        return entry->argument.kind != DatasetArgument::Kind::Flow;
    });
    const std::size_t fit = options_.cache.account
                                ? options_.cache.account->budget() / import_part / smallest_import
                                : options_.lanes;
    return std::clamp<std::size_t>(
        fit, 1,
        std::clamp<std::size_t>(static_cast<std::size_t>(sources), 1,
                                std::max<std::size_t>(1, options_.lanes)));
}

core::Result<void> DatasetCatalogue::add(const std::string& text) {
    auto argument = resolve_dataset(text);
    if (!argument)
        return tl::unexpected(argument.error());
    if (auto fit = check_source_options(*argument, options_.taken); !fit)
        return fit;
    StoreOptions store = options_.of_store();
    store.closing = closing_.get_token();
    auto entry = std::make_unique<Entry>(mutex_, std::move(store));
    entry->argument = std::move(*argument);
    entry->taken = options_.taken;
    if (entry->argument.kind == DatasetArgument::Kind::Source && entry->taken.velocity.empty())
        if (const auto chosen = read_private_file(choice_file(*entry), longest_choice);
            chosen && chosen->find('\n') == std::string::npos)
            entry->taken.velocity = *chosen;
    entry->status.name = entry->argument.name;
    if (entry->argument.kind == DatasetArgument::Kind::Flow) {
        auto flow = open_flow(entry->argument);
        if (!flow)
            return tl::unexpected(flow.error());
        entry->status.name = flow->info.name;
        entry->status.dataset = unused_id(entry->status.name);
        entry->finish(std::move(flow));
    } else {
        entry->status.dataset = unused_id(entry->status.name);
    }
    entries_.push_back(std::move(entry));
    return {};
}

/// Returns the file that records the velocity chosen for a source with several: beside the store that it has
/// without the choice.
std::filesystem::path DatasetCatalogue::choice_file(const Entry& entry) const {
    return store_folder(options_.store_root, entry.argument, options_.taken).string() + ".velocity";
}

std::string DatasetCatalogue::unused_id(const std::string& name) const {
    const std::string wanted = slug(name);
    std::string id = wanted;
    for (int number = 2; find_entry(id) != nullptr; ++number)
        id = wanted + "-" + std::to_string(number);
    return id;
}

DatasetCatalogue::Entry* DatasetCatalogue::find_entry(std::string_view dataset) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
        return entry->status.dataset == dataset;
    });
    return found == entries_.end() ? nullptr : found->get();
}

std::filesystem::path DatasetCatalogue::store_folder_of(const Entry& entry) const {
    return store_folder(options_.store_root, entry.argument, entry.taken_now());
}

DatasetCatalogue::Work DatasetCatalogue::work_of(const DatasetArgument& argument) {
    if (argument.kind == DatasetArgument::Kind::Source)
        return Work::Import;
    return is_on_the_web(argument.path) ? Work::OfWeb : Work::OfDisk;
}

void DatasetCatalogue::work(Work kind, const std::stop_token& stop) {
    while (Entry* const entry = take_next(kind, stop))
        attend(*entry, stop);
}

/// Waits for a dataset that no other thread handles: not checked yet, to be imported again, or with its pause
/// over. Null at the end.
DatasetCatalogue::Entry* DatasetCatalogue::take_next(Work kind, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        const auto now = Clock::now();
        auto next = Clock::time_point::max();
        Entry* rested = nullptr;
        for (const auto& entry : entries_) {
            if (entry->busy || entry->argument.kind == DatasetArgument::Kind::Flow ||
                work_of(entry->argument) != kind)
                continue;
            const DatasetState state = entry->status.state;
            if (!entry->begun || state == DatasetState::Importing) {
                entry->busy = true;
                return entry.get();
            }
            if (state == DatasetState::Stopped)
                continue;
            if (entry->rests_until <= now && rested == nullptr)
                rested = entry.get();
            next = std::min(next, entry->rests_until);
        }
        if (rested != nullptr) {
            rested->busy = true;
            return rested;
        }
        const std::uint64_t seen = wakeups_;
        const auto woken = [&] { return wakeups_ != seen; };
        if (next == Clock::time_point::max())
            again_.wait(lock, stop, woken);
        else
            again_.wait_until(lock, stop, next, woken);
    }
    return nullptr;
}

// If a check found nothing new, checking and importing take a twentieth of the time at most, else half of it.
void DatasetCatalogue::attend(Entry& entry, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const auto started = Clock::now();
    const bool first = !std::exchange(entry.begun, true);
    const DatasetState state = entry.state();
    const std::string before = entry.status.values;
    bool checked_only = false;
    if (!entry.watch)
        entry.watch.emplace(entry.argument.path,
                            entry.argument.kind == DatasetArgument::Kind::Store);
    try {
        if (state == DatasetState::Stopped)
            entry.show_what_is_there(store_folder_of(entry));
        else if (first || state == DatasetState::Importing || due(entry))
            import_one(entry, stop);
        else
            checked_only = true;
        if (!checked_only)
            entry.refresh_kept_fields();      // one may have been made since reading began
    } catch (const std::exception& problem) { // the other datasets go on
        entry.failed = true;
        ++entry.failures;
        entry.finish(tl::unexpected(thrown(problem)));
    }
    const auto ended = Clock::now();
    const auto took = ended - started;
    const bool changed = entry.status.values != before;
    const Clock::duration rest = first ? Clock::duration(0) : changed ? took : 20 * took;
    {
        const std::scoped_lock lock(mutex_);
        entry.busy = false;
        entry.rests_until = ended + std::max<Clock::duration>(options_.watch_period, rest);
        ++wakeups_;
    }
    again_.notify_all();
    if (!checked_only)
        listener_(entry.status.dataset);
}

// Returns true if the source changed since the last import began, or if that failed, perhaps at a file that
// was being written: then at growing intervals.
bool DatasetCatalogue::due(Entry& entry) const {
    if (entry.watch->changed()) {
        entry.failures = 0;
        return true;
    }
    if (!entry.failed)
        return false;
    constexpr unsigned rarest = 16;
    return ++entry.polls % std::min(1u << std::min(entry.failures, 8u), rarest) == 0;
}

void DatasetCatalogue::import_one(Entry& entry, const std::stop_token& stop) {
    entry.watch->begin(); // before reading: later changes are noticed
    if (entry.argument.kind == DatasetArgument::Kind::Store)
        return check_store(entry);
    const auto folder = store_folder_of(entry);
    entry.compared = false;
    const auto imported = run_import(entry, folder, stop);
    if (const auto manifest = store::read_store_manifest(folder, core::PosixDisk()))
        entry.watch->made_from(manifest->source);
    if (!imported && imported.error().code == Error::Code::Cancelled && !stop.stop_requested())
        return entry.show_what_is_there(folder);
    entry.failed = !imported;
    if (!imported) {
        ++entry.failures;
        return entry.give_up(folder, imported.error());
    }
    auto opened = entry.reopened(folder);
    if (const auto taken = entry.taken_now(); opened && taken.velocity != options_.taken.velocity)
        (void)write_private_file(choice_file(entry), taken.velocity); // else it holds until the end
    entry.failed = !opened;
    entry.failures = opened ? 0 : entry.failures + 1;
    entry.finish(std::move(opened));
}

// A store that cannot be read just now may be being written: the open one stays.
void DatasetCatalogue::check_store(Entry& entry) {
    auto opened = entry.reopened(entry.argument.path);
    entry.failed = !opened;
    entry.failures += opened ? 0 : 1;
    const auto manifest = store::read_store_manifest(entry.argument.path, core::PosixDisk());
    if (opened || manifest || !entry.open)
        return entry.finish(std::move(opened));
    const std::scoped_lock lock(mutex_);
    entry.status.error = opened.error();
}

core::Result<void> DatasetCatalogue::run_import(Entry& entry,
                                                const std::filesystem::path& folder,
                                                const std::stop_token& stop) {
    std::stop_source source;
    {
        const std::scoped_lock lock(mutex_);
        if (entry.status.state == DatasetState::Stopped)
            source.request_stop();
        entry.running = source;
    }
    const std::stop_callback all_end(stop, [source]() mutable { source.request_stop(); });
    const std::stop_token token = source.get_token();
    auto imported = [&] {
        const auto lane = lanes_->one(token);
        return import_within(entry, folder, lanes_->lanes(), token);
    }();
    if (imported || imported.error().code != Error::Code::OverLimit || lanes_->lanes() == 1)
        return imported;
    const auto all = lanes_->all(token);
    return import_within(entry, folder, 1, token);
}

/// @param lanes  imports that share the memory
core::Result<void> DatasetCatalogue::import_within(Entry& entry,
                                                   const std::filesystem::path& folder,
                                                   std::size_t lanes,
                                                   const std::stop_token& stop) {
    if (stop.stop_requested())
        return core::fail(Error::Code::Cancelled, "the import was stopped before it began");
    const auto memory = import_memory(options_, lanes, stop);
    if (!memory)
        return tl::unexpected(memory.error());
    {
        const std::scoped_lock lock(mutex_);
        entry.status.velocities.clear();
    }
    const auto listener = [&](const store::ImportProgress& progress) {
        if (entry.show(progress, folder))
            listener_(entry.status.dataset);
    };
    const std::size_t most =
        memory->bytes() > 0 ? std::max(memory->bytes(), smallest_import) : 0; // 0: its own bound
    ImportCommand command{entry.argument.path, folder, {}, {}, options_.importer, {}, 0, most};
    command.taken = entry.taken_now();
    command.growing = true;
    command.secrets = options_.secrets;
    command.library_words = [&entry](std::string_view words) { entry.log_library_words(words); };
    return run_import_process(command, listener, stop);
}

bool DatasetCatalogue::stop_import(std::string_view dataset) {
    std::stop_source running;
    {
        const std::scoped_lock lock(mutex_);
        Entry* const entry = find_entry(dataset);
        if (entry == nullptr || entry->argument.kind != DatasetArgument::Kind::Source ||
            entry->status.state != DatasetState::Importing)
            return false;
        entry->status.state = DatasetState::Stopped;
        entry->status.remaining.reset();
        running = entry->running;
    }
    running.request_stop();
    listener_(std::string(dataset));
    return true;
}

bool DatasetCatalogue::start_import(std::string_view dataset) {
    {
        const std::scoped_lock lock(mutex_);
        Entry* const entry = find_entry(dataset);
        if (entry == nullptr || entry->status.state != DatasetState::Stopped)
            return false;
        entry->status.state = DatasetState::Importing;
        ++wakeups_;
    }
    again_.notify_all();
    listener_(std::string(dataset));
    return true;
}

void DatasetCatalogue::refresh_kept_fields(std::string_view dataset) {
    if (Entry* const entry = find_entry(dataset)) {
        entry->refresh_kept_fields();
        listener_(entry->status.dataset);
    }
}

core::Result<void> DatasetCatalogue::choose_velocity(std::string_view dataset,
                                                     const std::string& velocity) {
    {
        const std::scoped_lock lock(mutex_);
        Entry* const entry = find_entry(dataset);
        if (entry == nullptr)
            return core::fail(Error::Code::NotFound, "there is no dataset of this name",
                              "`dataset.list` lists them");
        command::SourceOptions wish = entry->taken;
        wish.velocity = velocity;
        if (auto fit = check_source_options(entry->argument, wish); !fit)
            return fit;
        if (entry->taken.velocity == velocity ||
            (entry->open && entry->open->info.velocity == velocity))
            return {};
        if (entry->open || entry->status.state != DatasetState::Failed)
            return core::fail(
                Error::Code::InvalidArgument,
                entry->status.name + " is shown with the velocity " +
                    (entry->open ? entry->open->info.velocity : "that its files suggest"),
                "the operator of the server can serve the data a second time: wakesurf serve CASE "
                "--velocity " +
                    velocity);
        entry->taken = std::move(wish);
        entry->status.state = DatasetState::Importing;
        entry->status.error.reset();
        ++wakeups_;
    }
    again_.notify_all();
    listener_(std::string(dataset));
    return {};
}

std::vector<DatasetStatus> DatasetCatalogue::list() const {
    std::vector<DatasetStatus> out;
    const std::scoped_lock lock(mutex_);
    for (const auto& entry : entries_)
        out.push_back(entry->status);
    return out;
}

core::Result<DatasetStatus> DatasetCatalogue::status(std::string_view dataset) const {
    const std::scoped_lock lock(mutex_);
    if (const Entry* entry = find_entry(dataset))
        return entry->status;
    return core::fail(Error::Code::NotFound, "there is no dataset of this name",
                      "`dataset.list` lists them");
}

core::Result<std::shared_ptr<const LoadedDataset>>
DatasetCatalogue::find(std::string_view dataset) const {
    const std::scoped_lock lock(mutex_);
    const Entry* entry = find_entry(dataset);
    if (entry == nullptr)
        return core::fail(Error::Code::NotFound, "there is no dataset of this name",
                          "`dataset.list` lists them");
    if (!entry->open && entry->status.error)
        return tl::unexpected(*entry->status.error);
    if (!entry->open && entry->status.state == DatasetState::Stopped)
        return core::fail(Error::Code::NotFound,
                          "the import of " + entry->status.name +
                              " was stopped before its first time-step",
                          "`dataset.open` resumes the import");
    if (!entry->open)
        return core::fail(Error::Code::NotFound,
                          entry->status.name + " has no time-step imported yet",
                          "wait for its state to change");
    return entry->open;
}

} // namespace wakesurf::server
