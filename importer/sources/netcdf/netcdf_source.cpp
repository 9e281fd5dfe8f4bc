#include "core/dataset/grid.hpp"
#include "importer/base/text.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/netcdf/netcdf_conventions.hpp"
#include "importer/sources/netcdf/netcdf_grid.hpp"
#include "importer/sources/netcdf/netcdf_units.hpp"
#include "importer/sources/series/series_source.hpp"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

vtkSmartPointer<vtkDataSet> make_grid(const NetcdfFile& file, const NetcdfGrid& grid) {
    std::array<int, 3> dimensions{};
    bool even = true;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& axis = grid.axes[i];
        dimensions[i] = static_cast<int>(axis.nodes.size());
        if (axis.nodes.size() < 2)
            continue;
        const auto* variable =
            file.variable(file.dimensions()[static_cast<std::size_t>(axis.dimension)].name);
        even = even && core::is_even(axis.nodes, variable != nullptr && variable->type == NC_FLOAT);
    }
    if (even) {
        auto image = vtkSmartPointer<vtkImageData>::New();
        image->SetDimensions(dimensions.data());
        std::array<double, 3> origin{};
        std::array<double, 3> spacing{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto& nodes = grid.axes[i].nodes;
            origin[i] = nodes.front();
            spacing[i] = nodes.size() < 2 ? 1.0
                                          : (nodes.back() - nodes.front()) /
                                                static_cast<double>(nodes.size() - 1);
        }
        image->SetOrigin(origin.data());
        image->SetSpacing(spacing.data());
        return image;
    }
    auto rectilinear = vtkSmartPointer<vtkRectilinearGrid>::New();
    rectilinear->SetDimensions(dimensions.data());
    std::array<vtkSmartPointer<vtkDoubleArray>, 3> axes;
    for (std::size_t i = 0; i < 3; ++i) {
        axes[i] = vtkSmartPointer<vtkDoubleArray>::New();
        for (const double node : grid.axes[i].nodes)
            axes[i]->InsertNextValue(node);
    }
    rectilinear->SetXCoordinates(axes[0]);
    rectilinear->SetYCoordinates(axes[1]);
    rectilinear->SetZCoordinates(axes[2]);
    return rectilinear;
}

bool changes_sign(const NetcdfFile& file,
                  const NetcdfGrid& grid,
                  const NetcdfGridVariable& variable) {
    return !variable.components &&
           points_backward(file, *file.variable(variable.name), grid.axes[2].down);
}

// Reads one time-step of a variable, x fastest, along rising axes. z is up: a component that points down
// changes its sign.
template <class Array>
core::Result<vtkSmartPointer<vtkDataArray>> read_array(const NetcdfFile& file,
                                                       const NetcdfVariable& variable,
                                                       const NetcdfGrid& grid,
                                                       std::optional<int> components,
                                                       double sign,
                                                       std::size_t time) {
    const std::size_t rank = variable.dimensions.size();
    std::vector<std::size_t> start(rank, 0);
    std::vector<std::size_t> count(rank, 1);
    std::array<std::size_t, 3> stride{0, 0, 0};
    for (std::size_t d = 0; d < rank; ++d) {
        if (grid.time && variable.dimensions[d] == *grid.time)
            start[d] = time;
        for (const auto& axis : grid.axes)
            if (axis.dimension == variable.dimensions[d])
                count[d] = axis.nodes.size();
        if (variable.dimensions[d] == components)
            count[d] = 3;
    }
    std::size_t step = 1;
    std::size_t apart = 0; // the components
    for (std::size_t d = rank; d-- > 0; step *= count[d]) {
        if (variable.dimensions[d] == components)
            apart = step;
        for (std::size_t i = 0; i < 3; ++i)
            if (grid.axes[i].dimension == variable.dimensions[d])
                stride[i] = step;
    }
    const auto values = file.read(variable, start, count);
    if (!values)
        return tl::unexpected(values.error());
    const double factor = sign * unit_of(file, variable).factor;
    const std::size_t width = components ? 3 : 1;
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(variable.name.c_str());
    array->SetNumberOfComponents(static_cast<int>(width));
    array->SetNumberOfTuples(static_cast<vtkIdType>(values->size() / width));
    const auto at = [&](std::size_t axis, std::size_t i) {
        const auto& a = grid.axes[axis];
        return stride[axis] * (a.flipped ? a.nodes.size() - 1 - i : i);
    };
    vtkIdType out = 0;
    using Value = typename Array::ValueType;
    for (std::size_t k = 0; k < grid.axes[2].nodes.size(); ++k)
        for (std::size_t j = 0; j < grid.axes[1].nodes.size(); ++j)
            for (std::size_t i = 0; i < grid.axes[0].nodes.size(); ++i)
                for (std::size_t c = 0; c < width; ++c)
                    array->SetValue(
                        out++, static_cast<Value>(
                                   factor * (*values)[at(0, i) + at(1, j) + at(2, k) + c * apart]));
    return vtkSmartPointer<vtkDataArray>(array);
}

