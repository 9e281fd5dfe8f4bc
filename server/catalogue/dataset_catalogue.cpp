#include "server/catalogue/dataset_catalogue.hpp"

#include "server/catalogue/import_process.hpp"
#include "server/catalogue/source_stamp.hpp"
#include "store/store_manifest.hpp"

#include <algorithm>
#include <chrono>

namespace wakesurf::server {

using core::Error;

namespace {

// What an import under way does not change: one that is ready grows and is told when it has. One that failed is imported again.
bool settled(DatasetState state) {
    return state == DatasetState::Ready || state == DatasetState::Stopped ||
           state == DatasetState::Incomplete;
}

// What the importer is told at least: with less, none could begin.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t smallest_import = std::size_t{1} << 30;
#else
constexpr std::size_t smallest_import = std::size_t{64} << 20;
#endif

std::size_t steps_ready(const LoadedDataset& open) {
    if (!open.cache)
        return open.info.times.size();
    std::size_t ready = 0;
    for (std::size_t i = 0; i < open.info.times.size(); ++i)
        ready += open.cache->source().ready(i) ? 1 : 0;
    return ready;
}

/// What an import under way takes of the account: it is another process of the same machine. Waits until others have given it back.
core::Result<core::MemoryAccount::Share> import_memory(const OpenOptions& options,
                                                       const std::stop_token& stop) {
    constexpr std::size_t part = 4; // of all memory one part in so many
    constexpr std::chrono::seconds patience{30};
    if (!options.cache.account)
        return core::MemoryAccount::Share();
    auto share = options.cache.account->open(core::MemoryUse::Importers);
    const std::size_t bytes = options.cache.account->budget() / part;
    if (share.grow_to(bytes, stop, patience) || stop.stop_requested())
        return share;
    return tl::unexpected(options.cache.account->refusal("importing", bytes));
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
    catalogue->importer_ = std::jthread(
        [self = catalogue.get()](const std::stop_token& stop) { self->import_all(stop); });
    return catalogue;
}

DatasetCatalogue::~DatasetCatalogue() = default;

core::Result<void> DatasetCatalogue::add(const std::string& text) {
    auto argument = resolve_dataset(text);
    if (!argument)
        return tl::unexpected(argument.error());
    if (auto fit = check_source_options(*argument, options_.taken); !fit)
        return fit;
    auto entry = std::make_unique<Entry>();
    entry->argument = std::move(*argument);
    entry->taken = options_.taken;
    entry->status.name = entry->argument.name;
    if (entry->argument.kind == DatasetArgument::Kind::Flow) {
        auto flow = open_flow(entry->argument);
        if (!flow)
            return tl::unexpected(flow.error());
        entry->status.name = flow->info.name;
        entry->status.dataset = unused_id(entry->status.name);
        finish(*entry, std::move(flow));
    } else {
        entry->status.dataset = unused_id(entry->status.name);
    }
    entries_.push_back(std::move(entry));
    return {};
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

void DatasetCatalogue::import_all(const std::stop_token& stop) {
    for (const auto& entry : entries_) {
        if (stop.stop_requested())
            return;
        if (entry->argument.kind == DatasetArgument::Kind::Flow)
            continue;
        if (state_of(*entry) == DatasetState::Stopped) // while the ones before it were imported
            show_what_is_there(*entry, store_folder_of(*entry));
        else
            import_one(*entry, stop);
        listener_(entry->status.dataset);
    }
    watch(stop);
}

DatasetState DatasetCatalogue::state_of(const Entry& entry) const {
    const std::scoped_lock lock(mutex_);
    return entry.status.state;
}

SourceOptions DatasetCatalogue::taken_of(const Entry& entry) const {
    const std::scoped_lock lock(mutex_);
    return entry.taken;
}

std::filesystem::path DatasetCatalogue::store_folder_of(const Entry& entry) const {
    return store_folder(options_.store_root, entry.argument, taken_of(entry));
}

void DatasetCatalogue::watch(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        {
            std::unique_lock lock(mutex_);
            again_.wait_for(lock, stop, options_.watch_period, [this] { return wanted_again_; });
            wanted_again_ = false;
        }
        for (const auto& entry : entries_) {
            if (stop.stop_requested())
                return;
            if (entry->argument.kind != DatasetArgument::Kind::Source)
                continue;
            const DatasetState state = state_of(*entry);
            if (state == DatasetState::Importing)
                import_one(*entry, stop);
            else if (state != DatasetState::Stopped && due(*entry))
                look_again(*entry, stop);
            else
                continue;
            listener_(entry->status.dataset);
        }
    }
}

// A solver's log beside its data changes all the time: where nothing new was found, looking takes a twentieth of the time at most.
void DatasetCatalogue::look_again(Entry& entry, const std::stop_token& stop) {
    const std::size_t known = entry.status.steps_ready;
    const auto begun = std::chrono::steady_clock::now();
    import_one(entry, stop);
    const auto ended = std::chrono::steady_clock::now();
    if (entry.status.steps_ready == known)
        entry.rests_until = ended + 20 * (ended - begun);
}

// Changed since the last import began; or that one failed, perhaps at a file that was being written: then again, less and less often.
bool DatasetCatalogue::due(Entry& entry) const {
    if (std::chrono::steady_clock::now() < entry.rests_until)
        return false;
    if (source_stamp(entry.argument.path) != entry.stamp) {
        entry.failures = 0;
        return true;
    }
    if (!entry.failed)
        return false;
    constexpr unsigned rarest = 16;
    return ++entry.looks % std::min(1u << std::min(entry.failures, 8u), rarest) == 0;
}

void DatasetCatalogue::import_one(Entry& entry, const std::stop_token& stop) {
    if (entry.argument.kind == DatasetArgument::Kind::Store)
        return finish(entry, open_store(entry.argument.path, options_.cache));
    const auto folder = store_folder_of(entry);
    entry.stamp = source_stamp(entry.argument.path); // before reading: later changes are noticed
    const auto imported = run_import(entry, folder, stop);
    if (!imported && imported.error().code == Error::Code::Cancelled && !stop.stop_requested())
        return show_what_is_there(entry, folder);
    entry.failed = !imported;
    if (!imported) {
        ++entry.failures;
        return give_up(entry, folder, imported.error());
    }
    entry.failures = 0;
    finish(entry, reopened(entry, folder));
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
    if (source.stop_requested())
        return core::fail(Error::Code::Cancelled, "the import was stopped before it began");
    const std::stop_callback all_end(stop, [source]() mutable { source.request_stop(); });
    const auto memory = import_memory(options_, source.get_token());
    if (!memory)
        return tl::unexpected(memory.error());
    const auto listener = [&](const store::ImportProgress& progress) {
        if (show(entry, progress, folder))
            listener_(entry.status.dataset);
    };
    const std::size_t most =
        memory->bytes() > 0 ? std::max(memory->bytes(), smallest_import) : 0; // 0: its own bound
    ImportCommand command{entry.argument.path, folder, {}, {}, options_.importer, {}, 0, most};
    command.taken = taken_of(entry);
    return run_import_process(command, listener, source.get_token());
}

// Of an import that was stopped, or of an earlier one; by now it may be wanted again.
void DatasetCatalogue::show_what_is_there(Entry& entry, const std::filesystem::path& folder) {
    auto opened = reopened(entry, folder);
    if (!opened || (!entry.open && steps_ready(*opened) == 0))
        return;
    finish(entry, std::move(opened), Ending::Stopped);
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
        wanted_again_ = true;
    }
    again_.notify_all();
    listener_(std::string(dataset));
    return true;
}

core::Result<void> DatasetCatalogue::choose_velocity(std::string_view dataset,
                                                     const std::string& velocity) {
    {
        const std::scoped_lock lock(mutex_);
        Entry* const entry = find_entry(dataset);
        if (entry == nullptr)
            return core::fail(Error::Code::NotFound, "there is no dataset of this name",
                              "list them with dataset.list");
        SourceOptions wish = entry->taken;
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
                "whoever runs the server can serve it again beside this: wakesurf serve CASE "
                "--velocity " +
                    velocity);
        entry->taken = std::move(wish);
        entry->status.state = DatasetState::Importing;
        entry->status.error.reset();
        wanted_again_ = true;
    }
    again_.notify_all();
    listener_(std::string(dataset));
    return {};
}

