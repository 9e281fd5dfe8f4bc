#include "server/live/surface_build.hpp"

#include "core/surface/builder/interval_errors.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/builder/twin.hpp"
#include "core/surface/level/level_surface.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "core/surface/surface.hpp"
#include "core/surface/time_direction.hpp"
#include "server/base/limits.hpp"
#include "server/base/log_text.hpp"
#include "server/live/announced_ranges.hpp"
#include "server/live/surface_file.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace wakesurf::server {

core::SurfacePlan early_plan(core::SurfacePlan plan, const SurfacePass& pass) {
    core::SurfaceParameters& p = plan.parameters;
    plan.rake.seeds = std::min(
        plan.rake.seeds, static_cast<std::uint32_t>(std::sqrt(static_cast<double>(pass.quads))));
    p.max_quads = std::min(p.max_quads, pass.quads);
    p.accuracy = core::Accuracy::Fast;
    if (pass.phase == Phase::Coarse)
        p.separation *= 2.0;
    p.separation = std::max(p.separation, pass.separation);
    const double age = core::age_at(p, pass.time);
    const bool moving = p.kind == core::SurfaceKind::Streak || p.kind == core::SurfaceKind::Time;
    if (moving && pass.time && age > 0.0) {
        if (p.release_until && std::abs(*p.release_until - p.from) > age)
            p.release_until.reset();
        p.to = p.from + std::copysign(age, p.to - p.from);
    }
    return plan;
}

namespace {

// The memory for encoding a mesh, in bytes a vertex and field.
constexpr std::size_t encoding_field_bytes = 40;
// The memory for sampling fields, in bytes a vertex: its place and time, the gradients there, and each field.
constexpr std::size_t sampling_bytes = 40, gradient_bytes = 160, sample_bytes = 8;

// The wait for others to release memory. Early passes block threads that others wait for, and a whole pass
// follows.
constexpr std::chrono::milliseconds patience{1000};
constexpr std::chrono::milliseconds little_patience{20};

tl::unexpected<core::Error> cancelled() {
    return core::fail(core::Error::Code::Cancelled, "a newer edit replaced this surface");
}

} // namespace

SurfaceBuild::SurfaceBuild(SurfaceJob job,
                           const core::Clock& clock,
                           const Memory& memory,
                           std::uint32_t first_seq)
    : job_(std::move(job)), clock_(clock), account_(memory.account), histories_(memory.histories),
      stream_(job_.number, job_.epoch, job_.lattice, true, first_seq) {
    if (account_ != nullptr)
        kept_ = account_->open(core::MemoryUse::Surfaces);
}

std::size_t SurfaceBuild::shrink_history(std::size_t bytes) {
    if (bytes == 0)
        played_.reset();
    if (!played_)
        return 0;
    played_->limit(bytes);
    return played_->bytes();
}

void SurfaceBuild::renew_data(const SurfaceJob& job) {
    job_.scalars = job.scalars;
    job_.plan.levels = job.plan.levels;
    if (job_.plan.flow == job.plan.flow)
        return;
    if (permit_) // a second build follows the first
        permit_->clear();
    played_.reset();
    grown_.reset();
    last_ = Source::Nothing;
    job_.plan.flow = job.plan.flow;
    job_.store = job.store;
}

core::Result<Update>
SurfaceBuild::run_counted(const SurfacePass& pass, const std::stop_token& stop, const Work& work) {
    const auto start = clock_.now();
    if (stop.stop_requested())
        return cancelled();
    if (pass.checking)
        return check_state(pass, stop, work);
    auto shown = build(pass, stop, work);
    if (!shown)
        return tl::unexpected(shown.error());
    const bool due = announce_checks(*shown, pass);
    if (stop.stop_requested())
        return cancelled();
    const std::size_t vertices = shown->mesh.mesh.vertices();
    if (auto room = work.takes(
            vertices * (protocol::encoding_bytes + job_.fields.size() * encoding_field_bytes));
        !room)
        return tl::unexpected(room.error());
    const auto built = clock_.now();
    const double load = shown->load;
    auto update = encode(*shown, pass);
    if (update) {
        update->checks_due = due;
        unstated_ = due ? std::optional(std::move(*shown)) : std::nullopt;
        const auto end = clock_.now();
        update->seconds = std::chrono::duration<double>(end - start).count();
        update->took.load = load;
        update->took.encode = std::chrono::duration<double>(end - built).count();
        update->took.compute = std::max(0.0, update->seconds - update->took.encode - load);
    }
    return update;
}

