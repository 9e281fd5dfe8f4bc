// Sessions as files over HTTP: session.json out and in, of any size, and the picture of a session.
#pragma once

#include "server/base/identity.hpp"
#include "server/base/journal.hpp"
#include "server/base/loop.hpp"
#include "server/data/datasets.hpp"
#include "server/live/compute/compute_pool.hpp"
#include "server/net/http_message.hpp"
#include "server/sessions/session_directory.hpp"

#include <cstddef>

namespace wakesurf::server {

/// Serves session files. Loop thread only; the pool writes and reads JSON.
class SessionFiles {
  public:
    /// REQUIRES: all arguments outlive this. @param journal  null: sessions are not kept
    SessionFiles(Loop& loop,
                 ComputePool& pool,
                 SessionDirectory& sessions,
                 const Datasets& datasets,
                 Journal* journal);

    /// The path that documents are posted to: their bodies may be longer than messages, if they come with the
    /// server's own token.
    static constexpr const char* import_path = "/api/v1/sessions";

    /// Handles a path; returns false for any other.
    bool get(const HttpRequest& request, const Respond& respond);

    /// Imports a document that was posted to import_path.
    void post(const HttpRequest& request, const Identity& identity, const Respond& respond);

  private:
    void send_file(const Session& session, const Respond& respond);

    Loop& loop_;
    ComputePool& pool_;
    SessionDirectory& sessions_;
    const Datasets& datasets_;
    Journal* journal_;
    std::size_t imports_ = 0; ///< under way
};

} // namespace wakesurf::server