// What is open stays open as long as it is the same series: with its cache, and with ranges known now.
core::Result<LoadedDataset> DatasetCatalogue::reopened(const Entry& entry,
                                                       const std::filesystem::path& folder) const {
    if (entry.open) {
        const auto manifest = store::read_store_manifest(folder, core::PosixDisk());
        if (manifest && manifest->layout.times == entry.open->store->times() &&
            manifest->layout.checksums == entry.open->store->layout().checksums) {
            auto whole = *entry.open;
            whole.info = manifest->info;
            return whole;
        }
    }
    return open_store(folder, options_.cache);
}

// Time-steps before the one that could not be imported stay usable.
void DatasetCatalogue::give_up(Entry& entry,
                               const std::filesystem::path& folder,
                               const core::Error& error) {
    if (!entry.open)
        return finish(entry, tl::unexpected(error));
    finish(entry, reopened(entry, folder));
    const std::scoped_lock lock(mutex_);
    if (entry.status.state == DatasetState::Failed)
        return;
    entry.status.error = error;
    if (entry.status.error->hint.empty())
        entry.status.error->hint = "the other time-steps can be used; once the cause is fixed, the "
                                   "import resumes by itself";
}

// Who is told of ready time-steps asks for them at once: they are counted once find() has them, and not before.
bool DatasetCatalogue::show(Entry& entry,
                            const store::ImportProgress& progress,
                            const std::filesystem::path& folder) {
    if (settled(state_of(entry)))
        return false;
    std::shared_ptr<const LoadedDataset> first;
    if (progress.done > 0 && !entry.open)
        if (auto opened = open_store(folder, options_.cache)) {
            opened->info.dataset = entry.status.dataset;
            opened->info.name = entry.status.name;
            first = std::make_shared<const LoadedDataset>(std::move(*opened));
        }
    const std::scoped_lock lock(mutex_);
    if (first)
        entry.open = std::move(first);
    if (settled(entry.status.state))
        return false;
    entry.status.steps_ready = entry.open ? progress.done : 0;
    entry.status.steps_total = progress.total;
    entry.status.progress = share(progress.done, progress.total);
    entry.status.remaining = progress.remaining;
    return true;
}

