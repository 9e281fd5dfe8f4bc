#include "core/surface/patches/tessellation.hpp"

#include "core/base/for_each_index.hpp"
#include "core/surface/patches/cell_patch.hpp"
#include "core/surface/patches/side_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace wakesurf::core {

namespace {

/// Returns how far a curve may be off half-way, by what its slopes and its chord say of the cubic that it
/// leaves out.
double doubt_of(const SideCurve& curve) {
    const Vec3 chord = curve.b.position - curve.a.position;
    return curve.flat
               ? 0.0
               : glm::length(curve.slope_a.position + curve.slope_b.position - 2.0 * chord) / 5.0;
}

/// Cuts one mesh: vertices as they were, then those on sides, then those within cells.
class Cutter {
  public:
    Cutter(const QuadComplex& mesh,
           const SideCurves& curves,
           const SideTable& table,
           std::uint32_t pieces)
        : mesh_(mesh), curves_(curves), table_(table), n_(pieces), on_sides_(mesh.vertices()),
          in_cells_(on_sides_ + table.count() * (n_ - 1)) {}

    std::size_t vertices() const {
        return in_cells_ + mesh_.cells.size() * std::size_t{n_ - 1} * (n_ - 1);
    }

    Tessellation cut() {
        QuadComplex& out = made_.mesh;
        reserve(out);
        normal_.assign(on_sides_, Vec3(0.0));
        side_normal_.assign(2 * table_.count() * (n_ - 1), Vec3(0.0));
        flat_.assign(mesh_.cells.size(), 0);
        corner_normal_.assign(mesh_.cells.size(), {});
        table_.for_each(
            [&](std::size_t number, const SideTable::Ends& ends) { cut_side(number, ends); });
        for_each_index(mesh_.cells.size(), [&](std::size_t c) { cut_cell(c); });
        for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
            made_.flat_cells += flat_[c];
            const CellPolygon outline = polygon(mesh_.cells[c]);
            for (std::uint32_t i = 0; i < outline.count; ++i)
                normal_[outline.vertex[i]] += corner_normal_[c][i];
        }
        for (std::size_t v = 0; v < on_sides_; ++v)
            out.normal[v] = Vec3f(unit(normal_[v]));
        for (std::size_t k = 0; k < side_normal_.size() / 2; ++k)
            out.normal[on_sides_ + k] = Vec3f(unit(side_normal_[2 * k] + side_normal_[2 * k + 1]));
        return std::move(made_);
    }

  private:
    static Vec3 unit(const Vec3& v) {
        const double length = glm::length(v);
        return length > 0.0 && std::isfinite(length) ? v / length : Vec3(0.0);
    }

    template <class T>
    static void extend(const std::vector<T>& from, std::size_t count, std::vector<T>& to) {
        if (from.empty())
            return;
        to.reserve(count);
        to = from;
        to.resize(count);
    }

    void reserve(QuadComplex& out) const {
        const std::size_t count = vertices();
        extend(mesh_.position, count, out.position);
        extend(mesh_.s, count, out.s);
        extend(mesh_.t, count, out.t);
        extend(mesh_.velocity, count, out.velocity);
        extend(mesh_.deformation, count, out.deformation);
        extend(mesh_.component, count, out.component);
        extend(mesh_.approximated, count, out.approximated);
        extend(mesh_.error, count, out.error);
        out.normal.resize(count);
        out.cells.resize(mesh_.cells.size() * n_ * n_);
    }

    /// Sets values between vertices, the sum of the shares being 1.
    template <std::size_t Count>
    void set(std::size_t at,
             const PatchPoint& point,
             const std::array<VertexId, Count>& of,
             const std::array<double, Count>& part,
             double doubt) {
        QuadComplex& out = made_.mesh;
        const auto mean = [&](const auto& values) {
            auto sum = values[of[0]] * static_cast<float>(part[0]);
            for (std::size_t k = 1; k < Count; ++k)
                sum += values[of[k]] * static_cast<float>(part[k]);
            return sum;
        };
        out.position[at] = point.position;
        out.s[at] =
            curves_.closed() ? point.s - std::floor(point.s) : std::clamp(point.s, 0.0, 1.0);
        out.t[at] = point.t;
        if (!mesh_.velocity.empty())
            out.velocity[at] = mean(mesh_.velocity);
        if (!mesh_.deformation.empty())
            out.deformation[at] = mean(mesh_.deformation);
        if (!mesh_.component.empty())
            out.component[at] = mesh_.component[of[0]];
        out.approximated[at] = 1;
        if (!mesh_.error.empty())
            out.error[at] = mean(mesh_.error) + static_cast<float>(doubt);
    }

