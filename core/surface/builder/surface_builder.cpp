#include "core/surface/builder/surface_builder.hpp"

#include "core/surface/budget_search.hpp"
#include "core/surface/builder/emptiness.hpp"
#include "core/surface/builder/vertex_attributes.hpp"
#include "core/surface/columns/fixed_sheet.hpp"
#include "core/surface/columns/sheet_mesh.hpp"
#include "core/surface/level/level_surface.hpp"
#include "core/surface/moving/moving_builder.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <set>
#include <vector>

namespace wakesurf::core {

namespace {

/// A quad of the mesh comes from at most so many quads of strips: neighbours that are small are joined in it.
constexpr std::uint64_t most_before_joining = 2;
/// A quad takes so many bytes while its vertices and what they carry are put together.
constexpr std::size_t mesh_bytes = 300;

std::set<double> first_seeds(const SeedingCurve& seeding, double intervals) {
    const auto even = seed_parameters(seeding.corners(), intervals);
    std::set<double> seeds(even.begin(), even.end());
    if (!seeding.closed())
        seeds.insert(1.0);
    return seeds;
}

std::uint64_t quads_of(const std::vector<Sheet>& sheets) {
    std::uint64_t quads = 0;
    for (const Sheet& sheet : sheets)
        quads += sheet.quads();
    return quads;
}

/// Builds one sheet per direction over the same seeds; a direction that cuts the rake makes the other follow.
/// Empty: they have more than `most` quads together.
Result<std::optional<std::vector<Sheet>>> build_sheets(const SurfacePlan& plan,
                                                       const std::vector<SheetOptions>& directions,
                                                       std::set<double> seeds,
                                                       std::uint64_t most,
                                                       const Clock& clock,
                                                       const std::stop_token& stop,
                                                       const WorkPart& work) {
    std::vector<Sheet> sheets;
    for (const SheetOptions& options : directions)
        sheets.emplace_back(*plan.flow, plan.seeding, options);
    for (std::size_t before = 0; before != seeds.size();) {
        before = seeds.size();
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            Sheet& sheet = sheets[i];
            if (sheet.seeds() == seeds)
                continue;
            const auto built = sheet.build(seeds, clock, stop, work.part(i, sheets.size()));
            if (!built)
                return tl::unexpected(built.error());
            if (!*built || quads_of(sheets) > most)
                return std::nullopt;
            seeds.insert(sheet.seeds().begin(), sheet.seeds().end());
        }
    }
    return sheets;
}

/// A surface without the attributes of its vertices.
struct Bare {
    SheetMesh mesh;
    SurfaceStatistics statistics;
};

/// Returns the quads of a sheet swept by the rake as far as 17 of its curves reach, where nothing diverges.
/// This keeps a request for millions of columns from being traced at all.
Result<double> undiverged_quads(const SurfacePlan& plan,
                                const std::vector<SheetOptions>& directions,
                                const std::stop_token& stop) {
    double arc = 0.0;
    for (const SheetOptions& options : directions) {
        std::vector<Curve> curves(17);
        for (std::size_t i = 0; i < curves.size(); ++i) {
            curves[i].seed = plan.seeding.at(static_cast<double>(i) / 16.0);
            curves[i].release = options.release;
            curves[i].duration = options.duration;
        }
        TraceOptions rough = options.trace;
        rough.tolerance = 1e-3;
        rough.stretch = false;
        if (const auto traced = plan.flow->trace(curves, rough, stop); !traced)
            return tl::unexpected(traced.error());
        for (const Curve& curve : curves)
            arc += curve.last.arc / static_cast<double>(curves.size());
    }
    const double separation = directions.front().separation;
    return std::max(plan.seeding.length() / separation, 1.0) * arc / separation;
}

void count_columns(const Sheet& sheet, SurfaceStatistics& statistics) {
    statistics.seconds.load += sheet.seconds().load;
    statistics.seconds.advect += sheet.seconds().advect;
    statistics.seconds.refine += sheet.seconds().refine;
    for (const SeededCurve* column : sheet.columns()) {
        const Curve& curve = column->curve;
        statistics.steps = std::max<std::uint64_t>(statistics.steps, curve.steps.size());
        statistics.vertex_steps += curve.attempts;
        statistics.terminated.add(curve.end);
    }
}

/// Joins the sheets to one mesh. Error: OverLimit where there is no memory, Cancelled.
Result<Bare>
joined(const std::vector<Sheet>& sheets, const std::stop_token& stop, const WorkPart& work) {
    Bare out;
    for (const Sheet& sheet : sheets) {
        if (auto room = work.takes(sheet.quads() * mesh_bytes); !room)
            return tl::unexpected(room.error());
        if (!append_sheet(out.mesh, sheet, stop))
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        count_columns(sheet, out.statistics);
    }
    return out;
}

/// The quad budget is hard: a surface too large for it is built coarser, and its statistics say so.
Result<Bare> build_within_budget(const SurfacePlan& plan,
                                 const Clock& clock,
                                 const std::stop_token& stop,
                                 const WorkPart& work) {
    const SurfaceParameters& p = plan.parameters;
    const auto start = clock.now();
    const auto speed = plan.largest_speed(stop);
    const double load = std::chrono::duration<double>(clock.now() - start).count();
    if (!speed)
        return tl::unexpected(speed.error());
    const auto estimate = undiverged_quads(plan, plan.sheets(p.separation, *speed), stop);
    if (!estimate)
        return tl::unexpected(estimate.error());
    BudgetSearch search(p.separation, coarsest_separation(plan.flow->domain()), *estimate,
                        p.max_quads);
    while (const auto trial = search.next()) {
        const double intervals =
            seed_intervals(plan.rake, plan.seeding.length(), trial->separation, p.separation);
        if (intervals > static_cast<double>(most_before_joining * trial->most)) {
            search.exceeded();
            continue;
        }
        auto directions = plan.sheets(trial->separation, *speed);
        for (SheetOptions& each : directions) {
            each.trace.memory = work.memory();
            each.max_quads = most_before_joining * trial->most;
        }
        const std::size_t before = work.memory() != nullptr ? work.memory()->bytes() : 0;
        auto sheets = build_sheets(plan, directions, first_seeds(plan.seeding, intervals),
                                   most_before_joining * trial->most, clock, stop,
                                   trial->most < p.max_quads ? work.rest().between(0.0, trial_share)
                                                             : work.rest());
        if (!sheets)
            return tl::unexpected(sheets.error());
        std::optional<Bare> bare;
        if (*sheets) {
            auto made = joined(**sheets, stop, work);
            if (!made)
                return tl::unexpected(made.error());
            bare = std::move(*made);
        }
        if (!bare || bare->mesh.complex.cells.size() > trial->most) {
            search.exceeded();
        } else if (search.built(bare->mesh.complex.cells.size())) {
            bare->statistics.separation = trial->separation;
            bare->statistics.seconds.load += load;
            return std::move(*bare);
        }
        bare.reset(); // before its memory is released
        sheets->reset();
        if (work.memory() != nullptr)
            work.memory()->shrink(work.memory()->bytes() - before);
    }
    return cannot_be_coarser(p.max_quads, search.coarsest());
}

/// Builds a surface whose grid stays as it begins.
Result<Bare> build_fixed(const SurfacePlan& plan,
                         const Clock& clock,
                         const std::stop_token& stop,
                         const WorkPart& work) {
    const auto speed = plan.largest_speed(stop);
    if (!speed)
        return tl::unexpected(speed.error());
    auto directions = plan.sheets(plan.parameters.separation, *speed);
    for (SheetOptions& each : directions)
        each.trace.memory = work.memory();
    return fixed_sheet(plan, directions, clock, stop, work).map([](FixedSheet&& made) {
        return Bare{std::move(made.mesh), std::move(made.statistics)};
    });
}

Result<Surface> build_whole(const SurfacePlan& plan,
                            const std::stop_token& stop,
                            const Clock& clock,
                            const WorkPart& work) {
    const SurfaceParameters& parameters = plan.parameters;
    const auto start = clock.now();
    if (parameters.kind == SurfaceKind::Streak || parameters.kind == SurfaceKind::Time)
        return build_moving_surface(plan, stop, clock, work);
    // Sampling what its vertices carry takes about as long as the sheets.
    const auto build = parameters.refine == Refine::On ? build_within_budget : build_fixed;
    auto built = build(plan, clock, stop, work.part(0, 2));
    if (!built)
        return tl::unexpected(built.error());

    auto& [mesh, statistics] = *built;
    if (auto done = add_attributes(mesh, plan, stop); !done)
        return tl::unexpected(done.error());
    label_components(mesh.complex);
    assert(mesh.complex.validate().empty());
    statistics.kind = parameters.kind;
    statistics.quads = mesh.complex.cells.size();
    statistics.vertices = mesh.complex.vertices();
    statistics.max_edge = longest_edge(mesh.complex);
    statistics.requested_separation = parameters.separation;
    statistics.data_end = data_end(*plan.flow, parameters);
    statistics.error = stated_error(mesh.complex, statistics.separation);
    statistics.seconds.total = std::chrono::duration<double>(clock.now() - start).count();
    statistics.seconds.other = statistics.seconds.total - statistics.seconds.load -
                               statistics.seconds.advect - statistics.seconds.refine;
    return Surface{std::move(mesh.complex), std::move(statistics)};
}

// The part of a surface that comes before a time-step that cannot be read, if there is one.
std::optional<SurfaceParameters> readable_part(const SurfaceParameters& p, const Error& error) {
    if (!error.readable_until)
        return std::nullopt;
    const double reach = std::abs(*error.readable_until - p.from);
    if (p.kind == SurfaceKind::Stream || reach == 0.0 || reach >= std::abs(p.to - p.from))
        return std::nullopt;
    SurfaceParameters part = p;
    part.to = p.from + time_sign(p) * reach;
    if (part.release_until && time_sign(p) * (*part.release_until - part.to) > 0.0)
        part.release_until = part.to;
    return part;
}

} // namespace

