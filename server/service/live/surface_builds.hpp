// The surfaces of a session as they are computed: one live surface for each surface record, built against the rakes and
// datasets as they are now.
#pragma once

#include "core/base/result.hpp"
#include "server/service/base/session_services.hpp"
#include "server/service/live/live_surface.hpp"
#include "server/service/session/records/session_records.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// Loop thread only.
class SurfaceBuilds {
  public:
    struct Events {
        std::function<void(const SurfaceProgress&)> progress;
        std::function<void(const SurfaceOutcome&)> done;
        std::function<void(const SurfaceRanges&)> ranges;
        /// Begun without an edit, because data came.
        std::function<void(const std::string& surface, std::uint32_t epoch)> rebuilt;
    };

    /// `records` are the session's and outlive this. `next_number` counts the server's surfaces.
    SurfaceBuilds(std::string session,
                  const SessionServices& services,
                  const SessionRecords& records,
                  std::uint32_t& next_number,
                  Events events);
    /// Retires them all.
    ~SurfaceBuilds();
    SurfaceBuilds(const SurfaceBuilds&) = delete;
    SurfaceBuilds& operator=(const SurfaceBuilds&) = delete;

    /// What building a surface of these parameters is; its rakes are among the records. Error: of the dataset, and as
    /// core::plan_surface.
    core::Result<SurfaceJob> job_for(const protocol::SurfaceRecord& record) const;

    /// Begins a build and returns its epoch, which is above the record's.
    /// @param job  of the record
    std::uint32_t build(const protocol::SurfaceRecord& record, SurfaceJob job);

    /// The same of a record that nothing is known of yet. Where there is nothing to build now, the outcome
    /// says why, and it is tried again when data come.
    /// @param rest  it is restored: see LiveSurface::rebuild
    std::uint32_t build(const protocol::SurfaceRecord& record, bool rest = false);

    /// The same for a surface whose rake moved; nothing where it cannot be built any more: it stays what it is.
    std::optional<std::uint32_t> rebuild(const protocol::SurfaceRecord& record);

    void retire(const std::string& surface);

    /// Calls visit(LiveSurface&) for each.
    template <class Visit>
    void for_each(const Visit& visit) const {
        for (const auto& [id, entry] : entries_)
            visit(*entry.live);
    }

    /// Null where there is none.
    std::shared_ptr<LiveSurface> find(const std::string& surface) const;

    /// The session's clock: moving surfaces are shown as they are then. See LiveSurface::show.
    void show(std::optional<double> time, bool playing, bool jumped);

    /// From the first time at which one of the moving surfaces is shown to the last; nothing without any.
    std::optional<std::array<double, 2>> moving_range() const;

    /// Whether the clock may show `time`: within the times of the data of the surfaces, or of a surface, which may reach further. Any where
    /// there is no surface, or one of data that are there at all times. Error: OutOfTime, with `name` for the time.
    core::Result<void> check_time(const char* name, double time) const;

    /// Builds what ended early for want of time-steps again, as soon as it is not being built already; lets go of a
    /// dataset that has become a longer one. Where its values are others now, everything of it is built anew at once, also what is being
    /// built or rests: then true.
    bool dataset_changed(const std::string& dataset);

  private:
    struct Entry {
        std::shared_ptr<LiveSurface> live;
        bool data_came = false; ///< since the present build began
        bool withheld = false;  ///< it is not computed until somebody sets it
    };

    LiveSurface& live_for(const protocol::SurfaceRecord& record);
    void built(const SurfaceOutcome& outcome);
    void try_again(const std::string& surface, LiveSurface& live);
    enum class Data { Same, Other, ComingAgain };
    Data compare_data(const std::string& dataset, const LiveSurface& live) const;
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
