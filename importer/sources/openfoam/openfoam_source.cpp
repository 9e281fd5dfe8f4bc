#include "importer/base/text.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/openfoam/openfoam_case.hpp"
#include "importer/sources/openfoam/openfoam_file.hpp"
#include "importer/sources/openfoam/openfoam_reader.hpp"

#include <vtkBoundingBox.h>
#include <vtkCell.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
namespace fs = std::filesystem;

namespace {

/// One side of a wedge.
struct WedgeSide {
    core::Vec3 normal; ///< outward, of length 1
    core::Vec3 point;
};

WedgeSide side_of(vtkDataSet& patch) {
    core::Vec3 area(0.0);
    core::Vec3 middle(0.0);
    double corners = 0.0;
    for (vtkIdType i = 0; i < patch.GetNumberOfCells(); ++i) {
        vtkPoints* const points = patch.GetCell(i)->GetPoints();
        const auto at = [&](vtkIdType k) {
            std::array<double, 3> p{};
            points->GetPoint(k, p.data());
            return core::Vec3(p[0], p[1], p[2]);
        };
        for (vtkIdType k = 0; k < points->GetNumberOfPoints(); ++k, corners += 1.0) {
            middle += at(k);
            if (k >= 2)
                area += 0.5 * glm::cross(at(k - 1) - at(0), at(k) - at(0));
        }
    }
    return {glm::normalize(area), middle / std::max(corners, 1.0)};
}

/// Returns the direction of a coordinate, if a vector of length 1 is that but for the rounding of points.
core::Vec3 to_coordinate(const core::Vec3& v) {
    constexpr double rounding = 1e-4;
    for (int k = 0; k < 3; ++k) {
        core::Vec3 axis(0.0);
        axis[k] = std::copysign(1.0, v[k]);
        if (glm::length(v - axis) < rounding)
            return axis;
    }
    return v;
}

class OpenfoamSource final : public Source {
  public:
    explicit OpenfoamSource(FoamCase found) : found_(std::move(found)) {
        for (const auto& part : found_.parts)
            if (OpenfoamReader reader(found_, part); reader.has_cells())
                readers_.push_back(std::move(reader));
        description_.name = found_.name;
        description_.reader = "vtkOpenFOAMReader (OpenFOAM" +
                              (found_.parts.size() > 1 || !found_.parts.front().empty()
                                   ? ", " + std::to_string(found_.parts.size()) + " processors)"
                                   : std::string(")"));
        for (const auto& time : found_.times)
            description_.times.push_back(time.value * found_.time_scale);
        description_.note = found_.note;
        description_.ignores_boundary_values = true;
        description_.fields = found_.fields;
        description_.velocity = found_.velocity;
        // A case without dimensions, or in units of its own, shows it in its fields.
        const bool metric = std::any_of(found_.fields.begin(), found_.fields.end(),
                                        [](const auto& field) { return field.unit == "m/s"; });
        if (metric) {
            description_.length_unit = "m";
            description_.time_unit = "s";
        }
        if (!found_.time_unit.empty())
            description_.time_unit = found_.time_unit;
    }

    OpenfoamSource(const OpenfoamSource&) = delete;
    OpenfoamSource& operator=(const OpenfoamSource&) = delete;

    /// Finds the ranges of the fields.
    core::Result<void> open() {
        auto first = read(0, found_.fields);
        // Initial fields written by hand may hold directives and groups of patches VTK does not know.
        if (!first && found_.times.size() > 1 && found_.times.front().value == 0.0) {
            leave_out_written_by_hand(first.error());
            first = read(0, found_.fields);
        }
        if (!first)
            return tl::unexpected(first.error());
        find_periodic_axes(first->blocks);
        if (auto axis = find_axis(); !axis)
            return axis;
        std::vector<FieldInfo> seen;
        for (const auto& block : first->blocks)
            add_fields(*block, seen);
        for (auto& field : description_.fields)
            for (const auto& other : seen)
                if (other.name == field.name)
                    field.range = other.range;
        return {};
    }

    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        std::vector<NamedFile> files;
        for (const auto& part : found_.parts)
            for (const auto& region : found_.regions)
                for (const char* const name : {"points", "faces", "owner", "neighbour", "boundary"})
                    files.push_back(found_.file_at(found_.mesh_file(part, region.name, name)));
        // Points may be those of a time folder.
        std::erase_if(files, [](const NamedFile& file) { return !foam_file(file.path); });
        return fingerprint(files);
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t step) const override {
        std::vector<NamedFile> files;
        for (const auto& part : found_.parts)
            for (const auto& region : found_.regions)
                for (const auto& field : found_.fields)
                    if (region.fluid)
                        files.push_back(found_.file_at(found_.relative(
                            part, found_.times.at(step).name, region.name, field.name)));
        return fingerprint(files);
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        const FoamTime& time = found_.times.at(step);
        SourceStep out;
        for (auto& reader : readers_) {
            auto leaves = reader.read(time, fields);
            if (!leaves)
                return tl::unexpected(leaves.error());
            for (auto& leaf : *leaves)
                if (auto taken = take(leaf, time, fields, out); !taken)
                    return tl::unexpected(taken.error());
        }
        if (out.blocks.empty())
            return core::fail(Error::Code::Corrupt, "the mesh of " + found_.file + " has no cells");
        return out;
    }