core::Result<Update> SurfaceBuild::run(const SurfacePass& pass,
                                       const std::stop_token& stop,
                                       core::WorkDone* work) noexcept {
    try {
        if (account_ == nullptr)
            return run_counted(pass, stop, work);
        const bool whole = pass.phase == Phase::Final;
        core::WorkMemory memory(
            *account_, stop, whole ? patience : little_patience,
            fmt::format("this surface, of at most {} quads,", job_.plan.parameters.max_quads));
        auto update = run_counted(pass, stop, {work, &memory});
        kept_.set(stream_.bytes() + (grown_ ? grown_->bytes() : 0) +
                  (unstated_ ? core::memory_of(unstated_->mesh.mesh) : 0));
        if (update)
            update->memory = counted(account_, update->wire.bytes);
        return update;
    } catch (const std::bad_alloc&) {
        return core::fail(core::Error::Code::OverLimit,
                          "there is not enough memory for this surface",
                          "use a larger separation, fewer seeds or a lower `maxQuads`");
    } catch (const std::exception& error) { // an exception of a library ends this surface only
        spdlog::error("building surface {} failed: {}", job_.number, without_paths(error.what()));
        return core::fail(core::Error::Code::Io, "building the surface failed inside the server",
                          "the server's log has the details");
    }
}

core::Result<SurfaceBuild::Shown>
SurfaceBuild::build(const SurfacePass& pass, const std::stop_token& stop, const Work& work) {
    const bool timed = pass.time && core::moves(job_.plan.parameters);
    const double age = core::age_at(job_.plan.parameters, pass.time);
    if (job_.plan.parameters.kind == core::SurfaceKind::Level)
        return level(age, stop, work);
    if (pass.phase == Phase::Coarse || pass.phase == Phase::Refined)
        return build_early(pass, stop, work);
    if (!timed)
        return build_whole(stop, work);
    return job_.plan.parameters.kind == core::SurfaceKind::Path ? grow(age, stop, work)
                                                                : play(age, stop, work);
}

core::Result<SurfaceBuild::Shown> SurfaceBuild::build_early(const SurfacePass& pass,
                                                            const std::stop_token& stop,
                                                            const Work& work) const {
    const core::SurfacePlan plan = early_plan(job_.plan, pass);
    const core::SurfaceParameters& p = plan.parameters;
    auto surface = core::build_surface(plan, stop, clock_, work);
    if (!surface)
        return tl::unexpected(surface.error());
    auto fields = fields_of(*surface, p, stop, work);
    if (!fields)
        return tl::unexpected(fields.error());
    const double load = surface->statistics.seconds.load;
    if (pass.time && p.kind == core::SurfaceKind::Path) {
        const core::GrowingMesh growing(surface->mesh, core::time_span(p), *fields);
        const double age = core::age_at(p, pass.time);
        return Shown{growing.at(age), surface->statistics, Source::Nothing, growing.fields_at(age),
                     load};
    }
    return Shown{protocol::with_ids(std::move(surface->mesh)), surface->statistics, Source::Nothing,
                 std::move(*fields), load};
}

core::Result<SurfaceBuild::Shown> SurfaceBuild::build_whole(const std::stop_token& stop,
                                                            const Work& work) const {
    auto surface = core::build_surface(job_.plan, stop, clock_, work);
    if (!surface)
        return tl::unexpected(surface.error());
    auto fields = fields_of(*surface, job_.plan.parameters, stop, work);
    if (!fields)
        return tl::unexpected(fields.error());
    return Shown{protocol::with_ids(std::move(surface->mesh)),
                 surface->statistics,
                 Source::Whole,
                 std::move(*fields),
                 surface->statistics.seconds.load,
                 surface->ended};
}

std::size_t SurfaceBuild::sampling_memory(std::size_t vertices) const {
    if (job_.fields.empty())
        return 0;
    const bool gradients = std::ranges::any_of(job_.fields, [](const SurfaceField& field) {
        return field.source == SurfaceField::Source::Gradient;
    });
    return vertices *
           (sampling_bytes + (gradients ? gradient_bytes : 0) + sample_bytes * job_.fields.size());
}

