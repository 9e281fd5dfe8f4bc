#include "server/app/command_output.hpp"
#include "server/app/commands.hpp"
#include "server/app/environment.hpp"
#include "server/app/opened_page.hpp"
#include "server/app/output_files.hpp"
#include "server/app/server.hpp"
#include "server/base/private_file.hpp"
#include "server/base/shipped_files.hpp"
#include "server/data/bricks/bricks_job.hpp"
#include "server/data/dataset_argument.hpp"
#include "server/net/gate.hpp"
#include "server/net/static_files.hpp"
#include "server/net/token_file.hpp"
#include "store/command/memory_size.hpp"

#include <CLI/CLI.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <fmt/core.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>
#include <unistd.h>

#include <charconv>
#include <csignal>
#include <cstdio>
#include <optional>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

struct Address {
    std::string host;
    std::uint16_t port = 0;
};

core::Result<Address> parse_address(const std::string& text) {
    const auto colon = text.rfind(':');
    Address address;
    if (colon != std::string::npos) {
        const char* end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, address.port);
        address.host = text.substr(0, colon);
        if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']')
            address.host = address.host.substr(1, address.host.size() - 2);
        if (error == std::errc{} && stop == end && !address.host.empty())
            return address;
    }
    return fail(Error::Code::InvalidArgument, "--listen is `" + text + "`",
                "write HOST:PORT, for example 127.0.0.1:8080");
}

/// Returns the address's port, or 0, which stands for any free one, if another program uses it.
std::uint16_t free_port(const Address& address) {
    boost::asio::io_context context;
    boost::system::error_code error;
    const auto host = boost::asio::ip::make_address(address.host, error);
    if (error)
        return address.port; // a name: the server reports the error
    const boost::asio::ip::tcp::endpoint endpoint(host, address.port);
    boost::asio::ip::tcp::acceptor door(context);
    door.open(endpoint.protocol(), error);
    door.set_option(boost::asio::socket_base::reuse_address(true), error);
    door.bind(endpoint, error);
    if (error != boost::asio::error::address_in_use)
        return address.port;
    spdlog::info("event=port_taken message=\"port {} is taken: this server has another one\"",
                 address.port);
    return 0;
}

/// Holds the options of a server, and the token's file, if it has one.
struct Prepared {
    ServerOptions server;
    std::optional<TokenFile> token_file;
};

/// Reads the token. The file is not changed before the server listens.
core::Result<std::string>
choose_token(const ServeOptions& options, const Address& address, std::optional<TokenFile>& file) {
    if (options.no_auth && !is_loopback(address.host))
        return fail(Error::Code::InvalidArgument,
                    "--no-auth would let anyone in at " + address.host,
                    "listen on 127.0.0.1, or leave --no-auth out");
    if (options.new_token && (options.no_auth || options.token_file.empty()))
        return fail(Error::Code::InvalidArgument, "--new-token needs a token file",
                    "give --token-file; without one, each start has a new token anyway");
    if (options.no_auth)
        return std::string{};
    SystemEntropy entropy;
    if (options.token_file.empty())
        return fresh_token(entropy);
    return file.emplace(options.token_file).token(entropy, options.new_token);
}

core::Result<void> check_origins(const std::vector<std::string>& origins,
                                 const std::string& option) {
    for (const std::string& origin : origins) {
        const auto scheme = origin.find("://");
        const bool known = origin.starts_with("http://") || origin.starts_with("https://");
        if (!known || !host_name(origin.substr(scheme + 3)))
            return fail(Error::Code::InvalidArgument, option + " is `" + origin + "`",
                        "write it as browsers do: https://viewer.example or http://host:port");
    }
    return {};
}

/// Returns a host that a browser on this machine can open.
std::string shown_host(const std::string& host) {
    if (host == "0.0.0.0" || host == "::")
        return "127.0.0.1";
    return host.find(':') == std::string::npos ? host : "[" + host + "]";
}

/// Returns the datasets given; if there are none, WAKESURF_DATASET, or else the bundled simulation.
std::vector<std::string> datasets_to_serve(const ServeOptions& options) {
    if (!options.datasets.empty())
        return options.datasets;
    if (const std::string named = from_environment("WAKESURF_DATASET"); !named.empty())
        return {named};
    if (const auto bundled = bundled_simulation()) {
        spdlog::info("event=bundled_simulation message=\"no dataset was named, so this is the "
                     "bundled simulation\" hint=\"name your own: wakesurf serve CASE\"");
        return {bundled->string()};
    }
    spdlog::warn("event=no_dataset message=\"no dataset was named, and the bundled simulation was "
                 "not found next to this program: there is nothing to show\" "
                 "hint=\"name one: wakesurf serve CASE\"");
    return {};
}

