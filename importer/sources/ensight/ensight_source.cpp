#include "importer/base/text.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/ensight/ensight_case.hpp"
#include "importer/sources/ensight/ensight_file.hpp"
#include "importer/sources/files/formats.hpp"

#include <vtkCellData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
namespace fs = std::filesystem;

namespace {

template <class T>
vtkSmartPointer<T> copy_of(T& data) {
    auto out = vtkSmartPointer<T>::Take(data.NewInstance());
    out->ShallowCopy(&data);
    return out;
}

void attach(vtkDataSet& data, vtkDataArray& values, const FieldInfo& field) {
    if (field.source == FieldInfo::Source::Point)
        data.GetPointData()->AddArray(&values);
    else
        data.GetCellData()->AddArray(&values);
}

class EnsightSource final : public Source {
  public:
    EnsightSource(EnsightCase found, std::string velocity)
        : found_(std::move(found)), velocity_(std::move(velocity)) {
        description_.name = fs::path(found_.name).stem().string();
        description_.reader = "EnSight Gold";
        description_.times = found_.times;
        description_.note = found_.note;
        description_.time_note = found_.time_note;
        if (found_.timeless) {
            description_.places = {0.0};
            description_.time_note = "the case has no times";
        }
    }

    core::Result<void> open() {
        const auto file = found_.file_at(found_.geometry, found_.times.front());
        auto geometry = file.and_then(read_ensight_geometry);
        if (!geometry)
            return tl::unexpected(geometry.error());
        geometry_ = std::move(*geometry);
        geometry_file_ = file->name;
        find_faces_on_blocks();
        leave_out_variables_without_files();
        if (auto described = describe(); !described)
            return described;
        choose_walls();
        return {};
    }

    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        return found_.file_at(found_.geometry, found_.times.front())
            .and_then([&](const NamedFile& mesh) {
                return fingerprint({{found_.folder / found_.name, found_.name}, mesh});
            });
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t step) const override {
        std::vector<NamedFile> out;
        const double time = found_.times.at(step);
        auto mesh = found_.file_at(found_.geometry, time);
        if (!mesh)
            return tl::unexpected(mesh.error());
        if (mesh->name != geometry_file_)
            out.push_back(std::move(*mesh));
        for (const auto& one : found_.variables) {
            auto file = found_.file_at(one.file, time);
            if (!file)
                return tl::unexpected(file.error());
            out.push_back(std::move(*file));
        }
        return fingerprint(out);
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        const double time = found_.times.at(step);
        if (auto still = check_mesh(time); !still)
            return tl::unexpected(still.error());
        std::map<std::size_t, vtkSmartPointer<vtkDataSet>> blocks;
        std::map<std::size_t, vtkSmartPointer<vtkPolyData>> faces;
        for (const auto& [number, part] : geometry_.parts) {
            if (part.volume != nullptr && !solids_.contains(number))
                blocks[number] = copy_of(*part.volume);
            if (part.faces != nullptr && on_blocks_.contains(number))
                faces[number] = copy_of(*part.faces);
        }
        for (const auto& field : fields) {
            const auto* variable = found_.find(field);
            if (variable == nullptr && std::ranges::find(third_, field.name) != third_.end())
                continue; // of a plane, which is not in the file
            if (variable == nullptr)
                return core::fail(Error::Code::NotFound,
                                  found_.name + " has no field " + field.name);
            const auto file = found_.file_at(variable->file, time);
            auto values = file.and_then([&](const NamedFile& named) {
                return read_ensight_variable(named, geometry_, variable->field);
            });
            if (!values)
                return tl::unexpected(values.error());
            for (auto& [number, of_part] : *values) {
                if (const auto block = blocks.find(number); block != blocks.end())
                    attach(*block->second, *of_part.volume, field);
                if (const auto face = faces.find(number); face != faces.end())
                    attach(*face->second, *of_part.faces, field);
            }
            for (const auto& [number, block] : blocks)
                if (auto whole = require_fields(*block, {field}, file->name); !whole)
                    return tl::unexpected(whole.error());
        }
        SourceStep out;
        for (auto& [number, block] : blocks) {
            auto sound = fluid_of(block);
            if (!sound)
                return tl::unexpected(sound.error());
            keep_only(**sound, fields);
            out.blocks.push_back(std::move(*sound));
        }
        for (auto& [number, face] : faces)
            if (walls_.contains(number))
                out.walls.push_back(
                    {face, stands_still(*face, fields), geometry_.parts.at(number).name});
            else
                out.others.push_back({face, false, geometry_.parts.at(number).name});
        for (const auto& [number, surface] : solids_)
            out.solids.push_back(surface);
        return out;
    }

