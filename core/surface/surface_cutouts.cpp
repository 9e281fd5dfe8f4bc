#include "core/surface/surface_cutouts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace wakesurf::core {

namespace {

/// A corner of a polygon that is being cut: its place, and two numbers that are linear on it.
struct Corner {
    Vec3 position;
    double a, b;
};

using Piece = std::vector<Corner>;

/// Keeps where c0 + ca a + cb b >= 0.
struct HalfPlane {
    double c0, ca, cb;

    double at(const Corner& corner) const { return c0 + ca * corner.a + cb * corner.b; }
};

/// Sutherland and Hodgman 1974.
Piece cut(const Piece& piece, const HalfPlane& keep) {
    Piece out;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const Corner& here = piece[i];
        const Corner& next = piece[(i + 1) % piece.size()];
        const double at_here = keep.at(here);
        const double at_next = keep.at(next);
        if (at_here >= 0.0)
            out.push_back(here);
        if ((at_here > 0.0 && at_next < 0.0) || (at_here < 0.0 && at_next > 0.0)) {
            const double part = at_here / (at_here - at_next);
            out.push_back({glm::mix(here.position, next.position, part),
                           std::lerp(here.a, next.a, part), std::lerp(here.b, next.b, part)});
        }
    }
    return out;
}

void add(Cutouts& out, Piece piece, std::span<const HalfPlane> shape, double value) {
    for (const HalfPlane& side : shape) {
        piece = cut(piece, side);
        if (piece.size() < 3)
            return;
    }
    for (const Corner& corner : piece) {
        out.connectivity.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.points.push_back(corner.position);
    }
    out.ends.push_back(static_cast<std::uint32_t>(out.connectivity.size()));
    out.value.push_back(value);
}

/// Cells by where they are, for asking which are near a place.
class CellsByPlace {
  public:
    CellsByPlace(const QuadComplex& mesh, double size) : size_(size) {
        for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
            const CellPolygon outline = polygon(mesh.cells[i]);
            Vec3 lo = mesh.position[outline.vertex[0]];
            Vec3 hi = lo;
            for (std::uint32_t k = 1; k < outline.count; ++k) {
                lo = glm::min(lo, mesh.position[outline.vertex[k]]);
                hi = glm::max(hi, mesh.position[outline.vertex[k]]);
            }
            visit(lo, hi, [&](const Key& key) { cells_[key].push_back(i); });
        }
    }

    /// Ascending, each once.
    std::vector<std::size_t> near(const Vec3& p, double reach) const {
        std::vector<std::size_t> found;
        visit(p - reach, p + reach, [&](const Key& key) {
            if (const auto here = cells_.find(key); here != cells_.end())
                found.insert(found.end(), here->second.begin(), here->second.end());
        });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

  private:
    using Key = std::tuple<long, long, long>;

    template <class Visit>
    void visit(const Vec3& lo, const Vec3& hi, const Visit& each) const {
        const auto step = [&](double x) { return static_cast<long>(std::floor(x / size_)); };
        for (long x = step(lo.x); x <= step(hi.x); ++x)
            for (long y = step(lo.y); y <= step(hi.y); ++y)
                for (long z = step(lo.z); z <= step(hi.z); ++z)
                    each(Key{x, y, z});
    }

    double size_;
    std::map<Key, std::vector<std::size_t>> cells_;
};

/// Of boxes that few cells share and no cell is in thousands of.
double box_size(const QuadComplex& mesh) {
    double sum = 0.0;
    double largest = 0.0;
    for (const Cell& cell : mesh.cells) {
        const double across =
            glm::length(mesh.position[cell.corner[2]] - mesh.position[cell.corner[0]]) +
            glm::length(mesh.position[cell.corner[3]] - mesh.position[cell.corner[1]]);
        sum += across;
        largest = std::max(largest, across);
    }
    return mesh.cells.empty()
               ? 1.0
               : std::max(sum / static_cast<double>(mesh.cells.size()), largest / 16.0);
}

/// Where an arrow begins: on a line, with the flow's direction and time there.
struct Anchor {
    Vec3 position, direction;
    double time, unit;
};

constexpr double arrow_length = 3.0; ///< widths

/// One arrow's two parts in a: across, b: along, in widths; both convex.
constexpr HalfPlane shaft[]{
    {1.0 / 6.0, 1.0, 0.0}, {1.0 / 6.0, -1.0, 0.0}, {0.0, 0.0, 1.0}, {2.0, 0.0, -1.0}};
constexpr HalfPlane head[]{{-2.0, 0.0, 1.0}, {1.5, 1.0, -0.5}, {1.5, -1.0, -0.5}};