/// Checks the folder of a file with a secret: no other user may replace the file.
core::Result<void>
check_folder_of(const std::filesystem::path& file, const char* option, bool written) {
    std::error_code ignored;
    const auto folder = std::filesystem::absolute(file, ignored).parent_path();
    if (!std::filesystem::is_directory(folder, ignored))
        return fail(Error::Code::Io, std::string(option) + ": there is no folder for it",
                    "make the folder first");
    if (written)
        if (auto writable = check_writable(folder, option); !writable)
            return writable;
    return check_private_folder(folder, option, true);
}

/// Warns if others can replace the data; they are served all the same: a store may be a group's.
void warn_of_shared_store(const std::filesystem::path& root) {
    struct stat status {};

    if (::stat(root.c_str(), &status) != 0)
        return;
    const bool anybody = (status.st_mode & S_IWOTH) != 0 && (status.st_mode & S_ISVTX) == 0;
    if (anybody || (status.st_uid != ::geteuid() && status.st_uid != 0))
        spdlog::warn("event=store_of_others message=\"the folder for imported data {}: they can "
                     "replace what is served\" hint=\"name a folder of your own with --store\"",
                     anybody ? std::string("can be written by everybody")
                             : fmt::format("belongs to user {}", status.st_uid));
}

/// Checks that what has to be kept is writable, by this user only; the store need not be if it has all data.
core::Result<void> check_folders(const ServeOptions& options, const ServerOptions& server) {
    std::error_code ignored;
    if (!options.token_file.empty() && !options.no_auth)
        if (auto made = check_folder_of(options.token_file, "--token-file",
                                        options.new_token ||
                                            !std::filesystem::exists(options.token_file, ignored));
            !made)
            return made;
    if (!options.url_file.empty())
        if (auto made = check_folder_of(options.url_file, "--url-file", true); !made)
            return made;
    if (!options.state.empty())
        if (auto kept = check_writable(options.state, "--state"); !kept)
            return kept;
    warn_of_shared_store(server.store_root);
    if (const auto store = check_writable(server.store_root, "--store"); !store)
        spdlog::warn(
            "event=store_read_only message=\"the folder for imported data cannot be "
            "written: only data that were imported before can be served\" hint=\"give it to "
            "user {}, or name another with --store\"",
            ::geteuid());
    return {};
}

/// Returns the command that starts wakesurf-bricks. Error: InvalidArgument; Unsupported if there is no such
/// program.
core::Result<std::vector<std::string>> brick_words(const std::string& text) {
    std::error_code ignored;
    if (!std::filesystem::exists(this_program().parent_path() / "wakesurf-bricks", ignored))
        return fail(Error::Code::Unsupported,
                    "--bricks: wakesurf-bricks was not found next to this program",
                    "install the package wakesurf-bricks, or build with -DWAKESURF_MPI=ON");
    return program_words(text).map_error([](Error error) {
        error.message = "--bricks: " + error.message;
        return error;
    });
}

/// Checks the options. Error: InvalidArgument for wrong usage; anything else for a file or folder that cannot
/// be used.
core::Result<Prepared> prepare(const ServeOptions& options) {
    const auto address = parse_address(options.listen);
    if (!address)
        return tl::unexpected(address.error());
    if (auto origins = check_origins(options.origins, "--origin"); !origins)
        return tl::unexpected(origins.error());
    if (auto origins = check_origins(options.frame_origins, "--frame-origin"); !origins)
        return tl::unexpected(origins.error());
    Prepared out;
    ServerOptions& server = out.server;
    server.store_root =
        options.store.empty() ? default_store_root() : std::filesystem::path(options.store);
    if (auto folders = check_folders(options, server); !folders)
        return tl::unexpected(folders.error());
    auto proxies = TrustedProxies::parse(options.trusted_proxies);
    if (!proxies)
        return tl::unexpected(proxies.error());
    const auto token = choose_token(options, *address, out.token_file);
    if (!token)
        return tl::unexpected(token.error());
    server.datasets = datasets_to_serve(options);
    server.taken = options.taken;
    server.host = address->host;
    server.port = options.port_by_chance ? free_port(*address) : address->port;
    server.state = options.state;
    server.memory = options.memory;
    server.threads = options.threads;
    if (!options.bricks.empty()) {
        auto words = brick_words(options.bricks);
        if (!words)
            return tl::unexpected(words.error());
        server.brick_words = std::move(*words);
        server.brick_memory = options.brick_memory;
    }
    server.token = *token;
    server.origins = options.origins;
    server.frame_origins = options.frame_origins;
    server.proxies = std::move(*proxies);
    server.certificate = options.certificate;
    server.key = options.key;
    server.web = options.web;
    for (const auto& own : {options.token_file, options.url_file})
        if (!own.empty())
            server.secrets.emplace_back(own);
    return out;
}

