#include "core/base/disk.hpp"
#include "importer/assembly/same_mesh.hpp"
#include "importer/base/slab_mark.hpp"
#include "importer/base/text.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/plane_slab.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/series/series_source.hpp"
#include "importer/sources/vtk/vtk_file.hpp"
#include "importer/sources/vtk/xml_header.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

constexpr std::array xml_extensions{".vti",  ".vtr",  ".vts",  ".vtu",  ".vtp",
                                    ".pvti", ".pvtr", ".pvts", ".pvtu", ".pvtp"};

bool is_xml(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return std::find(xml_extensions.begin(), xml_extensions.end(), extension) !=
           xml_extensions.end();
}

// Decides by the extension that it is one of VTK's XML formats, legacy .vtk or VTKHDF.
bool is_vtk_file(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return is_xml(path) || extension == ".vtk" || extension == ".vtm" || extension == ".vtmb" ||
           is_hdf(path);
}

// Reads a file, without arrays that are not wanted if the format allows that. Error: Io, Corrupt,
// Unsupported, OverLimit (memory). REQUIRES: no VtkMessages lives, as of the next two.
core::Result<VtkFile> read_vtk_file(const ListedFile& file, const WantedArrays& wanted) {
    if (is_hdf(file.path))
        return read_hdf_file(file, wanted);
    return is_xml(file.path) ? read_xml_file(file, wanted) : read_legacy_file(file);
}

// Returns the time that the file itself states, if any: for a .vtm or .pvtu not those of the files it names.
core::Result<StatedTime> vtk_file_time(const ListedFile& file) {
    if (is_xml(file.path) || names_others(file.path))
        return xml_file_time(file);
    return read_vtk_file(file, {}).map([&](const VtkFile& read) {
        StatedTime out;
        for (const auto& [name, means] : time_arrays)
            if (auto* array = read.data->GetFieldData()->GetArray(name);
                array != nullptr && array->GetNumberOfValues() > 0 &&
                std::isfinite(array->GetTuple1(0)))
                out.*means = array->GetTuple1(0);
        if (!out.time && lower_extension(file.path) == ".vtk")
            if ((out.time = legacy_title_time(file)))
                out.in_title = true;
        return out;
    });
}

CompositeFile& append(CompositeFile& whole, CompositeFile part) {
    std::move(part.files.begin(), part.files.end(), std::back_inserter(whole.files));
    std::move(part.leaves.begin(), part.leaves.end(), std::back_inserter(whole.leaves));
    if (!part.cut.empty())
        whole.cut = std::move(part.cut);
    return whole;
}

bool has_ghosts(vtkDataSet& data) {
    const char* name = vtkDataSetAttributes::GhostArrayName();
    return data.GetPointData()->HasArray(name) != 0 || data.GetCellData()->HasArray(name) != 0;
}

class VtkFilesSource final : public Source {
  public:
    VtkFilesSource(FileSeries series, std::string velocity)
        : series_(std::move(series)), velocity_(std::move(velocity)) {}

    core::Result<void> open() {
        description_.name = series_.name;
        if (auto there = check_presence(); !there)
            return there;
        return find_times().and_then([&] { return describe(0); });
    }