    void cut_side(std::size_t number, const SideTable::Ends& ends) {
        const SideCurve curve = curves_.between(ends.a, ends.b, table_.outline(number));
        const double doubt = doubt_of(curve);
        for (std::uint32_t k = 1; k < n_; ++k) {
            const double part = double(k) / n_;
            set<2>(on_side(number, k), curve.at(part), {ends.a, ends.b}, {1.0 - part, part},
                   4.0 * part * (1.0 - part) * doubt);
        }
    }

    std::size_t on_side(std::size_t number, std::uint32_t k) const {
        return on_sides_ + number * (n_ - 1) + (k - 1);
    }

    /// A side of a cell in the direction of its outline, in `n` or, with a mid node, 2 `n` pieces.
    struct Run {
        VertexId from, mid, to;
        std::size_t first = 0, second = 0; ///< numbers of its pieces
    };

    Run run(const Cell& cell, std::size_t k) const {
        Run run{cell.corner[k], cell.mid[k], cell.corner[(k + 1) % 4]};
        if (run.mid == no_vertex) {
            run.first = table_.number(run.from, run.to);
        } else {
            run.first = table_.number(run.from, run.mid);
            run.second = table_.number(run.mid, run.to);
        }
        return run;
    }

    VertexId between(VertexId a, VertexId b, std::size_t number, std::uint32_t k) const {
        return k == 0    ? a
               : k == n_ ? b
                         : static_cast<VertexId>(on_side(number, a < b ? k : n_ - k));
    }

    /// Returns the vertex `k` pieces on.
    VertexId on_run(const Run& run, std::uint32_t k) const {
        if (run.mid == no_vertex)
            return between(run.from, run.to, run.first, k);
        return k < n_ ? between(run.from, run.mid, run.first, k)
                      : between(run.mid, run.to, run.second, k - n_);
    }

    void cut_cell(std::size_t c) {
        const Cell& cell = mesh_.cells[c];
        const std::array runs{run(cell, 0), run(cell, 1), run(cell, 2), run(cell, 3)};
        std::array<bool, 4> outline{};
        for (std::size_t k = 0; k < 4; ++k)
            outline[k] = table_.outline(runs[k].first);
        const CellPatch patch(curves_, cell, outline);
        flat_[c] = patch.flat_curves() > 0 ? 1 : 0;
        set_inner(c, patch);
        add_normals(c, patch, runs);
        set_cells(c, runs);
    }

    void set_inner(std::size_t c, const CellPatch& patch) {
        const Cell& cell = mesh_.cells[c];
        std::array<double, 4> doubt{};
        for (std::size_t k = 0; k < 4; ++k) {
            const PatchSide& side = patch.side(k);
            doubt[k] = side.mid ? std::max(doubt_of(side.first), doubt_of(side.second))
                                : doubt_of(side.first);
        }
        for (std::uint32_t j = 1; j < n_; ++j)
            for (std::uint32_t i = 1; i < n_; ++i) {
                const double u = double(i) / n_, v = double(j) / n_;
                const double p = 1.0 - u, q = 1.0 - v;
                const auto point = patch.at(u, v);
                const std::size_t at = inner(c, i, j);
                set<4>(at, point.value, cell.corner, {p * q, u * q, u * v, p * v},
                       4.0 * u * p * (q * doubt[0] + v * doubt[2]) +
                           4.0 * v * q * (u * doubt[1] + p * doubt[3]));
                made_.mesh.normal[at] = Vec3f(unit(glm::cross(point.u.position, point.v.position)));
            }
    }

    std::size_t inner(std::size_t c, std::uint32_t i, std::uint32_t j) const {
        return in_cells_ + (c * (n_ - 1) + (j - 1)) * (n_ - 1) + (i - 1);
    }

