// Whole meshes over HTTP: a surface as a file for other programs, a dataset's obstacle, and its values on a plane.
#pragma once

#include "core/base/memory_account.hpp"
#include "server/base/identity.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "server/net/animation_downloads.hpp"
#include "server/net/field_downloads.hpp"
#include "server/net/http_message.hpp"
#include "server/net/number_downloads.hpp"
#include "server/net/shared_files.hpp"
#include "server/sessions/session_directory.hpp"

#include <string>

namespace wakesurf::server {

/// Serves downloads. Loop thread only; the pool does the work, in turn with the surfaces on display, and once
/// for all clients that ask for the same.
class Downloads {
  public:
    /// REQUIRES: all arguments but the last outlive this. @param viewer  of animations; null: there is none
    Downloads(Loop& loop,
              ComputePool& pool,
              const SessionDirectory& sessions,
              const DatasetCatalogue& catalogue,
              const core::MemoryAccount& account,
              File viewer);
    Downloads(const Downloads&) = delete;
    Downloads& operator=(const Downloads&) = delete;

    /// Handles a path below /api/v1/. Returns false for any other.
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
    /// Says whether the dataset was imported again and its values differ.
    bool replaced(const LoadedDataset& data) const;
    void obstacle(const HttpRequest& request,
                  const Identity& identity,
                  const std::string& dataset,
                  const std::string& name,
                  const Respond& respond);

    const SessionDirectory& sessions_;
    const DatasetCatalogue& catalogue_;
    core::MemoryAccount account_;
    SharedFiles files_;
    NumberDownloads numbers_;
    AnimationDownloads animations_;
    FieldDownloads fields_;
};

} // namespace wakesurf::server