/// Every `spacing` along a line, the first half of that from its end.
std::vector<Anchor> anchors_on(const ContourLine& line, double spacing, double length) {
    std::vector<Anchor> anchors;
    double next = 0.5 * spacing;
    double gone = 0.0;
    const double total = length_of(line);
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const Vec3 way = line.points[i] - line.points[i - 1];
        const double step = glm::length(way);
        for (; next <= gone + step && next + length <= total; next += spacing) {
            const double part = (next - gone) / step;
            anchors.push_back({line.points[i - 1] + part * way, way / step, 0.0,
                               std::lerp(line.carried[i - 1], line.carried[i], part)});
        }
        gone += step;
    }
    return anchors;
}

} // namespace

Result<Cutouts> ribbons(const QuadComplex& mesh,
                        std::span<const double> parameter,
                        std::span<const double> unit,
                        std::span<const EvenLevel> levels,
                        double width,
                        bool wraps) {
    const auto length_at = [&](VertexId v) { return std::isfinite(unit[v]) ? unit[v] : 0.0; };
    Cutouts out;
    for (const Cell& cell : mesh.cells) {
        const CellPolygon outline = polygon(cell);
        const auto values = outline_values(outline, parameter, wraps);
        for (const EvenLevel& level : levels) {
            // One that wraps has its line at 1, and its ribbon on either side: at 0 as well.
            for (const double turn : {0.0, 1.0}) {
                std::array<double, 8> away{};
                for (std::uint32_t i = 0; i < outline.count; ++i)
                    away[i] = (values[i] + turn - level.value) * length_at(outline.vertex[i]);
                const auto [low, high] =
                    std::minmax_element(away.begin(), away.begin() + outline.count);
                if (*low<0.5 * width&& * high> - 0.5 * width) {
                    Piece piece;
                    for (std::uint32_t i = 0; i < outline.count; ++i)
                        piece.push_back({mesh.position[outline.vertex[i]], away[i],
                                         length_at(outline.vertex[i]) - level.least_length});
                    add(out, std::move(piece),
                        std::array<HalfPlane, 3>{
                            {{0.5 * width, 1.0, 0.0}, {0.5 * width, -1.0, 0.0}, {0.0, 0.0, 1.0}}},
                        level.value);
                    if (out.ends.size() > most_cutouts)
                        return over_limit(most_cutouts,
                                          "the ribbons would have more than " +
                                              std::to_string(most_cutouts) + " polygons",
                                          "give a smaller width or fewer ribbons");
                }
                if (!wraps || level.value < 1.0)
                    break;
            }
        }
    }
    return out;
}

Result<Cutouts> arrows(const QuadComplex& mesh,
                       std::span<const ContourLine> lines,
                       double spacing,
                       double width,
                       bool wraps) {
    Cutouts out;
    const double length = arrow_length * width;
    double count = 0.0;
    for (const ContourLine& line : lines)
        count += length_of(line) / spacing;
    if (count > most_arrows)
        return over_limit(most_arrows,
                          "there would be more than " + std::to_string(most_arrows) + " arrows",
                          "give a larger distance between them");
    const CellsByPlace cells(mesh, std::max(2.0 * length, box_size(mesh)));
    for (const ContourLine& line : lines)
        for (Anchor anchor : anchors_on(line, spacing, length)) {
            // The line runs one way or the other; the flow says which way the arrow points.
            const auto around = cells.near(anchor.position, 1.5 * length);
            double nearest = std::numeric_limits<double>::infinity();
            Vec3 flow(0.0);
            for (const std::size_t c : around)
                for (const VertexId v : mesh.cells[c].corner)
                    if (const double away = glm::length(mesh.position[v] - anchor.position);
                        away < nearest) {
                        nearest = away;
                        flow = Vec3(mesh.velocity[v]);
                        anchor.time = mesh.t[v];
                    }
            if (glm::dot(flow, anchor.direction) < 0.0) {
                anchor.position += length * anchor.direction;
                anchor.direction = -anchor.direction;
            }
            const double speed = glm::length(flow);
            for (const std::size_t c : around) {
                const CellPolygon outline = polygon(mesh.cells[c]);
                auto values = outline_values(outline, mesh.s, wraps);
                Piece piece;
                bool same_sheet = false; // another layer of the surface may lie as near
                for (std::uint32_t i = 0; i < outline.count; ++i) {
                    const VertexId v = outline.vertex[i];
                    double apart = values[i] - line.value;
                    if (wraps)
                        apart -= std::round(apart);
                    same_sheet =
                        same_sheet || std::abs(mesh.t[v] - anchor.time) * speed < 3.0 * length;
                    piece.push_back(
                        {mesh.position[v], apart * anchor.unit / width,
                         glm::dot(mesh.position[v] - anchor.position, anchor.direction) / width});
                }
                if (!same_sheet)
                    continue;
                add(out, piece, shaft, line.value);
                add(out, std::move(piece), head, line.value);
            }
        }
    return out;
}

} // namespace wakesurf::core
