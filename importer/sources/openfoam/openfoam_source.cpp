#include "importer/base/notes.hpp"
#include "importer/sources/blocks/wall_patches.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/openfoam/openfoam_file.hpp"
#include "importer/sources/openfoam/openfoam_reader.hpp"
#include "importer/sources/openfoam/openfoam_scan.hpp"

#include <vtkBoundingBox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
namespace fs = std::filesystem;

namespace {

class OpenfoamSource final : public Source {
  public:
    explicit OpenfoamSource(FoamCase found) : found_(std::move(found)) {
        for (const auto& part : found_.parts)
            readers_.emplace_back(found_, part);
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
        add_note(description_.note, note_on_cyclic());
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
            out.walls.push_back({faces, stands_still(*faces, fields)});
        return {};
    }

    // Returns how far apart cyclic patches are, by the middles of their boxes: they have the same shape.
    std::string note_on_cyclic() const {
        std::string pairs;
        for (const auto& region : found_.regions)
            for (const auto& [name, other] : region.cyclic) {
                if (!region.fluid || (region.cyclic.contains(other) && other < name))
                    continue;
                pairs += (pairs.empty() ? "" : ", ") + name + (other.empty() ? "" : " to " + other);
                const auto here = cyclic_.find(region.name + "/" + name);
                const auto there = cyclic_.find(region.name + "/" + other);
                if (here == cyclic_.end() || there == cyclic_.end())
                    continue;
                std::array<double, 3> a{};
                std::array<double, 3> b{};
                here->second.GetCenter(a.data());
                there->second.GetCenter(b.data());
                pairs += ", " + length_text(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2])) +
                         " apart";
            }
        return pairs.empty() ? ""
                             : "the flow goes on from one cyclic patch to another (" + pairs +
                                   "), particles do not: they end there";
    }

    FoamCase found_;
    std::vector<OpenfoamReader> readers_;
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