void DatasetCatalogue::finish(Entry& entry, core::Result<LoadedDataset> opened, Ending how) {
    std::size_t ready = 0;
    if (opened) {
        opened->info.dataset = entry.status.dataset;
        opened->info.name = entry.status.name;
        ready = steps_ready(*opened);
    }
    const std::scoped_lock lock(mutex_);
    if (!opened) {
        entry.status.state = DatasetState::Failed;
        entry.status.error = opened.error();
        return;
    }
    if (how == Ending::Whole) {
        const std::size_t total = opened->info.times.size();
        entry.status.state = ready < total ? DatasetState::Incomplete : DatasetState::Ready;
        entry.status.error.reset();
        if (ready < total)
            entry.status.error = incomplete(ready, total);
    }
    entry.status.steps_ready = ready;
    entry.status.steps_total = opened->info.times.size();
    entry.status.progress = how == Ending::Whole ? 1.0 : share(ready, entry.status.steps_total);
    entry.open = std::make_shared<const LoadedDataset>(std::move(*opened));
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
                      "list them with dataset.list");
}

core::Result<std::shared_ptr<const LoadedDataset>>
DatasetCatalogue::find(std::string_view dataset) const {
    const std::scoped_lock lock(mutex_);
    const Entry* entry = find_entry(dataset);
    if (entry == nullptr)
        return core::fail(Error::Code::NotFound, "there is no dataset of this name",
                          "list them with dataset.list");
    if (!entry->open && entry->status.error)
        return tl::unexpected(*entry->status.error);
    if (!entry->open && entry->status.state == DatasetState::Stopped)
        return core::fail(Error::Code::NotFound,
                          "the import of " + entry->status.name +
                              " was stopped before its first time-step",
                          "call dataset.open to resume the import");
    if (!entry->open)
        return core::fail(Error::Code::NotFound,
                          entry->status.name + " has no time-step imported yet",
                          "wait for its state to change");
    return entry->open;
}

} // namespace wakesurf::server