    // Returns none: a .pvd or .series lists files and times of the time-steps, whose own changes are seen. It
    // grows with the series, whose old time-steps stay good.
    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        return std::vector<store::SourceFile>();
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t step) const override {
        return expand_step(step).and_then(
            [](const CompositeFile& all) { return fingerprint(all.files); });
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        auto all = expand_step(step);
        if (!all)
            return tl::unexpected(all.error());
        SourceStep out;
        std::string named;
        auto described = take_described(step, *all);
        for (std::size_t i = 0; i < all->leaves.size(); ++i) {
            const auto& leaf = all->leaves[i];
            const auto known = described.find(i);
            auto file = known != described.end() ? core::Result<VtkFile>(std::move(known->second))
                                                 : read_vtk_file(leaf, {false, fields});
            if (!file)
                return tl::unexpected(file.error());
            if (is_patch(*file->data, all->leaves.size())) {
                if (auto added = add_wall(*all, i, *file->data, fields, out); !added)
                    return tl::unexpected(added.error());
                continue;
            }
            auto block = sound_part(*file->data, place_of(*all, i), leaf.name);
            if (!block)
                return tl::unexpected(block.error());
            if (solids_.contains(place_of(*all, i))) {
                out.solids.push_back(boundary_of(**block));
                continue;
            }
            if (auto whole = require_fields(**block, fields, leaf.name); !whole)
                return tl::unexpected(whole.error());
            keep_only(**block, fields);
            out.blocks.push_back(std::move(*block));
            named = named.empty() ? leaf.name : named;
        }
        if (out.blocks.empty())
            return core::fail(Error::Code::Unsupported,
                              entry_name(step) + " holds no three-dimensional cells",
                              "extrude it by two cells or more first");
        return out;
    }

    // Returns nothing of legacy files and VTKHDF: only reading them whole would tell.
    std::optional<std::vector<FieldInfo>> fields_at(std::size_t step) override {
        const auto unreadable = [&](const Error& why) {
            if (ends_series(why) || why.code == Error::Code::NotFound)
                description_.unreadable.emplace(step, why);
            return std::nullopt;
        };
        const auto all = expand_step(step);
        if (!all)
            return unreadable(all.error());
        std::vector<FieldInfo> out;
        const auto is_listed = [&](const FieldInfo& field) {
            return std::ranges::any_of(out, [&](const FieldInfo& other) {
                return other.name == field.name && other.source == field.source;
            });
        };
        const auto& known = description_.fields;
        const bool with_velocity = choose_velocity(known, velocity_).has_value();
        for (const auto& leaf : all->leaves) {
            // Most often the first of many has them all.
            if (with_velocity && std::ranges::all_of(known, is_listed))
                break;
            const auto here =
                is_xml(leaf.path) ? xml_file_fields(leaf) : core::Result<std::vector<FieldInfo>>();
            if (!here)
                return unreadable(here.error());
            if (!is_xml(leaf.path))
                return std::nullopt;
            for (const auto& field : across_ ? slab_fields(*here, *across_) : *here)
                if (!is_listed(field))
                    out.push_back(field);
        }
        return out;
    }

    core::Result<void> describe_by(std::size_t step) override {
        return step == described_step_ ? core::Result<void>() : describe(step);
    }

  private:
    // Returns what was read to describe the source, once, if it is this time-step and its files are
    // unchanged.
    std::map<std::size_t, VtkFile> take_described(std::size_t step, const CompositeFile& all) {
        auto taken = std::exchange(described_, {});
        if (step != described_step_ || taken.empty())
            return {};
        const auto now = fingerprint(all.files);
        return now && *now == described_from_ ? std::move(taken) : std::map<std::size_t, VtkFile>();
    }

    // Returns fluid_part; a mesh that equals one found sound is not checked again.
    core::Result<vtkSmartPointer<vtkDataSet>>
    sound_part(vtkDataSet& data, const std::string& place, const std::string& file) {
        const auto known = sound_.find(place);
        if (known != sound_.end() && same_block(*known->second, data)) {
            share_mesh(*known->second, data);
            return vtkSmartPointer<vtkDataSet>(&data);
        }
        auto block = fluid_part(data, file);
        if (block && block->Get() == &data && vtkPointSet::SafeDownCast(&data) != nullptr &&
            known == sound_.end())
            sound_.emplace(place, without_values(Blocks{*block}).front());
        return block;
    }

    const std::string& entry_name(std::size_t step) const {
        return series_.entries[step].parts.front().name;
    }

    core::Result<CompositeFile> expand_step(std::size_t step) const {
        CompositeFile all;
        for (const auto& part : series_.entries[step].parts) {
            auto expanded = expand(part);
            if (!expanded)
                return expanded;
            append(all, std::move(*expanded));
        }
        if (all.leaves.empty())
            return core::fail(Error::Code::Corrupt, entry_name(step) + " names no files");
        if (!all.cut.empty() && step > 0 && all.leaves.size() < leaves_)
            return core::fail(Error::Code::Corrupt, all.cut + " ends too early: it lists " +
                                                        std::to_string(all.leaves.size()) + " of " +
                                                        std::to_string(leaves_) + " files");
        return all;
    }

    core::Result<void> check_presence() const {
        const core::PosixDisk disk;
        for (const auto& entry : series_.entries)
            for (const auto& part : entry.parts) {
                const auto size = disk.size(part.path);
                const bool gone = !size && size.error().code == Error::Code::NotFound;
                if (gone && !series_.note.empty() && &entry != &series_.entries.front())
                    continue; // the run was killed before it was written: the data end there
                if (gone && !series_.index.empty())
                    return core::fail(Error::Code::NotFound,
                                      series_.index.front().filename().string() + " names " +
                                          part.name + ", which does not exist");
                if (!size)
                    return tl::unexpected(size.error());
                // A file behind the first may be about to be written: it fails when the import reaches it.
                if (*size == 0 && &part == &series_.entries.front().parts.front())
                    return core::fail(Error::Code::Corrupt, part.name + " is empty");
                if (!is_vtk_file(part.path))
                    return core::fail(Error::Code::Unsupported,
                                      part.name + " is of a format that a collection cannot hold");
            }
        return {};
    }

    core::Result<void> find_times() {
        std::vector<TimedEntry> entries;
        for (std::size_t step = 0; step < series_.entries.size(); ++step) {
            entries.push_back({entry_name(step), series_.entries[step].time, std::nullopt,
                               series_.entries[step].number});
            if (series_.entries.front().time)
                continue;
            auto own = own_time(step);
            if (!own && step == 0)
                return tl::unexpected(own.error());
            if (!own) {
                entries.back().unreadable = own.error();
                continue;
            }
            entries.back().time = own->time;
            entries.back().cycle = own->cycle;
            entries.back().in_title = own->in_title;
        }
        return describe_times(std::move(entries), description_).map([&](const auto& order) {
            keep_in_order(series_.entries, order);
            add_note(description_.time_note, written_again(series_.left_out));
            add_note(description_.time_note, series_.note);
        });
    }

    // Returns the own time of a file that names others; if it states none, that of the first of them that is
    // no list.
    core::Result<StatedTime> own_time(std::size_t step) const {
        const auto all = expand(series_.entries[step].parts.front());
        if (!all)
            return tl::unexpected(all.error());
        StatedTime stated;
        for (const auto& file : all->files) {
            auto own = vtk_file_time(file);
            if (!own)
                return own;
            if (!own->cycle)
                own->cycle = stated.cycle;
            stated = *own;
            if (stated.time || !names_others(file.path))
                break;
        }
        return stated;
    }

    core::Result<void> describe(std::size_t step) {
        auto all = expand_step(step);
        if (!all)
            return tl::unexpected(all.error());
        described_step_ = step;
        described_.clear();
        solids_.clear();
        description_.note.clear();
        leaves_ = all->leaves.size();
        if (!all->cut.empty())
            add_note(description_.note, all->cut + " ends too early: the files that it lists, " +
                                            std::to_string(leaves_) + ", are read");
        const auto before = fingerprint(all->files);
        if (before)
            described_from_ = *before;
        Blocks blocks;
        std::vector<std::string> places; // of each
        for (std::size_t i = 0; i < all->leaves.size(); ++i) {
            const auto& leaf = all->leaves[i];
            auto file = read_vtk_file(leaf, {true, {}});
            if (!file)
                return tl::unexpected(file.error());
            // The pieces of a parallel file are asked for the fields as well; ghosts are read only where they
            // are wanted.
            if (before && !lower_extension(leaf.path).starts_with(".p") && !has_ghosts(*file->data))
                described_.emplace(i, *file);
            if (is_patch(*file->data, all->leaves.size()))
                continue;
            auto block = sound_part(*file->data, place_of(*all, i), leaf.name);
            if (!block)
                return tl::unexpected(block.error());
            places.push_back(place_of(*all, i));
            blocks.push_back(std::move(*block));
            if (description_.reader.empty())
                description_.reader = file->reader + " (" + series_.kind + ")";
        }
        if (blocks.empty() && !plane_) { // all parts are flat: of a plane flow
            plane_ = true;
            return describe(step);
        }
        across_ = std::nullopt;
        if (const auto slab = blocks.empty() ? std::nullopt : marked_slab(*blocks.front()))
            for (int k = 0; k < 3; ++k)
                if (slab->across[k] == 1.0)
                    across_ = k;
        BlockRoles roles = block_roles(blocks, velocity_);
        Blocks fluid;
        for (std::size_t i = 0; i < blocks.size(); ++i)
            if (roles.fluid[i])
                fluid.push_back(blocks[i]);
            else
                solids_.insert(places[i]);
        if (fluid.empty())
            return core::fail(Error::Code::Unsupported,
                              entry_name(step) + " holds no three-dimensional cells",
                              "extrude it by two cells or more first");
        description_.fields = std::move(roles.fields);
        add_note(description_.note, roles.note);
        return {};
    }

    // Returns true for a flat leaf among several; a flat leaf alone is a source that cannot be read, with an
    // error.
    bool is_patch(vtkDataSet& data, std::size_t leaves) const {
        return leaves > 1 && !plane_ && !has_solid_cells(data);
    }

    // Identifies a leaf at every time-step: by the name of its block, else by its index.
    static std::string place_of(const CompositeFile& all, std::size_t leaf) {
        const auto& block = all.leaves[leaf].block;
        return block.empty() ? std::string("#").append(std::to_string(leaf)) : block;
    }

    core::Result<void> add_wall(const CompositeFile& all,
                                std::size_t index,
                                vtkDataSet& data,
                                const std::vector<FieldInfo>& fields,
                                SourceStep& out) {
        const auto& leaf = all.leaves[index];
        const bool still = is_still(data, fields);
        const bool named = is_named_wall(leaf.block.empty() ? leaf.name : leaf.block);
        if (!named && !still)
            return {};
        auto no_slip =
            still ? still_throughout(place_of(all, index), fields) : core::Result<bool>(false);
        if (!no_slip)
            return tl::unexpected(no_slip.error());
        if (!named && !*no_slip)
            return {};
        return surface_of(data, leaf.name).map([&](auto surface) {
            out.walls.push_back(
                {std::move(surface), *no_slip, leaf.block.empty() ? leaf.name : leaf.block});
        });
    }

    // Returns true if the patch at `place` is still at the time-step that describes the source and at the
    // last: an inlet may start at rest.
    core::Result<bool> still_throughout(const std::string& place,
                                        const std::vector<FieldInfo>& fields) {
        std::string key = place;
        for (const auto& field : fields)
            key += '\n' + field.name;
        if (const auto known = still_.find(key); known != still_.end())
            return known->second;
        for (const std::size_t step : {described_step_, series_.entries.size() - 1}) {
            const auto all = expand_step(step);
            if (!all)
                return tl::unexpected(all.error());
            bool still = false; // also if the patch is missing there
            for (std::size_t i = 0; i < all->leaves.size() && !still; ++i)
                if (place_of(*all, i) == place) {
                    const auto file = read_vtk_file(all->leaves[i], {false, fields});
                    if (!file)
                        return tl::unexpected(file.error());
                    still = is_still(*file->data, fields);
                }
            if (!still)
                return still_[key] = false;
        }
        return still_[key] = true;
    }

    FileSeries series_;
    std::string velocity_;         ///< asked for; may be empty
    bool plane_ = false;           ///< all parts are flat
    std::optional<int> across_;    ///< the axis, of a plane of coordinates
    std::set<std::string> solids_; ///< places of the blocks without the velocity
    std::map<std::string, bool> still_;
    std::size_t described_step_ = 0;
    std::map<std::size_t, VtkFile> described_; ///< by leaf, of that time-step
    std::size_t leaves_ = 0;                   ///< of that time-step
    std::vector<store::SourceFile> described_from_;
    std::map<std::string, vtkSmartPointer<vtkDataSet>> sound_; ///< meshes by place, without values
};

} // namespace

bool is_vtk_files(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".pvd" || extension == ".series" || is_vtk_file(path);
}

Opened open_vtk_files(const std::filesystem::path& path, const command::SourceOptions& wish) {
    return open_series<VtkFilesSource>(path, wish);
}

} // namespace wakesurf::importer