core::Result<protocol::MeshFields> SurfaceBuild::fields_of(const core::Surface& surface,
                                                           const core::SurfaceParameters& p,
                                                           const std::stop_token& stop,
                                                           const Work& work) const {
    if (auto room = work.takes(sampling_memory(surface.mesh.vertices())); !room)
        return tl::unexpected(room.error());
    return sample_fields(
        job_.fields, *job_.plan.flow, job_.scalars.get(), surface.mesh,
        [&] { return core::vertex_times(surface, p); }, stop);
}

/// Each time and each level has a mesh of its own.
core::Result<SurfaceBuild::Shown>
SurfaceBuild::level(double age, const std::stop_token& stop, const Work& work) const {
    const core::SurfaceParameters& p = job_.plan.parameters;
    const double time = p.from + core::time_sign(p) * age;
    auto surface = core::build_level_surface(job_.plan, time, stop, clock_, work);
    if (!surface)
        return tl::unexpected(surface.error());
    if (auto room = work.takes(sampling_memory(surface->mesh.vertices())); !room)
        return tl::unexpected(room.error());
    auto fields = sample_fields(
        job_.fields, *job_.plan.flow, job_.scalars.get(), surface->mesh,
        [&] { return std::vector<double>(surface->mesh.vertices(), time); }, stop);
    if (!fields)
        return tl::unexpected(fields.error());
    const double load = surface->statistics.seconds.load;
    return Shown{protocol::with_ids(std::move(surface->mesh)), std::move(surface->statistics),
                 Source::Nothing, std::move(*fields), load};
}

core::Result<SurfaceBuild::Shown>
SurfaceBuild::grow(double age, const std::stop_token& stop, const Work& work) {
    double load = 0.0;
    if (!grown_) {
        const auto surface = core::build_surface(job_.plan, stop, clock_, work);
        if (!surface)
            return tl::unexpected(surface.error());
        const auto fields = fields_of(*surface, job_.plan.parameters, stop, work);
        if (!fields)
            return tl::unexpected(fields.error());
        if (auto room = work.takes(core::memory_of(surface->mesh)); !room)
            return tl::unexpected(room.error());
        grown_.emplace(surface->mesh, core::time_span(job_.plan.parameters), *fields);
        grown_statistics_ = surface->statistics;
        load = surface->statistics.seconds.load;
    }
    if (auto room = work.takes(grown_->bytes()); !room)
        return tl::unexpected(room.error());
    const core::SurfaceParameters& p = job_.plan.parameters;
    Shown shown{grown_->at(age),
                grown_statistics_,
                Source::Grown,
                grown_->fields_at(age),
                load,
                p.from + core::time_sign(p) * age};
    shown.statistics.quads = shown.mesh.mesh.cells.size();
    shown.statistics.vertices = shown.mesh.mesh.vertices();
    shown.statistics.error = core::stated_error(shown.mesh.mesh, shown.statistics.separation);
    return shown;
}

core::Result<SurfaceBuild::Shown>
SurfaceBuild::play(double age, const std::stop_token& stop, const Work& work) {
    if (histories_ == nullptr)
        return play_within(limits::history_bytes, age, stop, work);
    if (!permit_)
        permit_ = std::make_unique<HistoryBudget::Permit>(
            *histories_, [this](std::size_t bytes) { return shrink_history(bytes); });

    struct Use {
        explicit Use(SurfaceBuild& of) : build(of), bytes(of.permit_->begin(of.clock_.now())) {}

        ~Use() { build.permit_->end(build.played_ ? build.played_->bytes() : 0); }

        SurfaceBuild& build;
        std::size_t bytes;
    };

    const Use use(*this);
    return play_within(use.bytes, age, stop, work);
}