core::Result<void> add_field(vtkDataSet& data,
                             const NetcdfFile& file,
                             const NetcdfGrid& grid,
                             const std::string& name,
                             std::size_t time) {
    const auto* variable = file.variable(name);
    const auto here = std::ranges::find(grid.variables, name, &NetcdfGridVariable::name);
    if (variable == nullptr || here == grid.variables.end())
        return core::fail(Error::Code::NotFound, file.name() + " has no field " + name);
    const double sign = changes_sign(file, grid, *here) ? -1.0 : 1.0;
    const bool single = variable->type == NC_FLOAT &&
                        file.numbers(*variable, "scale_factor").empty() &&
                        file.numbers(*variable, "add_offset").empty();
    auto array =
        single ? read_array<vtkFloatArray>(file, *variable, grid, here->components, sign, time)
               : read_array<vtkDoubleArray>(file, *variable, grid, here->components, sign, time);
    return array.map([&](const auto& read) { data.GetPointData()->AddArray(read); });
}

class NetcdfSource final : public SeriesSource<std::size_t> {
  public:
    using SeriesSource::SeriesSource;

    core::Result<void> open() {
        description_.reader = "netCDF library (" + series_.kind + ")";
        std::vector<TimedEntry> times;
        for (std::size_t i = 0; i < series_.entries.size(); ++i)
            if (auto added = add_steps(i, times); !added) {
                if (i == 0 || !ends_series(added.error()))
                    return added;
                steps_.push_back({i, 0});
                times.push_back({listed(i).name, std::nullopt, added.error()});
            }
        if (times.empty())
            return tl::unexpected(without_grid_.front());
        constexpr std::size_t most = 3;
        for (std::size_t i = 0; i < std::min(most, without_grid_.size()); ++i)
            add_note(description_.note, "left out: " + without_grid_[i].message);
        if (without_grid_.size() > most)
            add_note(description_.note,
                     std::to_string(without_grid_.size()) + " files are left out like these");
        if (auto settled = settle_steps(times); !settled)
            return settled;
        source_note_ = description_.note;
        return describe_by(0);
    }

    std::optional<std::vector<FieldInfo>> fields_at(std::size_t step) override {
        const auto here = fields_.find(steps_[step].file); // none of a file that cannot be read
        return fields_.size() > 1 && here != fields_.end() ? std::optional(here->second)
                                                           : std::nullopt;
    }

