#include "server/app/server.hpp"

#include "protocol/api/json_rpc.hpp"
#include "server/base/limits.hpp"
#include "server/base/log_text.hpp"
#include "server/base/process_account.hpp"
#include "server/base/shipped_files.hpp"
#include "server/base/write_behind_file.hpp"
#include "server/data/datasets.hpp"
#include "server/live/compute/worker_threads.hpp"
#include "server/net/http_connection.hpp"
#include "server/net/io_loop.hpp"
#include "server/net/listener.hpp"
#include "server/net/logins.hpp"
#include "server/net/methods/dataset_answers.hpp"
#include "server/net/methods/import_waiters.hpp"
#include "server/net/methods/kept_field_jobs.hpp"
#include "server/net/methods/method.hpp"
#include "server/net/methods/notifications.hpp"
#include "server/sessions/journal/backup_coordinator.hpp"
#include "server/sessions/journal/crash_loop_guard.hpp"
#include "server/sessions/journal/sqlite_journal.hpp"
#include "server/sessions/journal/state_store.hpp"
#include "server/sessions/session_exchange.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <spdlog/spdlog.h>
#include <time.h>

#include <map>
#include <utility>

namespace wakesurf::server {

namespace asio = boost::asio;

namespace {

/// The clock goes on while the machine sleeps, as a laptop does, and cannot be set.
class WakingClock final : public core::Clock {
  public:
    std::chrono::steady_clock::time_point now() const override {
        timespec now{};
        ::clock_gettime(CLOCK_BOOTTIME, &now);
        return std::chrono::steady_clock::time_point(std::chrono::seconds(now.tv_sec) +
                                                     std::chrono::nanoseconds(now.tv_nsec));
    }
};

constexpr std::chrono::milliseconds goodbye{700};

nlohmann::json dataset_entries(const DatasetCatalogue& catalogue) {
    auto list = nlohmann::json::array();
    for (const DatasetStatus& each : catalogue.list())
        list.push_back(dataset_entry(each));
    return list;
}

bool ignored(int signal) {
    struct sigaction now {};

    return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

/// Scales the budgets of sockets and requests to a lower limit of connections: the rest is for clients that
/// have shown no token yet.
limits::Budget budget_for(std::size_t connections) {
    limits::Budget out = limits::all;
    out.sockets = std::min(out.sockets, connections / 2);
    out.requests = std::min(out.requests, connections / 4);
    return out;
}

} // namespace

/// The parts that may fail to open, and those that they are made of, in order of dependence: the last
/// declared is destroyed first. Connections end with the context's handlers.
struct Server::Inputs {
    Inputs(const ServerOptions& options, std::optional<StoredSessions> found)
        : memory(options.memory), kept(std::move(found)), proxies(options.proxies),
          headers(options.frame_origins) {}

    core::Result<void> open(const ServerOptions& options);

