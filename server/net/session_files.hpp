// Sessions as files over HTTP: session.json out and in, of any size, and the picture of a session.
#pragma once

#include "server/net/http_message.hpp"
#include "server/service/base/identity.hpp"
#include "server/service/base/journal.hpp"
#include "server/service/base/loop.hpp"
#include "server/service/compute/compute_pool.hpp"
#include "server/service/session/data/datasets.hpp"
#include "server/service/session/session_directory.hpp"

#include <cstddef>

namespace wakesurf::server {

/// Loop thread only; JSON is written and read in the pool.
class SessionFiles {
  public:
    /// All outlive it. @param journal  null: nothing is kept
    SessionFiles(Loop& loop,
                 ComputePool& pool,
                 SessionDirectory& sessions,
                 const Datasets& datasets,
                 Journal* journal);

    /// Where documents are posted: their bodies may be longer than messages, if they come with the server's own token.
    static constexpr const char* import_path = "/api/v1/sessions";

    /// False: no such path.
    bool get(const HttpRequest& request, const Respond& respond);

    /// A document, posted to import_path.
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