    /// Adds normals to the vertices of its outline; each piece of a side has a place for either cell beside
    /// it.
    void add_normals(std::size_t c, const CellPatch& patch, const std::array<Run, 4>& runs) {
        std::uint32_t vertex = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const Run& run = runs[k];
            const std::uint32_t pieces = run.mid == no_vertex ? n_ : 2 * n_;
            for (std::uint32_t i = 0; i < pieces; ++i) {
                const double part = double(i) / pieces;
                const std::array<double, 4> us{part, 1.0, 1.0 - part, 0.0};
                const std::array<double, 4> vs{0.0, part, 1.0, 1.0 - part};
                const auto point = patch.at(us[k], vs[k]);
                const Vec3 normal = unit(glm::cross(point.u.position, point.v.position));
                if (i % n_ == 0) {
                    corner_normal_[c][vertex++] = normal;
                    continue;
                }
                const VertexId from = i < n_ ? run.from : run.mid;
                const VertexId to = i < n_ && run.mid != no_vertex ? run.mid : run.to;
                const std::size_t piece = on_run(run, i) - on_sides_;
                side_normal_[2 * piece + (from < to ? 0 : 1)] = normal;
            }
        }
    }

    void set_cells(std::size_t c, const std::array<Run, 4>& runs) {
        const auto step = [&](std::size_t k) { return runs[k].mid == no_vertex ? 1u : 2u; };
        const auto at = [&](std::uint32_t i, std::uint32_t j) {
            if (j == 0)
                return on_run(runs[0], i * step(0));
            if (i == n_)
                return on_run(runs[1], j * step(1));
            if (j == n_)
                return on_run(runs[2], (n_ - i) * step(2));
            if (i == 0)
                return on_run(runs[3], (n_ - j) * step(3));
            return static_cast<VertexId>(inner(c, i, j));
        };
        for (std::uint32_t j = 0; j < n_; ++j)
            for (std::uint32_t i = 0; i < n_; ++i) {
                Cell& made = made_.mesh.cells[(c * n_ + j) * n_ + i];
                made.corner = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
                const std::array<bool, 4> on{j == 0, i + 1 == n_, j + 1 == n_, i == 0};
                const std::array<std::uint32_t, 4> piece{i, j, n_ - 1 - i, n_ - 1 - j};
                for (std::size_t k = 0; k < 4; ++k)
                    if (on[k] && step(k) == 2)
                        made.mid[k] = on_run(runs[k], 2 * piece[k] + 1);
            }
    }

    const QuadComplex& mesh_;
    const SideCurves& curves_;
    const SideTable& table_;
    std::uint32_t n_;
    std::size_t on_sides_, in_cells_; ///< where those begin
    Tessellation made_;
    std::vector<Vec3> normal_;      ///< of the vertices there were, summed up
    std::vector<Vec3> side_normal_; ///< of those on sides, by either cell
    std::vector<std::array<Vec3, 8>> corner_normal_;
    std::vector<std::uint8_t> flat_;
};

/// A vertex of the result takes so many bytes with what is needed to make it; a quad, those below.
constexpr std::size_t vertex_bytes_made = 180;
constexpr std::size_t cell_bytes_made = 32;

} // namespace

Result<Tessellation> tessellate(const QuadComplex& mesh,
                                std::uint32_t pieces,
                                const std::vector<double>& creases,
                                bool closed,
                                const WorkPart& work) {
    if (mesh.cells.empty())
        return fail(Error::Code::InvalidArgument, "an empty surface cannot be tessellated",
                    "leave `tessellate` out");
    if (pieces <= 1)
        return Tessellation{mesh, 0};
    const std::uint64_t quads = std::uint64_t{mesh.cells.size()} * pieces * pieces;
    if (quads > most_tessellated_quads)
        return fail(Error::Code::OverLimit,
                    "`tessellate` " + std::to_string(pieces) + " makes " + std::to_string(quads) +
                        " quads of " + std::to_string(mesh.cells.size()) + ": more than " +
                        std::to_string(most_tessellated_quads),
                    "tessellate less finely, or ask for a larger separation");
    if (auto room = work.takes(quads * (vertex_bytes_made + cell_bytes_made) +
                               mesh.cells.size() * sizeof(std::array<Vec3, 8>));
        !room)
        return tl::unexpected(room.error());
    const SideCurves curves(mesh, creases, closed);
    const SideTable table(mesh);
    return Cutter(mesh, curves, table, pieces).cut();
}

Result<Tessellation> tessellate(const SurfacePlan& plan,
                                const QuadComplex& mesh,
                                std::vector<double>& times,
                                std::uint32_t pieces,
                                const std::stop_token& stop,
                                const WorkPart& work) {
    const SurfaceParameters& p = plan.parameters;
    if (p.kind == SurfaceKind::Level && pieces > 1)
        return fail(Error::Code::InvalidArgument,
                    "`tessellate` is for surfaces that particles form: no tangents are known on a "
                    "level surface",
                    "leave it out");
    std::vector<double> creases = plan.seeding.corners();
    if (p.rake2) {
        const std::vector<double> others = SeedingCurve(*p.rake2).corners();
        creases.insert(creases.end(), others.begin(), others.end());
        std::sort(creases.begin(), creases.end());
    }
    auto made = tessellate(mesh, pieces, creases, plan.seeding.closed(), work);
    if (!made || pieces <= 1)
        return made;
    QuadComplex& fine = made->mesh;
    const std::size_t before = mesh.vertices();
    const double time = times.empty() ? p.from : times.front();
    times.resize(fine.vertices(), time);
    if (p.kind == SurfaceKind::Path)
        for (std::size_t v = before; v < times.size(); ++v)
            times[v] = p.from + fine.t[v];
    std::vector<Vec3> velocity(fine.vertices() - before);
    if (auto sampled = plan.flow->sample(std::span(fine.position).subspan(before),
                                         std::span(times).subspan(before), velocity, stop,
                                         p.interpolation == Interpolation::Smooth);
        !sampled)
        return tl::unexpected(sampled.error());
    std::copy(velocity.begin(), velocity.end(),
              fine.velocity.begin() + static_cast<std::ptrdiff_t>(before));
    return made;
}

} // namespace wakesurf::core