    ProcessAccount memory;
    std::optional<StoredSessions> kept; ///< with `--state`
    SystemEntropy entropy;
    core::SteadyClock clock;
    Metrics metrics{clock};
    OutboxMemory outboxes{memory.account()};
    const Admission::Limits places = limits_for_descriptors();
    Admission admission{places, metrics};
    Budgets budgets{clock, &metrics, budget_for(places.connections)};
    TrustedProxies proxies;
    SecurityHeaders headers;
    std::unique_ptr<TlsContext> tls; ///< null: plain HTTP
    Connections connections;
    WriteScheduler turns{[this](std::function<void()> task) { loop.post(std::move(task)); }, clock};
    asio::io_context context{1};
    IoLoop loop{context};
    std::optional<WriteBehindFile> ended_logins; ///< with `--state`
    std::optional<Logins> logins;                ///< with `--state`
    std::function<void(asio::ip::tcp::socket)> accepted;
    std::shared_ptr<Listener> listener; ///< calls `accepted`, once it is started
    std::function<void(const std::string& dataset)> changed;
    std::unique_ptr<DatasetCatalogue> catalogue; ///< has the loop call `changed`
};

core::Result<void> Server::Inputs::open(const ServerOptions& options) {
    if (kept) {
        ended_logins.emplace(loop, kept->folder.path() / Logins::ended_name);
        auto found = Logins::open(kept->folder.path(), entropy,
                                  [this](Logins::To to, std::string text, Logins::Done done) {
                                      if (to == Logins::To::Append)
                                          ended_logins->append(std::move(text), std::move(done));
                                      else
                                          ended_logins->put(std::move(text), std::move(done));
                                  });
        if (!found)
            return tl::unexpected(found.error());
        logins.emplace(std::move(*found));
    }
    if (!options.certificate.empty()) {
        auto loaded = TlsContext::load(options.certificate, options.key);
        if (!loaded)
            return tl::unexpected(loaded.error());
        tls = std::move(*loaded);
    }
    auto listening =
        Listener::open(context, options.host, options.port,
                       [this](asio::ip::tcp::socket socket) { accepted(std::move(socket)); });
    if (!listening)
        return tl::unexpected(listening.error());
    listener = *listening;
    OpenOptions how;
    how.store_root = options.store_root;
    how.taken = options.taken;
    how.cache.account = memory.account();
    how.secrets = options.secrets;
    for (const auto& own : {options.state, options.key})
        if (!own.empty())
            how.secrets.push_back(own);
    if (!options.brick_words.empty()) {
        how.ranks.emplace();
        how.ranks->words = options.brick_words;
        how.ranks->program = this_program().parent_path() / "wakesurf-bricks";
        how.ranks->memory = options.brick_memory;
    }
    auto opened = DatasetCatalogue::open(options.datasets, how, [this](const std::string& dataset) {
        loop.post([this, dataset] { changed(dataset); });
    });
    if (!opened)
        return tl::unexpected(opened.error());
    catalogue = std::move(*opened);
    return {};
}

/// The other parts, in order of dependence like Inputs. Jobs end with the pool.
struct Server::Parts {
    Parts(const ServerOptions& options, std::unique_ptr<Inputs> made)
        : inputs(std::move(made)), pool(options.threads),
          files(StaticFiles::load(options.web.empty() ? find_web_client() : options.web)),
          backup(start_backup_coordinator(options)),
          gate({options.token, options.host, port, options.origins, in.tls != nullptr,
                in.logins ? &*in.logins : nullptr},
               in.entropy,
               in.clock,
               grants,
               &in.metrics) {
        in.accepted = [this](asio::ip::tcp::socket socket) {
            serve_http(std::move(socket),
                       {routes, in.connections, grants, in.admission, in.budgets, in.proxies,
                        in.metrics, in.outboxes, in.turns, in.headers, in.tls.get()});
        };
        in.changed = [this](const std::string& dataset) { tell_all(dataset); };
        if (journal)
            in.metrics.durable(true);
        sessions.on_gone([this](const std::string& id) { grants.forget(id); });
        if (in.kept)
            restore();
    }

    /// Returns why surfaces are not computed; empty where they are.
    std::optional<core::Error> why_withheld() const {
        if (!starts || !starts->careful())
            return std::nullopt;
        core::Error why = withheld(starts->died());
        spdlog::warn("event=careful_start died={} message=\"{}\" hint=\"{}\"", starts->died(),
                     why.message, why.hint);
        return why;
    }

    SessionServices session_services() {
        SessionServices out{in.loop,     pool,          datasets, in.entropy,
                            &in.metrics, journal.get(), &in.clock};
        out.memory = &in.memory.account();
        out.withheld = withheld_surfaces ? &*withheld_surfaces : nullptr;
        return out;
    }

    MethodContext method_context() {
        return {sessions,    datasets,      [this] { return dataset_entries(*in.catalogue); },
                prober,      grants,        in.clock,
                in.loop,     journal.get(), [this] { return status(); },
                &in.metrics, &imports,      withheld_surfaces ? careful_notice(starts->died()) : "",
                &in.budgets, &kept_fields};
    }

    std::vector<DatasetCount> dataset_counts() const {
        std::vector<DatasetCount> out;
        for (const std::string_view state : dataset_state_names)
            out.push_back({state, 0});
        for (const DatasetStatus& each : in.catalogue->list())
            ++out[static_cast<std::size_t>(each.state)].count;
        return out;
    }

    ServerStatus status() const {
        ServerStatus out;
        out.datasets = dataset_counts();
        out.uptime = std::chrono::duration<double>(in.clock.now() - started).count();
        out.connections = in.admission.connections();
        out.clients = in.budgets.used(Use::Socket);
        out.memory = memory_status(in.memory.account());
        out.sessions = sessions.all().size();
        for (const auto& [id, session] : sessions.all()) {
            out.surfaces += session->records().count(RecordType::Surface);
            out.participants += session->participants().present().size();
        }
        for (const DatasetStatus& each : in.catalogue->list())
            if (const auto open = in.catalogue->find(each.dataset); open && (*open)->cache) {
                const auto status = (*open)->cache->status();
                out.caches.push_back(
                    {each.dataset, status.hits, status.loads, status.bytes, status.budget});
                if ((*open)->ranks) {
                    const auto bricks = (*open)->ranks->ranks().status();
                    out.bricks.push_back(
                        {each.dataset, bricks.by_ranks, bricks.by_files, bricks.ranks});
                }
            }
        return out;
    }