core::Result<SurfaceBuild::Shown> SurfaceBuild::play_within(std::size_t bytes,
                                                            double age,
                                                            const std::stop_token& stop,
                                                            const Work& work) {
    if (played_) {
        played_->limit(bytes);
    } else {
        auto started = core::PlayedSurface::start(job_.plan, bytes, clock_, stop, work);
        if (!started)
            return tl::unexpected(started.error());
        played_ = std::move(*started);
        last_ = Source::Nothing; // ids start again
        played_load_ = 0.0;
    }
    auto shown = played_->at(age, stop, work);
    if (!shown)
        return tl::unexpected(shown.error());
    if (auto room = work.takes(sampling_memory(shown->mesh.mesh.vertices())); !room)
        return tl::unexpected(room.error());
    auto fields = sample_fields(
        job_.fields, *job_.plan.flow, job_.scalars.get(), shown->mesh.mesh,
        [&] { return std::vector<double>(shown->mesh.mesh.vertices(), shown->time); }, stop);
    if (!fields)
        return tl::unexpected(fields.error());
    const double loaded = shown->statistics.seconds.load;
    const double load = loaded - std::exchange(played_load_, loaded);
    return Shown{std::move(shown->mesh),
                 shown->statistics,
                 Source::Played,
                 std::move(*fields),
                 load,
                 shown->time};
}

/// Says in the statistics what is to come, or why it is not; returns whether anything is.
bool SurfaceBuild::announce_checks(Shown& shown, const SurfacePass& pass) const {
    if (pass.phase != Phase::Final)
        return false;
    const bool any = shown.mesh.mesh.vertices() > 0;
    std::string& left_out = shown.statistics.interval_left_out;
    left_out = core::no_interval_errors(job_.plan, shown.ended);
    const bool estimate = left_out.empty() && any;
    if (estimate)
        left_out = "it is not estimated yet";
    shown.statistics.twin_left_out = job_.twin ? "it is not compared yet" : job_.twin_left_out;
    return any && (estimate || job_.twin);
}

/// The update carries the errors and the twin in the fields that are for them, and else what they come to. What
/// cannot be had says why.
core::Result<Update>
SurfaceBuild::check_state(const SurfacePass& pass, const std::stop_token& stop, const Work& work) {
    if (!unstated_) // a build before this one made the state that is shown
        return core::fail(core::Error::Code::NotFound, "the state to estimate has been released");
    core::Surface surface{std::move(unstated_->mesh.mesh), unstated_->statistics, unstated_->ended};
    const auto stated = core::state_interval_errors(job_.plan, surface, stop, work);
    std::optional<core::Result<core::TwinComparison>> twin;
    if (job_.twin)
        twin = core::compare_twin(job_.plan, surface, *job_.twin, stop, work);
    unstated_->mesh.mesh = std::move(surface.mesh);
    if (stop.stop_requested())
        return cancelled();
    if (!stated)
        surface.statistics.interval_left_out = stated.error().message;
    surface.statistics.twin_left_out = twin && !*twin ? twin->error().message : job_.twin_left_out;
    if (twin && *twin)
        surface.statistics.twin = (*twin)->stated;
    Shown shown = *std::exchange(unstated_, std::nullopt);
    shown.statistics = std::move(surface.statistics);
    using Field = SurfaceField::Source;
    for (std::size_t i = 0; i < job_.fields.size(); ++i) {
        const auto source = job_.fields[i].source;
        if (source == Field::IntervalError && !shown.mesh.mesh.interval_error.empty())
            shown.fields[i] = shown.mesh.mesh.interval_error;
        if (source == Field::TwinDistance && twin && *twin)
            shown.fields[i] = (*twin)->distance;
        if (source == Field::TwinLag && twin && *twin)
            shown.fields[i] = (*twin)->lag;
    }
    return encode(shown, pass);
}

core::Result<Update> SurfaceBuild::encode(Shown& shown, const SurfacePass& pass) {
    const core::SurfaceParameters& p = job_.plan.parameters;
    const double time =
        core::moves(p) ? p.from + core::time_sign(p) * core::age_at(p, pass.time) : p.from;
    shown.mesh.time = time;
    protocol::UpdateOptions options;
    options.phase = pass.phase;
    options.tolerance =
        pass.phase == Phase::Live ? protocol::live_tolerance : protocol::exact_tolerance;
    options.unrelated = shown.source == Source::Nothing || shown.source != last_;
    Update update;
    update.ranges = ranges_of(job_, shown.mesh.mesh, shown.fields, time);
    auto encoded = stream_.next(shown.mesh, options, shown.fields);
    if (!encoded)
        return tl::unexpected(encoded.error());
    last_ = shown.source;
    update.wire = std::move(*encoded);
    update.statistics = shown.statistics;
    update.time = time;
    if (pass.phase == Phase::Final)
        update.shape = shape_mark(shown.mesh.mesh);
    return update;
}

} // namespace wakesurf::server
