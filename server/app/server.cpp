#include "server/app/server.hpp"

#include "protocol/api/json_rpc.hpp"
#include "server/net/http_connection.hpp"
#include "server/net/io_loop.hpp"
#include "server/net/kept_logins.hpp"
#include "server/net/listener.hpp"
#include "server/rpc/cache_news.hpp"
#include "server/rpc/dataset_entry.hpp"
#include "server/rpc/family_jobs.hpp"
#include "server/rpc/import_waiters.hpp"
#include "server/rpc/method.hpp"
#include "server/rpc/notices.hpp"
#include "server/service/base/late_file.hpp"
#include "server/service/base/log_text.hpp"
#include "server/service/base/shipped_files.hpp"
#include "server/service/base/waking_clock.hpp"
#include "server/service/compute/thread_priority.hpp"
#include "server/service/journal/kept_sessions.hpp"
#include "server/service/journal/sqlite_journal.hpp"
#include "server/service/journal/start_guard.hpp"
#include "server/service/journal/state_desk.hpp"
#include "server/service/limits.hpp"
#include "server/service/metrics/process_account.hpp"
#include "server/service/session/data/catalogue_datasets.hpp"
#include "server/service/session/session_restoring.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <nlohmann/json.hpp>
#include <signal.h>
#include <spdlog/spdlog.h>

#include <map>
#include <utility>

namespace wakesurf::server {

namespace asio = boost::asio;

namespace {

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

/// Holds the parts in order of dependence: the last declared is destroyed first. Connections end with the
/// context's handlers, jobs with the pool.
struct Server::Parts {
    Parts(const ServerOptions& options, std::optional<KeptSessions> found)
        : memory(options.memory), kept(std::move(found)), pool(options.threads),
          files(StaticFiles::load(options.web.empty() ? find_web_client() : options.web)) {}

    void serve(const ServerOptions& options) {
        port = listener->port();
        if (journal)
            metrics.durable(true);
        desk = start_desk(options);
        gate.emplace(GateOptions{options.token, options.host, port, options.origins, tls != nullptr,
                                 logins ? &*logins : nullptr},
                     entropy, clock, grants, &metrics);
        std::string notice;
        if (kept) {
            starts.emplace(kept->folder.path());
            if (starts->careful()) {
                withheld_surfaces = withheld(starts->died());
                notice = careful_notice(starts->died());
                spdlog::warn("event=careful_start died={} message=\"{}\" hint=\"{}\"",
                             starts->died(), withheld_surfaces->message, withheld_surfaces->hint);
            }
        }
        datasets.emplace(*catalogue);
        SessionServices services{loop, pool, *datasets, entropy, &metrics, journal.get(), &clock};
        services.memory = &memory.account();
        services.withheld = withheld_surfaces ? &*withheld_surfaces : nullptr;
        sessions.emplace(std::move(services));
        sessions->on_gone([this](const std::string& id) { grants.forget(id); });
        dispatcher.emplace(
            method_table(),
            MethodContext{*sessions, *datasets, [this] { return dataset_entries(*catalogue); },
                          prober, grants, clock, loop, journal.get(), [this] { return standing(); },
                          &metrics, &imports.emplace(*catalogue, loop), notice, &budgets,
                          &families.emplace(loop, pool, *catalogue, memory.account())},
            protocol::RpcLimits{limits::message_bytes, limits::message_depth, limits::batch});
        downloads.emplace(loop, pool, *sessions, *catalogue, memory.account());
        session_files.emplace(loop, pool, *sessions, *datasets, journal.get());
        routes.emplace(
            *gate, budgets, outboxes, files, *dispatcher, *downloads, *session_files,
            [this] { return metrics.text(standing()); },
            [this] { return health_text(dataset_counts()); },
            [this](const std::string& person) { connections.log_out(person); });
        if (kept)
            restore();
    }

    std::vector<DatasetCount> dataset_counts() const {
        std::vector<DatasetCount> out;
        for (const std::string_view state : dataset_state_names)
            out.push_back({state, 0});
        for (const DatasetStatus& each : catalogue->list())
            ++out[static_cast<std::size_t>(each.state)].count;
        return out;
    }

