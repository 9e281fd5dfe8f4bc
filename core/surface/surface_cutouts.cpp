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

/// Cuts a piece by a half plane: Sutherland and Hodgman 1974.
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

/// Returns the area of what it has added, in a and b.
double add(Cutouts& out, Piece piece, std::span<const HalfPlane> shape, double value) {
    for (const HalfPlane& side : shape) {
        piece = cut(piece, side);
        if (piece.size() < 3)
            return 0.0;
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const Corner& next = piece[(i + 1) % piece.size()];
        twice += piece[i].a * next.b - next.a * piece[i].b;
    }
    for (const Corner& corner : piece) {
        out.connectivity.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.points.push_back(corner.position);
    }
    out.ends.push_back(static_cast<std::uint32_t>(out.connectivity.size()));
    out.value.push_back(value);
    return 0.5 * std::abs(twice);
}

/// Takes back what has been added since `before`.
void take_back(Cutouts& out, const Cutouts::Size& before) {
    out.points.resize(before.points);
    out.connectivity.resize(before.points);
    out.ends.resize(before.polygons);
    out.value.resize(before.polygons);
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

    /// Returns the cells near a point, ascending, each once.
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

/// Returns the size of boxes that few cells share, such that no cell is in thousands of them.
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

/// The beginning of an arrow.
struct Anchor {
    Vec3 position, direction;
    double s, unit; ///< how long a unit of s is there
};

constexpr double arrow_length = 3.0; ///< widths

/// An arrow has two parts, in a: across, b: along, in widths; both convex.
constexpr HalfPlane shaft[]{
    {1.0 / 6.0, 1.0, 0.0}, {1.0 / 6.0, -1.0, 0.0}, {0.0, 0.0, 1.0}, {2.0, 0.0, -1.0}};
constexpr HalfPlane head[]{{-2.0, 0.0, 1.0}, {1.5, 1.0, -0.5}, {1.5, -1.0, -0.5}};
constexpr double arrow_area = 2.0 / 3.0 + 0.5; ///< square widths

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
            anchors.push_back({line.points[i - 1] + part * way, way / step, line.value,
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

namespace {

/// The surface round an anchor: at the nearest vertex.
struct Surroundings {
    Vec3 flow{0.0}, normal{0.0};
    double t = 0.0, unit_of_t = 0.0;
};

Surroundings surroundings(const QuadComplex& mesh,
                          std::span<const std::size_t> cells,
                          std::span<const double> unit_of_t,
                          const Vec3& place) {
    double nearest = std::numeric_limits<double>::infinity();
    VertexId vertex = no_vertex;
    for (const std::size_t c : cells)
        for (const VertexId v : mesh.cells[c].corner)
            if (const double away = glm::length(mesh.position[v] - place); away < nearest) {
                nearest = away;
                vertex = v;
            }
    Surroundings out;
    if (vertex == no_vertex)
        return out;
    out.flow = Vec3(mesh.velocity[vertex]);
    out.t = mesh.t[vertex];
    out.unit_of_t = std::isfinite(unit_of_t[vertex]) ? unit_of_t[vertex] : 0.0;
    for (const std::size_t c : cells) {
        const auto& corner = mesh.cells[c].corner;
        if (std::find(corner.begin(), corner.end(), vertex) != corner.end())
            out.normal += glm::cross(mesh.position[corner[2]] - mesh.position[corner[0]],
                                     mesh.position[corner[3]] - mesh.position[corner[1]]);
    }
    return out;
}

} // namespace

Result<Cutouts> arrows(const QuadComplex& mesh,
                       std::span<const ContourLine> lines,
                       double spacing,
                       double width,
                       const ArrowOptions& options) {
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
    const std::vector<double> unit_of_t = lengths_per_unit(mesh, mesh.t, false);
    for (const ContourLine& line : lines)
        for (Anchor anchor : anchors_on(line, spacing, options.along_lines ? length : 0.0)) {
            const auto around = cells.near(anchor.position, 1.5 * length);
            const Surroundings here = surroundings(mesh, around, unit_of_t, anchor.position);
            Vec3 across(0.0);
            if (!options.along_lines) {
                const Vec3 tangential =
                    here.flow - here.normal * glm::dot(here.normal, here.flow) /
                                    std::max(glm::dot(here.normal, here.normal), 1e-300);
                if (!(glm::length(tangential) > 0.0) || !(glm::length(here.normal) > 0.0))
                    continue;
                anchor.direction = glm::normalize(tangential);
                across = glm::cross(glm::normalize(here.normal), anchor.direction) / width;
                anchor.position -= 0.5 * length * anchor.direction;
            } else if (glm::dot(here.flow, anchor.direction) < 0.0) {
                // The line runs one way or the other; the flow says which way the arrow points.
                anchor.position += length * anchor.direction;
                anchor.direction = -anchor.direction;
            }
            const Cutouts::Size before{out.points.size(), out.ends.size()};
            double area = 0.0;
            for (const std::size_t c : around) {
                const CellPolygon outline = polygon(mesh.cells[c]);
                const auto values = outline_values(outline, mesh.s, options.wraps);
                Piece piece;
                bool same_sheet = false; // another layer of the surface may lie as near
                for (std::uint32_t i = 0; i < outline.count; ++i) {
                    const VertexId v = outline.vertex[i];
                    double apart = values[i] - anchor.s;
                    if (options.wraps)
                        apart -= std::round(apart);
                    apart *= anchor.unit;
                    same_sheet = same_sheet ||
                                 (std::abs(mesh.t[v] - here.t) * here.unit_of_t < 3.0 * length &&
                                  std::abs(apart) < 3.0 * length);
                    const Vec3 away = mesh.position[v] - anchor.position;
                    piece.push_back({mesh.position[v],
                                     options.along_lines ? apart / width : glm::dot(away, across),
                                     glm::dot(away, anchor.direction) / width});
                }
                if (!same_sheet)
                    continue;
                area += add(out, piece, shaft, line.value);
                area += add(out, std::move(piece), head, line.value);
            }
            // A cutout that reaches over a border is left out. In the surface none is smaller than flat,
            // whichever way that bends.
            if (!options.along_lines && area < (1.0 - 1e-5) * arrow_area)
                take_back(out, before);
        }
    return out;
}

} // namespace wakesurf::core