Result<Surface> build_surface(const Flow& flow,
                              const Rake& rake,
                              const SurfaceParameters& parameters,
                              std::stop_token stop,
                              const Clock& clock,
                              WorkPart work) {
    return plan_surface(flow, rake, parameters).and_then([&](const SurfacePlan& plan) {
        return build_surface(plan, stop, clock, work);
    });
}

Result<Surface>
build_surface(const SurfacePlan& plan, std::stop_token stop, const Clock& clock, WorkPart work) {
    if (plan.parameters.kind == SurfaceKind::Level)
        return build_level_surface(plan, plan.parameters.to, stop, clock, work);
    const std::size_t before = work.memory() != nullptr ? work.memory()->bytes() : 0;
    auto surface = build_whole(plan, stop, clock, work);
    std::string stopped;
    std::optional<double> ended;
    for (SurfacePlan shorter = plan; !surface;) {
        const auto part = readable_part(shorter.parameters, surface.error());
        if (!part)
            return surface;
        if (work.memory() != nullptr)
            work.memory()->shrink(work.memory()->bytes() - before);
        shorter.parameters = *part;
        ended = part->to;
        stopped = surface.error().message;
        surface = build_whole(shorter, stop, clock, work);
    }
    auto empty = why_empty(plan, surface->mesh, surface->statistics, stop);
    if (!empty)
        return tl::unexpected(empty.error());
    surface->statistics.empty = std::move(*empty);
    surface->statistics.stopped = std::move(stopped);
    surface->ended = ended;
    work.reached(1.0);
    if (work.memory() != nullptr) { // what is left is the mesh
        const std::size_t mesh = memory_of(surface->mesh);
        const std::size_t now = work.memory()->bytes() - before;
        work.memory()->shrink(now - std::min(now, mesh));
    }
    return surface;
}

} // namespace wakesurf::core
