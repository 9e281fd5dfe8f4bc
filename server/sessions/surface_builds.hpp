// The computed surfaces of a session: one live surface for each surface record, built against the present
// rakes and datasets.
#pragma once

#include "core/base/result.hpp"
#include "server/base/session_services.hpp"
#include "server/live/live_surface.hpp"
#include "server/sessions/records/session_records.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Builds the surfaces. Loop thread only.
class SurfaceBuilds {
  public:
    struct Events {
        std::function<void(const SurfaceProgress&)> progress;
        std::function<void(const SurfaceOutcome&)> done;
        std::function<void(const SurfaceRanges&)> ranges;
        /// Called for a build without an edit, because data came.
        std::function<void(const std::string& surface, std::uint32_t epoch)> rebuilt;
    };

    /// `records` are the session's and outlive this. `next_number` counts the server's surfaces.
    SurfaceBuilds(std::string session,
                  const SessionServices& services,
                  const SessionRecords& records,
                  std::uint32_t& next_number,
                  Events events);
    /// Retires all surfaces.
    ~SurfaceBuilds();
    SurfaceBuilds(const SurfaceBuilds&) = delete;
    SurfaceBuilds& operator=(const SurfaceBuilds&) = delete;

    /// Returns the job for a surface of these parameters; its rakes are among the records. Error: of the
    /// dataset, and as core::plan_surface.
    core::Result<SurfaceJob> job_for(const protocol::SurfaceRecord& record) const;

    /// Begins a build and returns its epoch, which is above the record's.
    /// @param job  of the record
    std::uint32_t build(const protocol::SurfaceRecord& record, SurfaceJob job);

    /// Begins a build of a new record. If it cannot be built now, the outcome says why, and it is tried again
    /// when data come.
    /// @param rest  it is restored: see LiveSurface::rebuild
    std::uint32_t build(const protocol::SurfaceRecord& record, bool rest = false);

    /// Begins a build of a surface whose rake moved; empty if it cannot be built any more: it stays as it is.
    std::optional<std::uint32_t> rebuild(const protocol::SurfaceRecord& record);

    void retire(const std::string& surface);

    /// Calls visit(LiveSurface&) for each.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const auto& [id, entry] : entries_)
            visit(*entry.live);
    }

    /// Returns null if there is none.
    std::shared_ptr<LiveSurface> find(const std::string& surface) const;

    /// Shows moving surfaces at a time of the session's clock. See LiveSurface::show.
    void show(std::optional<double> time, bool playing, bool jumped);

    /// Returns the first and the last time at which a moving surface is shown; empty without any.
    std::optional<std::array<double, 2>> moving_range() const;

    /// Checks that the clock may show `time`: within the times of the data of the surfaces, or of a surface,
    /// which may reach further. Any time is valid without surfaces, or with data at all times. Error:
    /// OutOfTime, with `name` for the time.
    core::Result<void> check_time(const char* name, double time) const;

    /// Rebuilds, unless they are being built, the surfaces that ended early for missing time-steps, and
    /// releases a dataset that has been replaced by a longer one. If its values have changed, rebuilds all
    /// its surfaces at once, suspended ones and those being built included, and returns true.
    bool dataset_changed(const std::string& dataset);

  private:
    struct Entry {
        std::shared_ptr<LiveSurface> live;
        bool data_came = false; ///< since the present build began
        bool withheld = false;  ///< it is not computed until a user sets it
    };

    void
    add_twin(SurfaceJob& job, const protocol::Twin& twin, const OpenDataset& surface_data) const;
    LiveSurface& live_for(const protocol::SurfaceRecord& record);
    void built(const SurfaceOutcome& outcome);
    void try_again(const std::string& surface, LiveSurface& live);
    enum class Data { Same, Other, ComingAgain };
    Data compare_data(const std::string& dataset, const LiveSurface& live) const;
    bool twin_changed(const protocol::SurfaceRecord& record, const LiveSurface& live) const;
    void build_anew(const protocol::SurfaceRecord& record, Entry& entry);

    std::string session_;
    SessionServices services_;
    const SessionRecords& records_;
    std::uint32_t& next_number_;
    Events events_;
    std::map<std::string, Entry> entries_;
    std::optional<double> time_; ///< of the session's clock
    bool playing_ = false;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true); ///< for what is posted to the loop
};

} // namespace wakesurf::server
