// The whole service: connects the catalogue, sessions, methods and the network, and runs them on one thread.
#pragma once

#include "core/base/result.hpp"
#include "server/net/trusted_proxies.hpp"
#include "store/command/source_options.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server {

struct ServerOptions {
    std::vector<std::string> datasets;
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080; ///< 0: any free one
    std::filesystem::path store_root;
    command::SourceOptions taken; ///< how the datasets' files are taken
    std::filesystem::path state;  ///< folder sessions are kept in; empty: they end with the server
    /// The memory of the process and its importers, in bytes; 0: by the machine and the control group.
    std::size_t memory = 0;
    unsigned threads = 0; ///< that compute; 0: one a core
    std::string token;    ///< empty: no authentication
    std::vector<std::string> origins;
    std::vector<std::string> frame_origins; ///< pages of these may show ours in a frame
    TrustedProxies proxies;
    std::filesystem::path certificate;    ///< empty: plain HTTP
    std::filesystem::path key;            ///< the certificate's
    std::vector<std::string> brick_words; ///< start wakesurf-bricks; empty: it is not started
    std::size_t brick_memory = 0;         ///< of each of its ranks; 0: what it needs
    std::vector<std::filesystem::path>
        secrets;               ///< files that no dataset may name, beside `state` and `key`
    std::filesystem::path web; ///< the built client; empty: where it was built or installed
};

class Server {
  public:
    /// Opens the datasets, restores sessions and listens. Error: of the datasets, the sessions and the
    /// address.
    static core::Result<std::unique_ptr<Server>> open(const ServerOptions& options);
    ~Server();
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    std::uint16_t port() const;

    /// Ends all share links, with the clients that came by them; returns their number.
    std::size_t end_links();

    /// Serves until SIGINT or SIGTERM, or SIGHUP without TLS, then says goodbye to the clients; this takes at
    /// most a second.
    void run();

  private:
    struct Inputs;
    struct Parts;
    explicit Server(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

} // namespace wakesurf::server
