#include "core/surface/columns/fixed_sheet.hpp"

#include "core/surface/columns/curve_errors.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>

namespace wakesurf::core {

namespace {

constexpr double row_of_separation = 0.75;
constexpr std::size_t grid_bytes = 500; ///< a quad, with its vertex, while the mesh is made

/// The columns of one direction.
struct FixedColumns {
    std::deque<SeededCurve> columns;
    double life = 0.0;  ///< of the particle that lives longest, without sign
    double speed = 0.0; ///< the largest mean of a particle
    double rows = 0.0;  ///< in that life
    double sign = 1.0;

    double row_time() const { return life / rows; }

    std::size_t rows_of(const SeededCurve& column) const {
        return static_cast<std::size_t>(std::abs(column.curve.last.time) / row_time() + 1e-9);
    }

    /// Returns the quads between columns of that many rows, at most.
    double quads() const { return rows * static_cast<double>(columns.size()); }
};

Result<FixedColumns> traced(const Flow& flow,
                            const SeedingCurve& seeding,
                            const std::vector<double>& seeds,
                            const SheetOptions& options,
                            const Clock& clock,
                            const std::stop_token& stop,
                            SurfaceStatistics& statistics) {
    const auto began = clock.now();
    std::vector<Curve> curves(seeds.size());
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        curves[i].seed = seeding.at(seeds[i]);
        curves[i].seed_tangent = seeding.tangent(seeds[i]);
        curves[i].release = options.release;
        curves[i].duration = options.duration;
    }
    const auto waited = flow.trace(curves, options.trace, stop);
    if (!waited)
        return tl::unexpected(waited.error());
    FixedColumns grid;
    grid.sign = options.duration < 0.0 ? -1.0 : 1.0;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        const Curve& curve = curves[i];
        const double life = std::abs(curve.last.time);
        grid.life = std::max(grid.life, life);
        if (life > 0.0)
            grid.speed = std::max(grid.speed, curve.last.arc / life);
        grid.columns.push_back({seeds[i], std::move(curves[i]), {}});
    }
    grid.rows = std::max(
        1.0, std::ceil(grid.life * grid.speed / (row_of_separation * options.separation) - 1e-9));
    statistics.seconds.load += waited->load;
    statistics.seconds.advect +=
        std::chrono::duration<double>(clock.now() - began).count() - waited->load;
    return grid;
}

/// Appends a direction's vertices and quads.
void append(SheetMesh& mesh, const FixedColumns& grid, bool closed, const std::stop_token& stop) {
    const std::size_t count = grid.columns.size();
    std::vector<const SeededCurve*> curves;
    std::vector<std::size_t> rows;
    for (const SeededCurve& column : grid.columns) {
        curves.push_back(&column);
        rows.push_back(grid.rows_of(column));
    }
    const CurveErrors errors(curves, stop);
    if (stop.stop_requested())
        return;
    QuadComplex& complex = mesh.complex;
    const std::size_t pairs = closed ? count : count - 1;
    const auto shared = [&](std::size_t pair) {
        return std::min(rows[pair], rows[(pair + 1) % count]);
    };
    // A column has the vertices that a quad on either side of it takes.
    std::vector<std::vector<VertexId>> id(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t used = i < pairs ? shared(i) : 0;
        if (i > 0 || closed)
            used = std::max(used, shared((i + count - 1) % count));
        for (std::size_t k = 0; used > 0 && k <= used; ++k) {
            const auto next = static_cast<VertexId>(complex.vertices());
            id[i].push_back(k == 0 ? mesh.on_rake.try_emplace(curves[i]->s, next).first->second
                                   : next);
            if (id[i].back() != next)
                continue; // the other direction made it
            const CurvePoint point =
                curves[i]->curve.at_time(grid.sign * static_cast<double>(k) * grid.row_time());
            complex.position.push_back(k == 0 ? curves[i]->curve.seed : point.position);
            complex.s.push_back(curves[i]->s);
            complex.t.push_back(point.time);
            complex.approximated.push_back(0);
            complex.error.push_back(errors.at(curves[i], point.arc));
            mesh.stretch.push_back(point.stretch);
        }
    }
    for (std::size_t i = 0; i < pairs; ++i) {
        const auto& left = id[i];
        const auto& right = id[(i + 1) % count];
        for (std::size_t k = 0; k < shared(i); ++k) {
            const Cell cell{{left[k], right[k], right[k + 1], left[k + 1]},
                            {no_vertex, no_vertex, no_vertex, no_vertex}};
            complex.cells.push_back(grid.sign < 0.0 ? mirror(cell) : cell);
        }
    }
}

void count(const FixedColumns& grid, SurfaceStatistics& statistics) {
    for (const SeededCurve& column : grid.columns) {
        const Curve& curve = column.curve;
        statistics.steps = std::max<std::uint64_t>(statistics.steps, curve.steps.size());
        statistics.vertex_steps += curve.attempts;
        statistics.terminated.add(curve.end);
    }
}

} // namespace

Result<FixedSheet> fixed_sheet(const SurfacePlan& plan,
                               std::span<const SheetOptions> directions,
                               const Clock& clock,
                               const std::stop_token& stop,
                               const WorkPart& work) {
    const SheetOptions& first = directions.front();
    const Rake& rake = plan.rake;
    const SeedingCurve& seeding = plan.seeding;
    const double most = static_cast<double>(first.max_quads);
    const double intervals =
        std::min(grid_intervals(rake, seeding.length(), first.separation, first.separation),
                 std::max(rake.closed() ? 3.0 : 1.0,
                          std::floor(most / static_cast<double>(directions.size()))));
    std::vector<double> seeds = seed_parameters(seeding.corners(), intervals);
    if (!rake.closed())
        seeds.push_back(1.0);
    FixedSheet out;
    std::vector<FixedColumns> grids;
    double quads = 0.0;
    for (const SheetOptions& options : directions) {
        auto grid = traced(*plan.flow, seeding, seeds, options, clock, stop, out.statistics);
        if (!grid)
            return tl::unexpected(grid.error());
        quads += grid->quads();
        grids.push_back(*std::move(grid));
    }
    work.reached(0.5);
    out.statistics.separation = first.separation;
    for (FixedColumns& grid : grids) {
        if (quads > most) { // the budget is shared in proportion
            const double fewer = std::max(1.0, std::floor(grid.rows * most / quads));
            out.statistics.separation =
                std::max(out.statistics.separation, first.separation * grid.rows / fewer);
            grid.rows = fewer;
        }
        if (auto room = work.takes(static_cast<std::size_t>(grid.quads()) * grid_bytes); !room)
            return tl::unexpected(room.error());
        append(out.mesh, grid, rake.closed(), stop);
        if (stop.stop_requested())
            return fail(Error::Code::Cancelled, "the surface was cancelled");
        count(grid, out.statistics);
    }
    work.reached(1.0);
    return out;
}

} // namespace wakesurf::core
