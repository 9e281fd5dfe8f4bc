// One epoch of a surface being built, on compute threads: its passes, and the state kept between them so that
// a moving surface continues from where it is. Touches nothing shared.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/work_done.hpp"
#include "core/surface/playback/growing_mesh.hpp"
#include "core/surface/playback/played_surface.hpp"
#include "core/surface/request/surface_plan.hpp"
#include "core/surface/surface.hpp"
#include "protocol/wire/mesh_stream.hpp"
#include "server/live/compute/history_budget.hpp"
#include "server/live/surface_job.hpp"
#include "server/live/update_ring.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>

namespace wakesurf::server {

/// The plan of an early pass: the same surface, coarser, so that there is something to see at once.
/// Returns the plan of an early pass. The engine's quad budget bounds the work for any separation. A path
/// surface is built whole, for any time of the pass; the others end at that time. REQUIRES: the pass is
/// coarse or refined.
core::SurfacePlan early_plan(core::SurfacePlan plan, const SurfacePass& pass);

/// Refers to the accounts of a build's memory, which outlive it; null: not counted.
struct BuildMemory {
    const core::MemoryAccount* account = nullptr;
    const HistoryBudget* histories = nullptr; ///< to step back; of its own without
};

/// Builds a surface. One pass at a time, on any thread.
class SurfaceBuild {
  public:
    using Memory = BuildMemory;

    /// @param clock      outlives it
    /// @param first_seq  of its updates: above those of another build of the same epoch
    SurfaceBuild(SurfaceJob job,
                 const core::Clock& clock,
                 const Memory& memory = {},
                 std::uint32_t first_seq = 0);

    /// Builds and encodes. Never throws. Once it has begun to encode it returns the update even if `stop` has
    /// fired: the next one is based on it. Error: Cancelled; OverLimit out of memory; as the engine and the
    /// encoder.
    /// @param work  receives the progress of the pass; may be null
    core::Result<Update> run(const SurfacePass& pass,
                             const std::stop_token& stop,
                             core::WorkDone* work = nullptr) noexcept;

    const SurfaceJob& job() const { return job_; }

    /// Takes the flow and the store of a job of the same data, perhaps opened again. Frees what was made from
    /// others: not for the network thread.
    void renew_data(const SurfaceJob& job);

  private:
    /// Names the origin of a mesh: ids are stable within one.
    enum class Source { Nothing, Whole, Grown, Played };

    struct Shown {
        core::KeyedMesh mesh;
        core::SurfaceStatistics statistics;
        Source source;
        protocol::MeshFields fields;
        double load; ///< the time this pass waited for time-steps, in s
        /// As in core::Surface.
        std::optional<double> ended{};
    };

    using Work = core::WorkPart;

    core::Result<Update>
    run_counted(const SurfacePass& pass, const std::stop_token& stop, const Work& work);
    core::Result<Shown>
    build(const SurfacePass& pass, const std::stop_token& stop, const Work& work);
    core::Result<Shown>
    build_early(const SurfacePass& pass, const std::stop_token& stop, const Work& work) const;
    core::Result<Shown> build_whole(const std::stop_token& stop, const Work& work) const;
    std::size_t sampling_memory(std::size_t vertices) const;
    core::Result<protocol::MeshFields> fields_of(const core::Surface& surface,
                                                 const core::SurfaceParameters& parameters,
                                                 const std::stop_token& stop,
                                                 const Work& work) const;
    core::Result<Shown> level(double age, const std::stop_token& stop, const Work& work) const;
    core::Result<Shown> grow(double age, const std::stop_token& stop, const Work& work);
    core::Result<Shown> play(double age, const std::stop_token& stop, const Work& work);
    core::Result<Shown>
    play_within(std::size_t bytes, double age, const std::stop_token& stop, const Work& work);
    core::Result<Update>
    check_state(const SurfacePass& pass, const std::stop_token& stop, const Work& work);
    bool announce_checks(Shown& shown, const SurfacePass& pass) const;
    std::size_t shrink_history(std::size_t bytes);
    core::Result<Update> encode(Shown& shown, const SurfacePass& pass);

    SurfaceJob job_;
    const core::Clock& clock_;
    const core::MemoryAccount* account_;
    const HistoryBudget* histories_;
    core::MemoryAccount::Share kept_; ///< between passes, but for `played_`
    protocol::MeshStream stream_;
    Source last_ = Source::Nothing;
    std::optional<Shown> unstated_; ///< its error between stored times is to be estimated
    std::optional<core::GrowingMesh> grown_;
    core::SurfaceStatistics grown_statistics_;
    std::optional<core::PlayedSurface> played_; ///< while not in use, others may shrink or end it
    double played_load_ = 0.0; ///< the time it has waited for time-steps so far, in s
    std::unique_ptr<HistoryBudget::Permit> permit_; ///< of `played_`, once there was one
};

} // namespace wakesurf::server