std::string link_of(const std::string& address, const std::string& token) {
    return address + (token.empty() ? "" : "#token=" + token);
}

/// Writes the link to the file, if there is one, and then without the token to standard output.
core::Result<void>
tell_link(const std::string& address, const std::string& token, const std::filesystem::path& file) {
    const std::string link = link_of(address, token);
    if (!file.empty())
        if (auto written = write_private_file(file, link + "\n"); !written)
            return fail(Error::Code::Io, "--url-file: " + written.error().message,
                        written.error().hint);
    const std::string line = "wakesurf: " + (file.empty() ? link : address) + "\n";
    if (std::fputs(line.c_str(), stdout) == EOF || std::fflush(stdout) != 0)
        spdlog::warn("event=link_not_told message=\"the link cannot be written to standard "
                     "output\" hint=\"give "
                     "--url-file FILE and read the link there\"");
    return {};
}

/// Changes the token only once the server listens.
core::Result<void> keep_new_token(Server& server, TokenFile& file) {
    if (auto kept = file.keep(); !kept)
        return kept;
    spdlog::info(
        "event=new_token links_ended={} message=\"the links and logins that were made with "
        "the old token have ended\"",
        server.end_links());
    return {};
}

/// Opens the page, or prints how to reach it. A failure here is no failure of the server: the link has been
/// printed.
std::optional<OpenedPage>
open_page(const std::string& link, const std::string& host, std::uint16_t port, bool has_page) {
    if (const auto tunnel = tunnel_command(host, port))
        tell("wakesurf: to open the link on your own machine, type this there first: {}\n",
             *tunnel);
    auto page = has_page
                    ? OpenedPage::open(link)
                    : core::Result<OpenedPage>(fail(Error::Code::NotFound,
                                                    "the page was not found next to this program",
                                                    "give its folder with --web"));
    if (page) {
        tell("wakesurf: opening the page in your browser; if it does not appear, open the link "
             "(--no-open prevents this)\n");
        std::fflush(stdout);
        return std::move(*page);
    }
    std::fflush(stdout);
    spdlog::info("event=page_not_opened message=\"{}\" hint=\"{}\"", page.error().message,
                 page.error().hint);
    return std::nullopt;
}

core::Result<void> serve(Prepared& prepared, const ServeOptions& asked) {
    const ServerOptions& options = prepared.server;
    const std::filesystem::path url_file = asked.url_file;
    std::error_code ignored;
    if (!url_file
             .empty()) // a reader that waits for the link must not get that of an earlier server
        std::filesystem::remove(url_file, ignored);
    auto running = Server::open(options);
    if (!running)
        return tl::unexpected(running.error());
    if (asked.new_token)
        if (auto kept = keep_new_token(**running, *prepared.token_file); !kept)
            return kept;
    const bool tls = !options.certificate.empty();
    const std::string host = shown_host(options.host);
    const std::string address =
        fmt::format("{}://{}:{}/", tls ? "https" : "http", host, (*running)->port());
    if (auto told = tell_link(address, options.token, url_file); !told)
        return told;
    const bool has_page = !options.web.empty() || !find_web_client().empty();
    const auto page =
        asked.open ? open_page(link_of(address, options.token), host, (*running)->port(), has_page)
                   : std::nullopt;
    if (!tls && in_container()) // the port may be published under any number
        spdlog::info("event=no_tls message=\"this port speaks plain HTTP\" hint=\"publish it on "
                     "127.0.0.1 only, or put TLS in front of it\"");
    else if (!tls && !is_loopback(options.host))
        spdlog::warn(
            "event=no_tls message=\"anyone on the network path can read the token and the data\" "
            "hint=\"give --tls-cert and --tls-key\"");
    (*running)->run();
    // A second signal must not interrupt the clean-up, which removes the page with the token.
    for (const int each : {SIGINT, SIGTERM, SIGHUP})
        std::signal(each, SIG_IGN);
    return {};
}

} // namespace

