// Where the sessions are that `wakesurf sessions` is about: on a server that runs, or in a state folder that none uses. Both
// answer the same requests.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <memory>
#include <string>

namespace wakesurf::server {

/// One thread at a time; every call waits for its answer.
class SessionServer {
  public:
    struct Answer {
        unsigned status = 200; ///< of HTTP
        std::string body;
    };

    virtual ~SessionServer() = default;

    /// As over HTTP. Error: Io.
    virtual core::Result<Answer>
    ask(const std::string& method, const std::string& path, const std::string& body) = 0;
};

/// A server at the address it printed, with `#token=...`. @param authority  PEM file of who signed its certificate; empty: whom the
/// system trusts. Error: InvalidArgument.
core::Result<std::unique_ptr<SessionServer>> server_at(const std::string& url,
                                                       const std::filesystem::path& authority);

/// What a server would be that is started with this state folder and no data. Its destructor waits for the disk. Error: as
/// KeptSessions::open; OverLimit where a server uses the folder; NotFound where there are no sessions in it.
/// @param changes  false: nothing is written
core::Result<std::unique_ptr<SessionServer>> sessions_in(const std::filesystem::path& folder,
                                                         bool changes);

} // namespace wakesurf::server
