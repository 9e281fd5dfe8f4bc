#include "core/surface/surface_builder.hpp"

#include "core/surface/columns/sheet_mesh.hpp"
#include "core/surface/moving/moving_builder.hpp"
#include "core/surface/surface_request.hpp"
#include "core/surface/vertex_attributes.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <set>
#include <vector>

namespace wakesurf::core {

namespace {

constexpr std::size_t mesh_bytes =
    300; ///< a quad, while its vertices and what they carry are put together

tl::unexpected<Error> no_memory() {
    return fail(Error::Code::Cancelled, "there is not enough memory for the surface");
}

std::set<double> first_seeds(const Rake& rake, double separation) {
    const SeedingCurve curve(rake);
    const auto even = seed_parameters(
        curve.corners(), std::max(rake.seeds - 1.0, std::ceil(curve.length() / separation - 1e-9)));
    std::set<double> seeds(even.begin(), even.end());
    if (!rake.closed())
        seeds.insert(1.0);
    return seeds;
}

/// One sheet per direction over the same seeds; a direction that cuts the rake makes the other follow.
Result<std::vector<Sheet>> build_sheets(const Flow& flow,
                                        const Rake& rake,
                                        const std::vector<SheetOptions>& directions,
                                        const Clock& clock,
                                        const std::stop_token& stop,
                                        const WorkPart& work) {
    std::vector<Sheet> sheets;
    for (const SheetOptions& options : directions)
        sheets.emplace_back(flow, rake, options);
    std::set<double> seeds = first_seeds(rake, directions.front().separation);
    for (std::size_t before = 0; before != seeds.size();) {
        before = seeds.size();
        for (std::size_t i = 0; i < sheets.size(); ++i) {
            Sheet& sheet = sheets[i];
            if (sheet.seeds() == seeds)
                continue;
            if (auto done = sheet.build(seeds, clock, stop, work.part(i, sheets.size())); !done)
                return tl::unexpected(done.error());
            seeds.insert(sheet.seeds().begin(), sheet.seeds().end());
        }
    }
    return sheets;
}

struct Sheets {
    std::vector<Sheet> sheets;
    double separation;
    double load; ///< s until the first time-steps were in memory
};

/// The separation at which a sheet swept by the rake as far as 17 of its curves reach has the wanted number of quads
/// where nothing diverges: keeps a request for millions of columns from being traced at all.
Result<double> coarsest_needed(const Flow& flow,
                               const Rake& rake,
                               const SheetOptions& options,
                               const std::stop_token& stop) {
    const SeedingCurve seeding(rake);
    std::vector<Curve> curves(17);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        curves[i].seed = seeding.at(static_cast<double>(i) / 16.0);
        curves[i].release = options.release;
        curves[i].duration = options.duration;
    }
    TraceOptions rough = options.trace;
    rough.tolerance = 1e-3;
    rough.stretch = false;
    return flow.trace(curves, rough, stop).map([&](const TraceCost&) {
        double arc = 0.0;
        for (const Curve& curve : curves)
            arc += curve.last.arc / static_cast<double>(curves.size());
        return std::sqrt(seeding.length() * arc / static_cast<double>(options.max_quads));
    });
}

/// The quad budget is hard: a surface too large for it is built coarser, and its statistics say so.
Result<Sheets> build_within_budget(const Flow& flow,
                                   const Rake& rake,
                                   const SurfaceParameters& p,
                                   const Clock& clock,
                                   const std::stop_token& stop,
                                   const WorkPart& work) {
    const auto start = clock.now();
    const auto speed = largest_speed(flow, rake, p.from, stop);
    const double load = std::chrono::duration<double>(clock.now() - start).count();
    if (!speed)
        return tl::unexpected(speed.error());
    double separation = p.separation > 0.0 ? p.separation : flow.finest_spacing();
    for (bool first = true;; separation *= 1.25) {
        auto directions = sheet_options(flow, rake, p, separation, *speed);
        if (!directions)
            return tl::unexpected(directions.error());
        const std::uint64_t most = directions->front().max_quads;
        if (rake.seeds > most)
            return over_limit(p.max_quads,
                              "the rake has more seeds than the surface may have quads",
                              "use fewer seeds or a larger maxQuads");
        if (first) {
            first = false;
            const auto needed = coarsest_needed(flow, rake, directions->front(), stop);
            if (!needed)
                return tl::unexpected(needed.error());
            if (separation < *needed) {
                separation = *needed;
                continue;
            }
        }
        for (SheetOptions& each : *directions)
            each.trace.memory = work.memory();
        const std::size_t before = work.memory() != nullptr ? work.memory()->bytes() : 0;
        auto sheets = build_sheets(flow, rake, *directions, clock, stop, work);
        if (!sheets && work.memory() != nullptr)
            work.memory()->shrink(work.memory()->bytes() - before);
        if (sheets)
            return Sheets{std::move(*sheets), separation, load};
        if (sheets.error().code != Error::Code::OverLimit)
            return tl::unexpected(sheets.error());
    }
}

void count_columns(const Sheet& sheet, SurfaceStatistics& statistics) {
    statistics.seconds.load += sheet.seconds().load;
    statistics.seconds.advect += sheet.seconds().advect;
    statistics.seconds.refine += sheet.seconds().refine;
    for (const SeededCurve* column : sheet.columns()) {
        const Curve& curve = column->curve;
        statistics.steps = std::max<std::uint64_t>(statistics.steps, curve.steps.size());
        statistics.vertex_steps += curve.attempts;
        statistics.peak_bytes += curve.steps.capacity() * sizeof(CurveStep);
        auto& ended = statistics.terminated;
        ended.domain += curve.end == CurveEnd::Domain;
        ended.time += curve.end == CurveEnd::Time;
        ended.obstacle += curve.end == CurveEnd::Obstacle;
        ended.stagnation += curve.end == CurveEnd::Stagnation;
        ended.budget += curve.end == CurveEnd::Budget;
    }
}

Result<Surface> build_whole(const Flow& flow,
                            const Rake& rake,
                            const SurfaceParameters& parameters,
                            const std::stop_token& stop,
                            const Clock& clock,
                            const WorkPart& work) {
    const auto start = clock.now();
    if (parameters.kind == SurfaceKind::Streak || parameters.kind == SurfaceKind::Time)
        return build_moving_surface(flow, rake, parameters, stop, clock, work);
    // What its vertices carry takes about as long as the sheets.
    auto built = build_within_budget(flow, rake, parameters, clock, stop, work.part(0, 2));
    if (!built)
        return tl::unexpected(built.error());

    SheetMesh mesh;
    SurfaceStatistics statistics;
    statistics.seconds.load = built->load;
    for (const Sheet& sheet : built->sheets) {
        std::size_t quads = 0;
        for (const Strip& strip : sheet.strips())
            quads += strip.quads();
        if (!work.takes(quads * mesh_bytes))
            return no_memory();
        append_sheet(mesh, sheet);
        count_columns(sheet, statistics);
    }
    built->sheets.clear(); // half of all memory
    if (auto done = add_attributes(mesh, flow, rake, parameters, stop); !done)
        return tl::unexpected(done.error());
    label_components(mesh.complex);
    assert(mesh.complex.validate().empty());
    statistics.kind = parameters.kind;
    statistics.quads = mesh.complex.cells.size();
    statistics.vertices = mesh.complex.vertices();
    statistics.max_edge = longest_edge(mesh.complex);
    statistics.separation = built->separation;
    statistics.seconds.total = std::chrono::duration<double>(clock.now() - start).count();
    statistics.seconds.other = statistics.seconds.total - statistics.seconds.load -
                               statistics.seconds.advect - statistics.seconds.refine;
    return Surface{std::move(mesh.complex), statistics};
}

// The part of a surface that comes before a time-step that cannot be read, if there is one.
std::optional<SurfaceParameters> readable_part(const SurfaceParameters& p, const Error& error) {
    if (!error.readable_until)
        return std::nullopt;
    const double reach = std::abs(*error.readable_until - p.from);
    if (p.kind == SurfaceKind::Stream || reach == 0.0 || reach >= std::abs(p.to - p.from))
        return std::nullopt;
    SurfaceParameters part = p;
    part.to = p.from + std::copysign(reach, p.to - p.from);
    if (part.release_until)
        part.release_until = std::min(*part.release_until, std::max(part.from, part.to));
    return part;
}

} // namespace

Result<Surface> build_surface(const Flow& flow,
                              const Rake& rake,
                              const SurfaceParameters& parameters,
                              std::stop_token stop,
                              const Clock& clock,
                              WorkPart work) {
    if (auto sound = check_request(parameters); !sound)
        return tl::unexpected(sound.error());
    const std::size_t before = work.memory() != nullptr ? work.memory()->bytes() : 0;
    auto surface = build_whole(flow, rake, parameters, stop, clock, work);
    std::string stopped;
    std::optional<double> ended;
    for (auto p = parameters; !surface;) {
        const auto part = readable_part(p, surface.error());
        if (!part && work.memory() != nullptr && work.memory()->exhausted())
            return tl::unexpected(work.memory()->refusal(
                "a surface of at most " + std::to_string(parameters.max_quads) + " quads"));
        if (!part)
            return surface;
        if (work.memory() != nullptr)
            work.memory()->shrink(work.memory()->bytes() - before);
        p = *part;
        ended = p.to;
        stopped = surface.error().message;
        surface = build_whole(flow, rake, p, stop, clock, work);
    }
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