    core::Result<void> describe_by(std::size_t step) override {
        return step == described_ ? core::Result<void>() : describe(step);
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        const auto& [entry, time] = steps_[step];
        const auto file = NetcdfFile::open(listed(entry));
        if (!file)
            return tl::unexpected(file.error());
        const auto grid = find_grid(*file, velocity_);
        if (!grid)
            return tl::unexpected(grid.error());
        if (grid->time && time >= file->dimensions()[static_cast<std::size_t>(*grid->time)].length)
            return core::fail(Error::Code::Corrupt,
                              file->name() + " has lost its time-step " + std::to_string(time));
        const auto block = make_grid(*file, *grid);
        const auto listed_here = fields_of(*file, *grid);
        for (const auto& field : fields) {
            if (std::ranges::find(grid->variables, field.name, &NetcdfGridVariable::name) ==
                    grid->variables.end() &&
                std::ranges::find(listed_here, field.name, &FieldInfo::name) != listed_here.end()) {
                add_zeros(*block, field.name); // the component that a plane lacks
                continue;
            }
            if (auto added = add_field(*block, *file, *grid, field.name, time); !added)
                return tl::unexpected(added.error());
        }
        const auto sound = fluid_part(*block, file->name());
        if (!sound)
            return tl::unexpected(sound.error());
        return SourceStep{{*sound}, {}, {}};
    }

  private:
    core::Result<void> add_steps(std::size_t entry, std::vector<TimedEntry>& times) {
        const auto file = NetcdfFile::open(listed(entry));
        if (!file)
            return tl::unexpected(file.error());
        const auto grid = find_grid(*file, velocity_);
        if (!grid && grid.error().code != Error::Code::Unsupported)
            return tl::unexpected(grid.error());
        if (!grid) {
            without_grid_.push_back(grid.error());
            return {};
        }
        fields_[entry] = fields_of(*file, *grid);
        for (const auto& stated : stated_in(*file, *grid))
            if (std::ranges::find(description_.velocities, stated) == description_.velocities.end())
                description_.velocities.push_back(stated);
        const auto length =
            grid->time ? file->dimensions()[static_cast<std::size_t>(*grid->time)].length : 1;
        if (length == 0)
            return core::fail(Error::Code::Corrupt, file->name() + " has no time-steps yet");
        const auto* variable = grid->time ? coordinates_of(*file, *grid->time) : nullptr;
        if (variable == nullptr && length == 1)
            variable = time_of_all(*file);
        auto other = variable == nullptr ? read_other_times(*file, length, reference_)
                                         : std::optional<NetcdfTimes>();
        if (variable == nullptr && !other) {
            for (std::size_t i = 0; i < length; ++i)
                add_step(*file, entry, i, std::nullopt, times);
            if (length == 1)
                times.back().number = series_.entries[entry].number;
            return {};
        }
        auto read = other ? core::Result<NetcdfTimes>(std::move(*other))
                          : read_times(*file, *variable, reference_, series_.entries.size() > 1);
        if (!read)
            return tl::unexpected(read.error());
        for (std::size_t i = 0; i < length; ++i) {
            if (!std::isfinite(read->seconds[i]))
                return core::fail(Error::Code::Corrupt, step_name(*file, i) + " has no time");
            add_step(*file, entry, i, read->seconds[i], times);
        }
        if (!time_unit_) {
            reference_ = read->reference;
            time_unit_ = read->unit;
            add_note(description_.note, read->note);
        }
        return {};
    }

    static std::string step_name(const NetcdfFile& file, std::size_t step) {
        return "time-step " + std::to_string(step) + " of " + file.name();
    }

    void add_step(const NetcdfFile& file,
                  std::size_t entry,
                  std::size_t step,
                  std::optional<double> time,
                  std::vector<TimedEntry>& times) {
        steps_.push_back({entry, step});
        times.push_back({step_name(file, step), time});
    }

    static std::vector<FieldInfo> fields_of(const NetcdfFile& file, const NetcdfGrid& grid) {
        std::vector<FieldInfo> out;
        for (const auto& [name, components] : grid.variables)
            out.push_back({name, components ? 3 : 1, FieldInfo::Source::Point, {0.0, 0.0}, {}});
        for (std::size_t i = 0; i < 3; ++i)
            if (grid.axes[i].nodes.size() == 1)
                for (const auto& third :
                     lacking_components(out, stated_in(file, grid), static_cast<int>(i)))
                    out.push_back({third, 1, FieldInfo::Source::Point, {0.0, 0.0}, {}});
        return out;
    }

