// Whole meshes over HTTP: a surface as a file for other programs, and a dataset's obstacle for the page.
#pragma once

#include "core/base/memory_account.hpp"
#include "server/net/http_message.hpp"
#include "server/net/shared_files.hpp"
#include "server/service/base/identity.hpp"
#include "server/service/catalogue/dataset_catalogue.hpp"
#include "server/service/session/session_directory.hpp"

#include <string>

namespace wakesurf::server {

/// Loop thread only; the work is done in the pool, in turn with what is computed to be looked at, once for all who ask for the same.
class Downloads {
  public:
    /// All outlive it.
    Downloads(Loop& loop,
              ComputePool& pool,
              const SessionDirectory& sessions,
              const DatasetCatalogue& catalogue,
              const core::MemoryAccount& account);
    Downloads(const Downloads&) = delete;
    Downloads& operator=(const Downloads&) = delete;

    /// A path below /api/v1/. False: no such path.
    bool handle(const HttpRequest& request, const Identity& identity, const Respond& respond);

  private:
    struct Place {
        std::string session, surface, file;
    };

    void surface(const HttpRequest& request,
                 const Identity& identity,
                 const Place& place,
                 const Respond& respond);
    core::Result<void> offer(const HttpRequest& request,
                             const Identity& identity,
                             const Place& place,
                             const Respond& respond);
    /// The dataset's values are others by now.
    bool replaced(const LoadedDataset& data) const;
    void obstacle(const HttpRequest& request,
                  const Identity& identity,
                  const std::string& dataset,
                  const Respond& respond);

    const SessionDirectory& sessions_;
    const DatasetCatalogue& catalogue_;
    core::MemoryAccount account_;
    SharedFiles files_;
};

} // namespace wakesurf::server