  private:
    // Leaves out a first time-step written by a person. A solver writes numbers only, so the later ones are
    // whole.
    void leave_out_written_by_hand(const Error& why) {
        for (const auto& part : found_.parts)
            for (const auto& region : found_.regions)
                for (const auto& field : found_.fields) {
                    const auto file = found_.file_at(
                        found_.relative(part, found_.times.front().name, region.name, field.name));
                    if (!region.fluid || !written_by_hand(file.path))
                        continue;
                    add_note(description_.note,
                             "time " + found_.times.front().name +
                                 " is left out: its fields are written by hand, and " +
                                 why.message);
                    found_.times.erase(found_.times.begin());
                    description_.times.erase(description_.times.begin());
                    return;
                }
    }

    core::Result<void>
    take(Leaf& leaf, const FoamTime& time, const std::vector<FieldInfo>& fields, SourceStep& out) {
        const auto known =
            std::find_if(found_.regions.begin(), found_.regions.end(),
                         [&](const FoamRegion& one) { return one.name == region_of(leaf); });
        if (known == found_.regions.end())
            return {}; // the whole mesh its regions were split from
        if (!known->fluid) {
            if (auto* surface = vtkPolyData::SafeDownCast(leaf.data)) {
                keep_only(*surface, {});
                out.solids.emplace_back(surface);
            }
            return {};
        }
        if (known->cyclic.contains(leaf.name())) {
            cyclic_[known->name + "/" + leaf.name()].AddBounds(leaf.data->GetBounds());
            return {};
        }
        if (known->wedges.contains(leaf.name())) {
            if (!description_.axis)
                wedge_sides_.push_back(side_of(*leaf.data));
            return {};
        }
        if (known->others.contains(leaf.name())) {
            if (auto* faces = vtkPolyData::SafeDownCast(leaf.data)) {
                keep_only(*faces, {});
                out.others.push_back({faces, false, leaf.name()});
            }
            return {};
        }
        const std::string file = time.name + " of " + found_.file;
        if (auto whole = require_fields(*leaf.data, fields, file); !whole) {
            // The file is there: VTK passes over one that cannot be unpacked.
            whole.error().code = Error::Code::Corrupt;
            whole.error().hint = "its file may be incomplete: copy it again";
            return whole;
        }
        keep_only(*leaf.data, fields);
        if (is_inside(leaf))
            out.blocks.push_back(leaf.data);
        else if (auto* faces = vtkPolyData::SafeDownCast(leaf.data))
            out.walls.push_back({faces, stands_still(*faces, fields), leaf.name()});
        return {};
    }

    // Returns the axis along which the flow goes on from one patch to another: they are conformal, and lie flat on opposite
    // sides of the box of all cells, at the same place of either. Nothing for any other pair.
    std::optional<std::size_t> axis_between(const FoamRegion& region,
                                            const std::string& name,
                                            const std::string& other,
                                            const vtkBoundingBox& all) const {
        const auto here = cyclic_.find(region.name + "/" + name);
        const auto there = cyclic_.find(region.name + "/" + other);
        if (here == cyclic_.end() || there == cyclic_.end() || !region.conformal.contains(name) ||
            !region.conformal.contains(other))
            return std::nullopt;
        const double slack = 1e-6 * all.GetDiagonalLength();
        const auto low = [](const vtkBoundingBox& box, int k) { return box.GetMinPoint()[k]; };
        const auto high = [](const vtkBoundingBox& box, int k) { return box.GetMaxPoint()[k]; };
        const auto near = [slack](double a, double b) { return std::abs(a - b) <= slack; };
        const auto flat = [&](const vtkBoundingBox& box, int k, double at) {
            return near(low(box, k), at) && near(high(box, k), at);
        };
        for (int axis = 0; axis < 3; ++axis) {
            const vtkBoundingBox& a = here->second;
            const vtkBoundingBox& b = there->second;
            bool between = !near(low(all, axis), high(all, axis)) &&
                           ((flat(a, axis, low(all, axis)) && flat(b, axis, high(all, axis))) ||
                            (flat(b, axis, low(all, axis)) && flat(a, axis, high(all, axis))));
            for (int k = 0; k < 3; ++k)
                between = between && (k == axis ||
                                      (near(low(a, k), low(b, k)) && near(high(a, k), high(b, k))));
            if (between)
                return static_cast<std::size_t>(axis);
        }
        return std::nullopt;
    }