void add_serve_options(CLI::App& command, ServeOptions& options) {
    options.listen = from_environment("WAKESURF_LISTEN", options.listen);
    options.state = from_environment("WAKESURF_STATE");
    options.token_file = from_environment("WAKESURF_TOKEN_FILE");
    command.add_option("DATASET", options.datasets,
                       "files or folders VTK can read, stores, Zarrs or the https:// addresses of "
                       "either, or flow:NAME[?k=v,...] (default: "
                       "$WAKESURF_DATASET, or the bundled simulation)");
    command
        .add_option("--listen", options.listen,
                    "address to listen on, HOST:PORT; port 0 picks a free one; $WAKESURF_LISTEN "
                    "also sets it")
        ->capture_default_str();
    command.add_option("--store", options.store,
                       "folder for imported data (default: $WAKESURF_STORE, or ~/.cache/wakesurf)");
    command::add_source_options(command, options.taken);
    command.add_option(
        "--state", options.state,
        "folder for sessions (default: $WAKESURF_STATE; without one, sessions end with "
        "the server)");
    command
        .add_option(
            "--memory", options.memory,
            "memory for the whole server and its importers, for example 4GiB (default: 60 % "
            "of the memory of the machine or control group)")
        ->transform(command::as_memory_size());
    command
        .add_option("--threads", options.threads,
                    "number of compute threads (default: one per core)")
        ->check(CLI::Range(1, 1024));
    auto* const bricks = command.add_option(
        "--bricks", options.bricks,
        "hold the bricks of time-steps that are larger than memory in the memory of an MPI job, "
        "which these words start: \"mpirun -n 4\"");
    command
        .add_option("--bricks-memory", options.brick_memory,
                    "memory of each rank for bricks, for example 64GiB (default: a quarter of its "
                    "node's memory, shared by the ranks there)")
        ->transform(command::as_memory_size())
        ->needs(bricks);
    auto* const file =
        command.add_option("--token-file", options.token_file,
                           "take the token from this file, which is created if missing "
                           "(default: $WAKESURF_TOKEN_FILE, or a new token)");
    command.add_flag("--new-token", options.new_token,
                     "put a new token into the token file: all share links, and all logins, end");
    command
        .add_flag("--no-auth", options.no_auth,
                  "ask for no token; allowed only on a loopback address")
        ->excludes(file);
    command.add_option("--url-file", options.url_file,
                       "write the link with the token to this file, which only its owner can read, "
                       "instead of to standard output: for batch jobs, whose logs others can read");
    command.add_option("--origin", options.origins,
                       "another page origin that may connect, written exactly as in the browser");
    command.add_option("--frame-origin", options.frame_origins,
                       "an origin whose pages may show this one in a frame, as "
                       "https://wiki.example (default: no page may)");
    command.add_option(
        "--trusted-proxy", options.trusted_proxies,
        "ADDR or ADDR/BITS: trust this proxy's client addresses (X-Forwarded-For, PROXY protocol)");
    auto* const certificate = command.add_option("--tls-cert", options.certificate,
                                                 "enable TLS with this PEM certificate chain");
    auto* const key = command.add_option("--tls-key", options.key, "PEM key of the certificate");
    certificate->needs(key);
    key->needs(certificate);
    command.add_flag("--open,!--no-open", options.open,
                     "open the page in the browser of this display (`wakesurf DATASET`, without "
                     "`serve`, does it unless --no-open says not to)");
    command.add_option("--web", options.web, "folder of the built web client")
        ->check(CLI::ExistingDirectory);
    command.add_option("--log-level", options.log_level, "what to log on standard error")
        ->check(CLI::IsMember({"trace", "debug", "info", "warn", "error", "off"}))
        ->capture_default_str();
}

int run_serve(const ServeOptions& options) {
    log_to_standard_error(options.log_level);
    std::signal(SIGXFSZ, SIG_IGN); // a limit on the size of files becomes an error of the write
    std::signal(SIGPIPE, SIG_IGN); // so does a closed reader
    auto prepared = prepare(options);
    if (!prepared)
        return report_refusal(prepared.error());
    const auto served = serve(*prepared, options);
    return served ? 0 : report_failure(served.error());
}

} // namespace wakesurf::server