    /// Detects memory that was taken without the account, and makes others release some.
    void watch_memory() {
        if (in.memory.too_much())
            pool.run([account = in.memory.account()] { account.make_room(0); });
        watching = in.loop.after(limits::memory_poll_interval, [this] { watch_memory(); });
    }

    std::unique_ptr<SqliteJournal> start_journal() {
        if (!in.kept)
            return nullptr;
        return std::make_unique<SqliteJournal>(
            in.loop, std::move(in.kept->store),
            [this](const core::Result<void>& turn) { tell_durability(turn); });
    }

    /// Accepts requests for a backup at once, and answers from what the journal has written.
    std::unique_ptr<BackupCoordinator> start_backup_coordinator(const ServerOptions& options) {
        if (!journal)
            return nullptr;
        return std::make_unique<BackupCoordinator>(
            options.state, BackupCoordinator::Services{[this] { return journal->hold(); },
                                                       [this] { return journal->release(); }});
    }

    void restore() {
        const RestoredSessions restored =
            restore_sessions(std::exchange(in.kept->sessions, {}), sessions, grants);
        for (const auto& [id, records] : std::exchange(in.kept->aside, {}))
            if (const auto session = sessions.find(id))
                (*session)->recall_aside(records, false);
        for (const auto& [id, records] : std::exchange(in.kept->damaged, {})) {
            spdlog::warn("event=records_damaged session={} count={}", id, records.size());
            if (const auto session = sessions.find(id))
                (*session)->recall_aside(records, true);
        }
        for (const RestoredSessions::Refused& each : restored.refused)
            spdlog::warn("event=record_kept_aside session={} why=\"{}\"", each.session,
                         each.record.why);
        spdlog::info("{} records of {} sessions restored", restored.records, restored.sessions);
    }

    void tell_durability(const core::Result<void>& turn) {
        in.metrics.durable(turn.has_value());
        spdlog::log(turn ? spdlog::level::info : spdlog::level::warn, "event=durable yes={}",
                    turn.has_value());
        in.connections.announce(durability_notice(turn));
    }

    void tell_all(const std::string& dataset) {
        const auto open = in.catalogue->find(dataset);
        if (open)
            cache_events.watch(dataset, (*open)->cache);
        sessions.dataset_changed(dataset);
        tell_of_replaced_data(dataset, open ? (*open)->store : nullptr);
        imports.changed(dataset);
        if (const auto status = in.catalogue->status(dataset))
            in.connections.announce(
                protocol::rpc_notification("dataset.patched", dataset_entry(*status)));
    }

    /// Keeps counting the old data while they are imported once more.
    void tell_of_replaced_data(const std::string& dataset,
                               const std::shared_ptr<const store::StoreReader>& now) {
        auto& before = announced_data[dataset];
        if (!now || now == before)
            return;
        const store::ValueMarks marks = now->marks();
        const bool known = before != nullptr;
        const bool same = known && marks.continues(before->marks());
        if (known && !same && before->marks().continues(marks))
            return;
        before = now;
        if (!known || same)
            return;
        spdlog::info("event=data_replaced dataset={}", log_value(dataset));
        in.connections.announce(replaced_data_notice({in.catalogue->status(dataset)->name}));
    }

    /// Ends run() once every client has taken the goodbye, or at `deadline`.
    void stop_when_alone(std::chrono::steady_clock::time_point deadline) {
        if (in.connections.count() == 0 || in.clock.now() >= deadline)
            return in.context.stop();
        waiting = in.loop.after(std::chrono::milliseconds(10),
                                [this, deadline] { stop_when_alone(deadline); });
    }

    /// Loads a renewed certificate at SIGHUP.
    void renew_tls_on(asio::signal_set& hangup) {
        hangup.async_wait([this, &hangup](boost::system::error_code error, int) {
            if (error)
                return;
            if (const auto renewed = in.tls->renew())
                spdlog::info("event=certificate_renewed");
            else
                spdlog::warn("event=certificate_kept reason={}",
                             log_value(renewed.error().message));
            renew_tls_on(hangup);
        });
    }

    void run_what_is_left() {
        in.context.restart();
        for (int round = 0; round < 16; ++round)
            in.context.poll();
    }