  private:
    // Leaves out variables that miss at a time: only what all time-steps have can be shown.
    void leave_out_variables_without_files() {
        const auto velocity = velocity_among(found_.variables);
        std::string left_out;
        std::erase_if(found_.variables, [&](const EnsightVariable& one) {
            const bool gone =
                !velocity.contains(one.field.name) &&
                std::any_of(found_.times.begin(), found_.times.end(), [&](double time) {
                    std::error_code error;
                    const auto file = found_.file_at(one.file, time);
                    return file && !fs::exists(file->path, error) && !error;
                });
            if (gone)
                left_out += (left_out.empty() ? "" : ", ") + one.field.name;
            return gone;
        });
        if (!left_out.empty())
            add_note(description_.note, "left out, as files are missing: " + left_out);
    }

    std::set<std::string> velocity_among(const std::vector<EnsightVariable>& variables) const {
        std::vector<FieldInfo> fields;
        for (const auto& one : variables)
            fields.push_back(one.field);
        return possible_velocity(fields, velocity_);
    }

    // Decides which parts are fluid, and which variables all of them have; the others are left out.
    core::Result<void> describe() {
        std::map<std::size_t, vtkSmartPointer<vtkDataSet>> volumes;
        for (const auto& [number, part] : geometry_.parts)
            if (part.volume != nullptr)
                volumes[number] = copy_of(*part.volume);
        if (volumes.empty())
            return core::fail(Error::Code::Unsupported,
                              geometry_file_ + " has no part with cells in space or in a plane");
        const auto needed = velocity_among(found_.variables);
        std::set<std::string> partial;
        for (const auto& one : found_.variables) {
            const auto values =
                found_.file_at(one.file, found_.times.front()).and_then([&](const NamedFile& file) {
                    return read_ensight_variable(file, geometry_, one.field);
                });
            if (!values && values.error().code == Error::Code::Unsupported &&
                !needed.contains(one.field.name)) {
                add_note(description_.note, "left out: " + values.error().message);
                partial.insert(one.field.name);
                continue;
            }
            if (!values)
                return tl::unexpected(values.error());
            for (const auto& [number, of_part] : *values)
                if (const auto volume = volumes.find(number);
                    volume != volumes.end() && of_part.volume->GetNumberOfTuples() > 0)
                    attach(*volume->second, *of_part.volume, one.field);
        }
        Blocks blocks;
        for (const auto& [number, volume] : volumes) {
            auto sound = fluid_of(volume);
            if (!sound)
                return tl::unexpected(sound.error());
            blocks.push_back(std::move(*sound));
        }
        BlockRoles roles = block_roles(blocks, velocity_);
        std::size_t place = 0;
        for (const auto& [number, volume] : volumes) {
            if (!roles.fluid[place])
                solids_[number] = boundary_of(*blocks[place]);
            ++place;
        }
        for (const auto& field : roles.fields)
            if (found_.find(field) == nullptr)
                third_.push_back(field.name);
        description_.fields = std::move(roles.fields);
        add_note(description_.note, roles.note);
        keep_described_variables(blocks, partial);
        return {};
    }

    // With the values of the part.
    core::Result<vtkSmartPointer<vtkDataSet>>
    fluid_of(const vtkSmartPointer<vtkDataSet>& part) const {
        return geometry_.plane ? fluid_part(*part, geometry_file_) : part;
    }

    void keep_described_variables(const Blocks& volumes, const std::set<std::string>& noted) {
        std::vector<FieldInfo> inside;
        for (const auto& volume : volumes)
            add_fields(*volume, inside);
        const auto among = [](const std::vector<FieldInfo>& fields, const FieldInfo& field) {
            return std::any_of(fields.begin(), fields.end(), [&](const FieldInfo& other) {
                return other.name == field.name && other.source == field.source;
            });
        };
        std::vector<std::string> on_faces;
        std::erase_if(found_.variables, [&](const EnsightVariable& one) {
            if (among(description_.fields, one.field))
                return false;
            if (!among(inside, one.field) && !noted.contains(one.field.name))
                on_faces.push_back(one.field.name);
            return true;
        });
        add_note(description_.note, only_on_some_parts(on_faces));
    }