    // Finds the axes along which the flow repeats: patches on both sides take all of those. The note says of all cyclic
    // patches how far apart they are, by the middles of their boxes.
    void find_periodic_axes(const std::vector<vtkSmartPointer<vtkDataSet>>& blocks) {
        vtkBoundingBox all;
        for (const auto& block : blocks)
            all.AddBounds(block->GetBounds());
        std::array<vtkBoundingBox, 3> sides; // of the patches on the lower and upper sides alike
        std::array<std::string, 3> on;
        std::string apart;
        for (const auto& region : found_.regions)
            for (const auto& [name, other] : region.cyclic) {
                if (!region.fluid || (region.cyclic.contains(other) && other < name))
                    continue;
                const std::string words = words_on_cyclic(region, name, other);
                const auto axis = axis_between(region, name, other, all);
                std::string& pairs = axis ? on[*axis] : apart;
                pairs += (pairs.empty() ? "" : ", ") + words;
                if (axis)
                    sides[*axis].AddBox(cyclic_.at(region.name + "/" + name));
            }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (on[axis].empty())
                continue;
            bool whole = true;
            for (int k = 0; k < 3; ++k)
                whole = whole && (k == static_cast<int>(axis) ||
                                  sides[axis].GetLength(k) >=
                                      all.GetLength(k) - 2e-6 * all.GetDiagonalLength());
            if (!whole) {
                apart += (apart.empty() ? "" : ", ") + on[axis];
                continue;
            }
            description_.periodic[axis] = true;
            add_note(description_.note, "the flow repeats along " + std::string(1, "xyz"[axis]) +
                                            ": it goes on from one cyclic patch to another (" +
                                            on[axis] + "), and so do particles");
        }
        if (!apart.empty())
            add_note(description_.note, "the flow goes on from one cyclic patch to another (" +
                                            apart + "), particles do not: they end there");
    }

    std::string words_on_cyclic(const FoamRegion& region,
                                const std::string& name,
                                const std::string& other) const {
        const std::string pair = name + (other.empty() ? "" : " to " + other);
        const auto here = cyclic_.find(region.name + "/" + name);
        const auto there = cyclic_.find(region.name + "/" + other);
        if (here == cyclic_.end() || there == cyclic_.end())
            return pair;
        std::array<double, 3> a{};
        std::array<double, 3> b{};
        here->second.GetCenter(a.data());
        there->second.GetCenter(b.data());
        return pair + ", " + length_text(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])) +
               " apart";
    }

    // Finds the axis of a wedge from its two sides: they meet in it. OpenFOAM wants the plane between them to be one
    // of the coordinates'. Error: Unsupported.
    core::Result<void> find_axis() {
        if (wedge_sides_.empty())
            return {};
        const auto refused =
            core::fail(Error::Code::Unsupported,
                       "the patches of the type wedge of " + found_.file +
                           " are not two planes that meet in an axis",
                       "make the wedge with one patch of that type on either side");
        const WedgeSide& one = wedge_sides_.front();
        const auto& other = *std::ranges::min_element(wedge_sides_, {}, [&](const WedgeSide& side) {
            return glm::dot(one.normal, side.normal);
        });
        const core::Vec3 apart = one.normal - other.normal;
        const core::Vec3 inward = one.normal + other.normal;
        if (!(glm::length(apart) > 1.0) || !(glm::length(inward) > 1e-6))
            return refused;
        core::SymmetryAxis axis;
        const core::Vec3 across = to_coordinate(glm::normalize(apart));
        axis.radial = to_coordinate(glm::normalize(-(inward - glm::dot(inward, across) * across)));
        const double a = glm::dot(one.normal, one.point);
        const double b = glm::dot(other.normal, other.point);
        axis.origin =
            -(a + b) / glm::length(inward) * axis.radial + (a - b) / glm::length(apart) * across;
        if (glm::length(axis.origin) < 1e-6 * glm::length(one.point))
            axis.origin = core::Vec3(0.0); // but for the rounding of the points
        if (glm::dot(one.point - axis.origin, axis.radial) < 0.0)
            axis.radial = -axis.radial; // the files' normals point inward
        axis.direction = glm::normalize(glm::cross(axis.radial, across));
        description_.axis = axis;
        const double degrees =
            2.0 * std::asin(std::min(1.0, 0.5 * glm::length(inward))) * 180.0 / std::numbers::pi;
        add_note(description_.note,
                 "an axisymmetric flow, drawn all the way round: the mesh is a wedge of " +
                     length_text(degrees) + " degrees");
        return {};
    }

    FoamCase found_;
    std::vector<OpenfoamReader> readers_;
    std::vector<WedgeSide> wedge_sides_;
    std::map<std::string, vtkBoundingBox> cyclic_; ///< of such patches: REGION/NAME
};

} // namespace

bool is_openfoam(const fs::path& path) {
    std::error_code error;
    const std::string ending = path.extension().string();
    if (!fs::is_directory(path, error) && ending != ".foam" && ending != ".OpenFOAM" &&
        path.filename() != "controlDict")
        return false;
    const fs::path folder = openfoam_folder(path);
    return fs::is_regular_file(folder / "system" / "controlDict", error) ||
           fs::is_directory(folder / "constant", error) ||
           fs::is_directory(folder / "processor0" / "constant", error) || ending == ".foam" ||
           ending == ".OpenFOAM";
}

Opened open_openfoam(const fs::path& path, const command::SourceOptions& wish) {
    return scan_openfoam_case(path, wish.velocity).and_then([](FoamCase found) {
        return opened<OpenfoamSource>(std::move(found));
    });
}

} // namespace wakesurf::importer