    Standing standing() const {
        Standing out;
        out.datasets = dataset_counts();
        out.uptime = std::chrono::duration<double>(clock.now() - started).count();
        out.connections = admission.connections();
        out.clients = budgets.used(Use::Socket);
        out.memory = memory_standing(memory.account());
        out.sessions = sessions->all().size();
        for (const auto& [id, session] : sessions->all()) {
            out.surfaces += session->records().count(RecordType::Surface);
            out.participants += session->participants().present().size();
        }
        for (const DatasetStatus& each : catalogue->list())
            if (const auto open = catalogue->find(each.dataset); open && (*open)->cache) {
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
        if (memory.too_much())
            pool.run([account = memory.account()] { account.make_room(0); });
        for (const DatasetStatus& each : catalogue->list())
            if (const auto open = catalogue->find(each.dataset); open && (*open)->levels)
                pool.let_go((*open)->levels->take_idle());
        watching = loop.after(limits::memory_look, [this] { watch_memory(); });
    }

    std::unique_ptr<SqliteJournal> start_journal() {
        if (!kept)
            return nullptr;
        return std::make_unique<SqliteJournal>(
            loop, std::move(kept->store),
            [this](const core::Result<void>& turn) { tell_durability(turn); });
    }

    /// Makes the desk, which accepts requests at once, but answers from what the journal has written.
    std::unique_ptr<StateDesk> start_desk(const ServerOptions& options) {
        if (!journal)
            return nullptr;
        return std::make_unique<StateDesk>(
            options.state, StateDesk::Services{[this] { return journal->hold(); },
                                               [this] { return journal->release(); }});
    }

    void restore() {
        const RestoredSessions restored =
            restore_sessions(std::exchange(kept->sessions, {}), *sessions, grants);
        for (const auto& [id, records] : std::exchange(kept->aside, {}))
            if (const auto session = sessions->find(id))
                (*session)->recall_aside(records, false);
        for (const auto& [id, records] : std::exchange(kept->damaged, {})) {
            spdlog::warn("event=records_damaged session={} count={}", id, records.size());
            if (const auto session = sessions->find(id))
                (*session)->recall_aside(records, true);
        }
        for (const RestoredSessions::Refused& each : restored.refused)
            spdlog::warn("event=record_kept_aside session={} why=\"{}\"", each.session,
                         each.record.why);
        spdlog::info("{} records of {} sessions restored", restored.records, restored.sessions);
    }

    void tell_durability(const core::Result<void>& turn) {
        metrics.durable(turn.has_value());
        spdlog::log(turn ? spdlog::level::info : spdlog::level::warn, "event=durable yes={}",
                    turn.has_value());
        connections.announce(durability_notice(turn));
    }

    void tell_all(const std::string& dataset) {
        const auto open = catalogue->find(dataset);
        if (open)
            news.watch(dataset, (*open)->cache);
        sessions->dataset_changed(dataset);
        tell_of_replaced_data(dataset, open ? (*open)->store : nullptr);
        imports->changed(dataset);
        if (const auto status = catalogue->status(dataset))
            connections.announce(
                protocol::rpc_notification("dataset.patched", dataset_entry(*status)));
    }

    /// Keeps counting the old data while they are imported once more.
    void tell_of_replaced_data(const std::string& dataset,
                               const std::shared_ptr<const store::StoreReader>& now) {
        auto& before = told[dataset];
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
        connections.announce(replaced_data_notice({catalogue->status(dataset)->name}));
    }

    /// Ends run() once every client has taken the goodbye, or at `deadline`.
    void stop_when_alone(std::chrono::steady_clock::time_point deadline) {
        if (connections.count() == 0 || clock.now() >= deadline)
            return context.stop();
        waiting = loop.after(std::chrono::milliseconds(10),
                             [this, deadline] { stop_when_alone(deadline); });
    }

    /// Loads a renewed certificate at SIGHUP.
    void renew_tls_on(asio::signal_set& hangup) {
        hangup.async_wait([this, &hangup](boost::system::error_code error, int) {
            if (error)
                return;
            if (const auto renewed = tls->renew())
                spdlog::info("event=certificate_renewed");
            else
                spdlog::warn("event=certificate_kept reason={}",
                             log_value(renewed.error().message));
            renew_tls_on(hangup);
        });
    }

    void run_what_is_left() {
        context.restart();
        for (int round = 0; round < 16; ++round)
            context.poll();
    }

    ProcessAccount memory;
    std::optional<KeptSessions> kept;
    std::optional<StartGuard> starts; ///< with `--state`
    std::optional<core::Error> withheld_surfaces;
    SystemEntropy entropy;
    core::SteadyClock clock;
    const std::chrono::steady_clock::time_point started = clock.now();
    Metrics metrics{clock};
    OutboxMemory outboxes{memory.account()};
    const Admission::Limits places = limits_for_descriptors();
    Admission admission{places, metrics};
    Budgets budgets{clock, &metrics, budget_for(places.connections)};
    TrustedProxies proxies;
    SecurityHeaders headers;
    std::unique_ptr<TlsContext> tls;
    Connections connections;
    WriteTurns turns{[this](std::function<void()> task) { loop.post(std::move(task)); }, clock};
    asio::io_context context{1};
    IoLoop loop{context};
    ComputePool pool;
    Prober prober{loop, pool};
    CacheNews news{loop, [this](const std::string& message) { connections.announce(message); }};
    StaticFiles files;
    std::uint16_t port = 0;
    std::unique_ptr<SqliteJournal> journal = start_journal(); ///< null without `--state`
    std::unique_ptr<StateDesk> desk;                          ///< its thread asks the journal
    std::unique_ptr<DatasetCatalogue> catalogue;
    WakingClock waking;
    Grants grants{{loop, waking, entropy, unix_seconds, journal.get()}};
    std::optional<LateFile> ended_logins; ///< with `--state`
    std::optional<KeptLogins> logins;     ///< likewise
    std::optional<Gate> gate;
    std::optional<CatalogueDatasets> datasets;
    std::optional<SessionDirectory> sessions;
    std::optional<ImportWaiters> imports;
    std::optional<FamilyJobs> families;
    std::optional<Dispatcher> dispatcher;
    std::optional<Downloads> downloads;
    std::optional<SessionFiles> session_files;
    std::optional<Routes> routes;
    std::map<std::string, std::shared_ptr<const store::StoreReader>> told; ///< data, by dataset
    std::shared_ptr<Listener> listener;
    std::shared_ptr<void> waiting, watching; ///< timers of stop_when_alone, watch_memory
};

Server::Server(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Server::~Server() = default;

core::Result<std::unique_ptr<Server>> Server::open(const ServerOptions& options) {
    std::optional<KeptSessions> kept;
    if (!options.state.empty()) {
        auto found = KeptSessions::open(options.state);
        if (!found)
            return tl::unexpected(found.error());
        kept.emplace(std::move(*found));
    }
    auto parts = std::make_unique<Parts>(options, std::move(kept));
    Parts* const all = parts.get();
    all->proxies = options.proxies;
    all->headers = SecurityHeaders(options.frame_origins);
    if (all->kept) {
        all->ended_logins.emplace(all->loop, all->kept->folder.path() / KeptLogins::ended_name);
        auto logins = KeptLogins::open(all->kept->folder.path(), all->entropy,
                                       [all](std::string text, KeptLogins::Done done) {
                                           all->ended_logins->put(std::move(text), std::move(done));
                                       });
        if (!logins)
            return tl::unexpected(logins.error());
        all->logins.emplace(std::move(*logins));
    }
    if (!options.certificate.empty()) {
        auto tls = TlsContext::load(options.certificate, options.key);
        if (!tls)
            return tl::unexpected(tls.error());
        all->tls = std::move(*tls);
    }
    auto listener = Listener::open(
        all->context, options.host, options.port, [all](asio::ip::tcp::socket socket) {
            serve_http(std::move(socket),
                       {*all->routes, all->connections, all->grants, all->admission, all->budgets,
                        all->proxies, all->metrics, all->outboxes, all->turns, all->headers,
                        all->tls.get()});
        });
    if (!listener)
        return tl::unexpected(listener.error());
    all->listener = *listener;
    OpenOptions open;
    open.store_root = options.store_root;
    open.taken = options.taken;
    open.cache.account = all->memory.account();
    if (!options.brick_words.empty()) {
        open.ranks.emplace();
        open.ranks->words = options.brick_words;
        open.ranks->program = this_program().parent_path() / "wakesurf-bricks";
        open.ranks->memory = options.brick_memory;
    }
    auto catalogue =
        DatasetCatalogue::open(options.datasets, open, [all](const std::string& dataset) {
            all->loop.post([all, dataset] { all->tell_all(dataset); });
        });
    if (!catalogue)
        return tl::unexpected(catalogue.error());
    all->catalogue = std::move(*catalogue);
    all->serve(options);
    return std::unique_ptr<Server>(new Server(std::move(parts)));
}

std::uint16_t Server::port() const {
    return parts_->port;
}

std::size_t Server::end_links() {
    return parts_->grants.end_all("the server has a new token");
}

void Server::run() {
    Parts& all = *parts_;
    if (all.files.empty())
        spdlog::warn("event=no_web_client message=\"the page is not beside this program\" "
                     "hint=\"build it, as ./run "
                     "does, or name its folder with --web; scripts can still connect\"");
    if (!all.journal)
        spdlog::info("event=sessions_not_kept hint=\"--state DIR keeps them\"");
    asio::signal_set signals(all.context, SIGINT, SIGTERM);
    asio::signal_set hangup(all.context);
    if (all.tls) {
        hangup.add(SIGHUP);
        all.renew_tls_on(hangup);
    } else if (!ignored(SIGHUP)) // nohup wants it to continue
        signals.add(SIGHUP);
    signals.async_wait([&](boost::system::error_code error, int) {
        if (error)
            return;
        spdlog::info("event=stopping clients={}", all.budgets.used(Use::Socket));
        all.listener->stop();
        all.connections.go_away();
        all.stop_when_alone(std::chrono::steady_clock::now() + goodbye);
    });
    spdlog::info("event=listening port={} tls={} connections={}", all.port, all.tls != nullptr,
                 all.places.connections);
    all.listener->start();
    all.watch_memory();
    const auto served = all.loop.after(limits::start_watched, [&all] {
        if (all.starts)
            all.starts->good();
    });
    ask_for_short_slices();
    all.context.run();
    // The sockets' handlers own the connections; they must run while there are sessions to leave.
    all.connections.abandon();
    all.run_what_is_left();
    if (all.starts)
        all.starts->good();
    if (!all.journal)
        return;
    all.sessions->keep_times();
    all.journal->finish();
    all.run_what_is_left();
}

} // namespace wakesurf::server