    core::Result<void> check_mesh(double time) {
        const auto file = found_.file_at(found_.geometry, time);
        if (file && file->name == geometry_file_)
            return {};
        const auto now = file.and_then(read_ensight_geometry);
        if (!now)
            return tl::unexpected(now.error());
        if (!same_geometry(geometry_, *now))
            return core::fail(Error::Code::Unsupported,
                              "the mesh changes: " + file->name + " differs from " + geometry_file_,
                              "only meshes that do not move can be read");
        return {};
    }

    void find_faces_on_blocks() {
        using Point = std::array<double, 3>;
        std::set<Point> wanted;
        for (const auto& [number, part] : geometry_.parts)
            if (part.faces != nullptr)
                for (vtkIdType i = 0; i < part.faces->GetNumberOfPoints(); ++i) {
                    const double* at = part.faces->GetPoint(i);
                    wanted.insert({at[0], at[1], at[2]});
                }
        std::set<Point> there;
        for (const auto& [number, part] : geometry_.parts)
            if (part.volume != nullptr && !wanted.empty())
                for (vtkIdType i = 0; i < part.volume->GetNumberOfPoints(); ++i) {
                    Point at{};
                    part.volume->GetPoint(i, at.data());
                    if (wanted.contains(at))
                        there.insert(at);
                }
        for (const auto& [number, part] : geometry_.parts) {
            if (part.faces == nullptr)
                continue;
            bool all = true;
            for (vtkIdType i = 0; i < part.faces->GetNumberOfPoints(); ++i) {
                const double* at = part.faces->GetPoint(i);
                all = all && there.contains({at[0], at[1], at[2]});
            }
            if (all)
                on_blocks_.insert(number);
        }
    }

    // Also reads the last time-step: a flow that starts from rest is at rest everywhere at first.
    void choose_walls() {
        std::vector<FieldInfo> vectors;
        for (const auto& field : description_.fields)
            if (field.components == 3)
                vectors.push_back(field);
        walls_ = on_blocks_;
        std::map<std::size_t, bool> still;
        for (const std::size_t step : {std::size_t{0}, found_.times.size() - 1}) {
            if (vectors.empty())
                break;
            const auto* velocity = found_.find(vectors.front());
            const auto values =
                found_.file_at(velocity->file, found_.times[step])
                    .and_then([&](const NamedFile& file) {
                        return read_ensight_variable(file, geometry_, velocity->field);
                    });
            if (!values)
                continue;
            for (const auto number : on_blocks_) {
                const auto face = copy_of(*geometry_.parts.at(number).faces);
                if (const auto found = values->find(number); found != values->end())
                    attach(*face, *found->second.faces, velocity->field);
                const auto [known, added] = still.try_emplace(number, true);
                known->second = known->second && stands_still(*face, vectors);
            }
        }
        std::erase_if(walls_, [&](std::size_t number) {
            const std::string name = lower_case(geometry_.parts.at(number).name);
            return name.find("wall") == std::string::npos && !still[number];
        });
    }

    EnsightCase found_;
    std::string velocity_; ///< asked for; may be empty
    EnsightGeometry geometry_;
    std::string geometry_file_;
    std::vector<std::string> third_;  ///< components that a plane lacks
    std::set<std::size_t> on_blocks_; ///< parts with faces
    std::set<std::size_t> walls_;
    /// The outside of the parts without the velocity.
    std::map<std::size_t, vtkSmartPointer<vtkPolyData>> solids_;
};

} // namespace

bool is_ensight(const fs::path& path) {
    const std::string ending = lower_extension(path);
    return ending == ".case" || ending == ".encas";
}

Opened open_ensight(const fs::path& path, const command::SourceOptions& wish) {
    return read_ensight_case(path, wish.velocity).and_then([&](EnsightCase found) {
        return opened<EnsightSource>(std::move(found), wish.velocity);
    });
}

} // namespace wakesurf::importer
