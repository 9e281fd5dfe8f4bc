// The sessions that `wakesurf sessions` works on: of a running server, or in a state folder that no server
// uses. Both answer the same requests.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace wakesurf::server {

/// The address a server prints: where it listens, and its token.
struct ServerAddress {
    bool tls = false;
    std::string host; ///< without the brackets of an IPv6 address
    std::string port;
    std::string prefix; ///< of a proxy, as /flow; may be empty
    std::string token;  ///< may be empty

    /// Returns the authority as a Host header has it.
    std::string authority() const;
};

/// Parses http://HOST[:PORT][/PREFIX][/][#token=...]. Error: InvalidArgument.
core::Result<ServerAddress> parse_server_address(const std::string& url);

/// Answers requests. One thread at a time; every call waits for its answer.
class SessionServer {
  public:
    struct Answer {
        unsigned status = 200; ///< of HTTP
        std::string body;
    };

    virtual ~SessionServer() = default;

    /// Sends a request as over HTTP. Error: Io.
    virtual core::Result<Answer>
    ask(const std::string& method, const std::string& path, const std::string& body) = 0;
};

/// Connects to a server by the address that it printed, with `#token=...`. Error: InvalidArgument.
/// @param authority  PEM file of the certificate's issuer; empty: those that the system trusts.
core::Result<std::unique_ptr<SessionServer>> server_at(const std::string& url,
                                                       const std::filesystem::path& authority);

/// Opens a state folder like a server without data. Its destructor waits for the disk. Error: as
/// StoredSessions::open; OverLimit if a server uses the folder; NotFound if there are no sessions in it.
/// @param changes  false: nothing is written
core::Result<std::unique_ptr<SessionServer>> sessions_in(const std::filesystem::path& folder,
                                                         bool changes);

} // namespace wakesurf::server