    std::unique_ptr<Inputs> inputs;
    Inputs& in = *inputs;
    const std::chrono::steady_clock::time_point started = in.clock.now();
    ComputePool pool;
    Prober prober{in.loop, pool};
    CacheEvents cache_events{
        in.loop, [this](const std::string& message) { in.connections.announce(message); }};
    StaticFiles files;
    const std::uint16_t port = in.listener->port();
    std::unique_ptr<SqliteJournal> journal = start_journal(); ///< null without `--state`
    std::unique_ptr<BackupCoordinator> backup;                ///< its thread asks the journal
    WakingClock waking;
    Grants grants{{in.loop, waking, in.entropy, unix_seconds, journal.get()}};
    Gate gate;
    std::optional<CrashLoopGuard> starts =
        in.kept ? std::optional<CrashLoopGuard>(in.kept->folder.path()) : std::nullopt;
    const std::optional<core::Error> withheld_surfaces = why_withheld();
    CatalogueDatasets datasets{*in.catalogue};
    SessionDirectory sessions{session_services()};
    ImportWaiters imports{*in.catalogue, in.loop};
    KeptFieldJobs kept_fields{in.loop, pool, *in.catalogue, in.memory.account()};
    Dispatcher dispatcher{
        method_table(), method_context(),
        protocol::RpcLimits{limits::message_bytes, limits::message_depth, limits::batch}};
    Downloads downloads{
        in.loop, pool, sessions, *in.catalogue, in.memory.account(), files.bytes(viewer_path)};
    SessionFiles session_files{in.loop, pool, sessions, datasets, journal.get()};
    Routes routes{gate,
                  in.budgets,
                  in.outboxes,
                  files,
                  dispatcher,
                  downloads,
                  session_files,
                  [this] { return in.metrics.text(status()); },
                  [this] { return health_text(dataset_counts()); },
                  [this](const std::string& person) { in.connections.log_out(person); }};
    std::map<std::string, std::shared_ptr<const store::StoreReader>>
        announced_data;                      ///< data, by dataset
    std::shared_ptr<void> waiting, watching; ///< timers of stop_when_alone, watch_memory
};

Server::Server(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Server::~Server() = default;

core::Result<std::unique_ptr<Server>> Server::open(const ServerOptions& options) {
    std::optional<StoredSessions> kept;
    if (!options.state.empty()) {
        auto found = StoredSessions::open(options.state);
        if (!found)
            return tl::unexpected(found.error());
        kept.emplace(std::move(*found));
    }
    auto inputs = std::make_unique<Inputs>(options, std::move(kept));
    if (auto opened = inputs->open(options); !opened)
        return tl::unexpected(opened.error());
    return std::unique_ptr<Server>(new Server(std::make_unique<Parts>(options, std::move(inputs))));
}

std::uint16_t Server::port() const {
    return parts_->port;
}

std::size_t Server::end_links() {
    return parts_->grants.end_all("the server has a new token");
}

void Server::run() {
    Parts& all = *parts_;
    Inputs& in = all.in;
    if (all.files.empty())
        spdlog::warn("event=no_web_client message=\"the page was not found next to this program\" "
                     "hint=\"build it, as ./run "
                     "does, or name its folder with --web; scripts can still connect\"");
    if (!all.journal)
        spdlog::info("event=sessions_not_kept hint=\"--state DIR keeps them\"");
    asio::signal_set signals(in.context, SIGINT, SIGTERM);
    asio::signal_set hangup(in.context);
    if (in.tls) {
        hangup.add(SIGHUP);
        all.renew_tls_on(hangup);
    } else if (!ignored(SIGHUP)) // nohup wants it to continue
        signals.add(SIGHUP);
    signals.async_wait([&](boost::system::error_code error, int) {
        if (error)
            return;
        spdlog::info("event=stopping clients={}", in.budgets.used(Use::Socket));
        in.listener->stop();
        in.connections.go_away();
        all.stop_when_alone(std::chrono::steady_clock::now() + goodbye);
    });
    spdlog::info("event=listening port={} tls={} connections={}", all.port, in.tls != nullptr,
                 in.places.connections);
    in.listener->start();
    all.watch_memory();
    const auto served = in.loop.after(limits::start_watched, [&all] {
        if (all.starts)
            all.starts->good();
    });
    ask_for_short_slices();
    in.context.run();
    // The sockets' handlers own the connections; they must run while there are sessions to leave.
    in.connections.abandon();
    all.run_what_is_left();
    if (all.starts)
        all.starts->good();
    if (!all.journal)
        return;
    all.sessions.keep_times();
    all.journal->finish();
    all.run_what_is_left();
}

} // namespace wakesurf::server
