// A session: the rakes and surfaces several people look at and edit together. Edits are whole records, last writer
// wins; each bumps seq and is told to every participant. Knows neither sockets nor JSON text.
#pragma once

#include "core/base/result.hpp"
#include "server/metrics/metrics.hpp"
#include "server/session/datasets.hpp"
#include "server/session/live_surface.hpp"
#include "server/session/observer.hpp"
#include "server/session/participants.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// What sessions need of the server. All outlive them.
struct SessionServices {
    Loop& loop;
    ComputePool& pool;
    const Datasets& datasets;
    Entropy& entropy;
    Metrics* metrics = nullptr; ///< nobody counts without
};

struct RakeChange {
    protocol::RakeRecord record;
    std::vector<std::pair<std::string, std::uint32_t>>
        surfaces; ///< recomputed, with their new epochs
};

/// Loop thread only.
class Session {
  public:
    Session(std::string id, std::string name, SessionServices services, std::uint32_t& next_number);
    /// Retires its surfaces.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    const std::string& id() const { return id_; }

    const std::string& name() const { return name_; }

    std::uint64_t seq() const { return seq_; }

    Participants& participants() { return participants_; }

    std::vector<protocol::RakeRecord> rakes() const;
    std::vector<protocol::SurfaceRecord> surfaces() const;

    /// Error: NotFound.
    core::Result<protocol::RakeRecord> rake(const std::string& id) const;
    core::Result<protocol::SurfaceRecord> surface(const std::string& id) const;
    core::Result<std::shared_ptr<LiveSurface>> live(const std::string& id) const;

    /// Creates or replaces a rake and rebuilds the surfaces that hang on it, as rake or as rake2. Error: NotFound, OverLimit,
    /// InvalidArgument, OutOfDomain by how much; nothing has changed then.
    core::Result<RakeChange> set_rake(const protocol::RakeSetting& setting);

    /// Deletes the surfaces that hang on it as well.
    core::Result<void> delete_rake(const std::string& id);

    /// Creates or replaces a surface and starts building it. Error: NotFound (surface, rake, dataset), Unsupported
    /// (kind), OutOfTime, OutOfDomain, InvalidArgument, OverLimit.
    core::Result<protocol::SurfaceRecord> set_surface(const protocol::SurfaceSetting& setting);
    core::Result<void> delete_surface(const std::string& id);

    /// Builds what ended early for want of time-steps again, as soon as it is not being built already; lets go of a dataset that was
    /// replaced by a longer one.
    void dataset_changed(const std::string& dataset);

  private:
    struct SurfaceEntry {
        protocol::SurfaceRecord record;
        std::shared_ptr<LiveSurface> live;
        bool data_came = false; ///< since the present build began
    };

    core::Result<core::ClippedRake> clip(const protocol::RakeSetting& setting) const;
    core::Result<core::ClippedRake> clip_to(const core::Rake& shape,
                                            const std::string& dataset) const;
    core::Result<SurfaceJob> job_for(const protocol::SurfaceRecord& record) const;
    std::shared_ptr<LiveSurface> make_live(const std::string& id);
    void built(const SurfaceOutcome& outcome);
    void try_again(SurfaceEntry& entry);
    void announce(const std::vector<Patch>& patches);

    std::string id_;
    std::string name_;
    SessionServices services_;
    std::uint32_t& next_number_;
    std::uint64_t seq_ = 0;
    std::uint64_t next_rake_ = 1;
    std::uint64_t next_surface_ = 1;
    std::map<std::string, protocol::RakeRecord> rakes_;
    std::map<std::string, SurfaceEntry> surfaces_;
    Participants participants_;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true); ///< for what is posted to the loop
};

} // namespace wakesurf::server