    static std::vector<StatedComponents> stated_in(const NetcdfFile& file, const NetcdfGrid& grid) {
        return stated_velocities(file, names_of(grid), grid.axes[2].nodes.size() == 1);
    }

    static void add_zeros(vtkDataSet& block, const std::string& name) {
        const auto zeros = vtkSmartPointer<vtkFloatArray>::New();
        zeros->SetName(name.c_str());
        zeros->SetNumberOfTuples(block.GetNumberOfPoints());
        zeros->Fill(0.0);
        block.GetPointData()->AddArray(zeros);
    }

    static std::vector<std::string> names_of(const NetcdfGrid& grid) {
        std::vector<std::string> out;
        for (const auto& variable : grid.variables)
            out.push_back(variable.name);
        return out;
    }

    core::Result<void> describe(std::size_t step) {
        description_.note = source_note_;
        const auto file = NetcdfFile::open(listed(steps_[step].file));
        if (!file)
            return tl::unexpected(file.error());
        const auto grid = find_grid(*file, velocity_);
        if (!grid)
            return tl::unexpected(grid.error());
        for (std::size_t i = 0; i < 3; ++i)
            if (grid->axes[i].numbered)
                add_note(description_.note, std::string("the file has no coordinates along ") +
                                                "xyz"[i] + ": node numbers are used");
        add_note(description_.note, grid->note);
        const auto described = read(step, fields_of(*file, *grid));
        if (!described)
            return tl::unexpected(described.error());
        described_ = step;
        description_.fields = common_fields(described->blocks);
        for (auto& field : description_.fields)
            if (const auto* variable = file->variable(field.name))
                field.unit = unit_of(*file, *variable).unit;
        add_note(description_.note, note_on_units(*file, *grid, velocity_names(), time_unit_));
        note_directions(*file, *grid);
        const auto velocity = velocity_names();
        return velocity.empty() && !velocity_.empty() ? core::Result<void>()
                                                      : refuse_tendencies(*file, velocity);
    }

    void note_directions(const NetcdfFile& file, const NetcdfGrid& grid) {
        if (grid.axes[2].by_name)
            add_note(description_.note, "the depth does not state which way it is positive: taken "
                                        "as positive down, so that z = -depth");
        for (const auto& each : grid.variables) {
            if (each.components)
                add_note(description_.note,
                         "the three values of " + each.name + " along " +
                             file.dimensions()[static_cast<std::size_t>(*each.components)].name +
                             " are taken as x, y and z");
            if (changes_sign(file, grid, each)) {
                const auto& variable = *file.variable(each.name);
                const auto standard = file.text(variable, "standard_name");
                add_note(description_.note, each.name + " is stated to point the other way (" +
                                                (standard.empty() ? "positive down" : standard) +
                                                "): its sign was changed" +
                                                (grid.axes[2].down ? ", as that of z" : ""));
            }
        }
    }

    // Returns an empty list if the choice of the velocity is not clear.
    std::vector<std::string> velocity_names() const {
        std::vector<std::string> out;
        if (const auto chosen =
                choose_velocity(description_.fields, velocity_, description_.velocities))
            for (const auto& array : chosen->parts.arrays)
                out.push_back(array.name);
        return out;
    }

    std::map<std::size_t, std::vector<FieldInfo>> fields_; ///< of each file
    std::vector<Error> without_grid_;                      ///< why files are left out
    std::optional<std::size_t> described_;                 ///< the time-step
    std::string source_note_;                              ///< without what that time-step shows
    /// The point in time that times are counted from.
    std::string reference_;
    std::optional<std::string> time_unit_;
};

} // namespace

bool is_netcdf(const std::filesystem::path& path) {
    const auto extension = lower_extension(path);
    return extension == ".nc" || extension == ".nc4" || extension == ".cdf";
}

Opened open_netcdf(const std::filesystem::path& path, const command::SourceOptions& wish) {
    return open_series<NetcdfSource>(path, wish);
}

} // namespace wakesurf::importer
