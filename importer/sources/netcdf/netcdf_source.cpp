#include "core/dataset/uniform_grid.hpp"
#include "importer/base/notes.hpp"
#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/files/file_names.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/netcdf/netcdf_axes.hpp"
#include "importer/sources/netcdf/netcdf_units.hpp"
#include "importer/sources/series/series_source.hpp"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <cmath>

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
            spacing[i] = (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
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

// Reads one time-step of a variable, x fastest, along rising axes.
template <class Array>
core::Result<vtkSmartPointer<vtkDataArray>> read_array(const NetcdfFile& file,
                                                       const NetcdfVariable& variable,
                                                       const NetcdfGrid& grid,
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
    }
    std::size_t step = 1;
    for (std::size_t d = rank; d-- > 0; step *= count[d])
        for (std::size_t i = 0; i < 3; ++i)
            if (grid.axes[i].dimension == variable.dimensions[d])
                stride[i] = step;
    const auto values = file.read(variable, start, count);
    if (!values)
        return tl::unexpected(values.error());
    const double factor = unit_of(file, variable).factor;
    auto array = vtkSmartPointer<Array>::New();
    array->SetName(variable.name.c_str());
    array->SetNumberOfTuples(static_cast<vtkIdType>(values->size()));
    const auto at = [&](std::size_t axis, std::size_t i) {
        const auto& a = grid.axes[axis];
        return stride[axis] * (a.flipped ? a.nodes.size() - 1 - i : i);
    };
    vtkIdType out = 0;
    using Value = typename Array::ValueType;
    for (std::size_t k = 0; k < grid.axes[2].nodes.size(); ++k)
        for (std::size_t j = 0; j < grid.axes[1].nodes.size(); ++j)
            for (std::size_t i = 0; i < grid.axes[0].nodes.size(); ++i)
                array->SetValue(
                    out++, static_cast<Value>(factor * (*values)[at(0, i) + at(1, j) + at(2, k)]));
    return vtkSmartPointer<vtkDataArray>(array);
}

core::Result<void> add_field(vtkDataSet& data,
                             const NetcdfFile& file,
                             const NetcdfGrid& grid,
                             const std::string& name,
                             std::size_t time) {
    const auto* variable = file.variable(name);
    if (variable == nullptr ||
        std::find(grid.variables.begin(), grid.variables.end(), name) == grid.variables.end())
        return core::fail(Error::Code::NotFound, file.name() + " has no field " + name);
    const bool single = variable->type == NC_FLOAT &&
                        file.numbers(*variable, "scale_factor").empty() &&
                        file.numbers(*variable, "add_offset").empty();
    auto array = single ? read_array<vtkFloatArray>(file, *variable, grid, time)
                        : read_array<vtkDoubleArray>(file, *variable, grid, time);
    return array.map([&](const auto& read) { data.GetPointData()->AddArray(read); });
}

class NetcdfSource final : public SeriesSource<std::size_t> {
  public:
    using SeriesSource::SeriesSource;

    core::Result<void> open() {
        description_.reader = "netCDF library (" + series_.kind + ")";
        std::vector<TimedEntry> times;
        for (std::size_t i = 0; i < series_.entries.size(); ++i)
            if (auto added = add_steps(i, times); !added)
                return added;
        if (auto settled = settle_steps(times); !settled)
            return settled;
        return describe();
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        const auto& [entry, time] = steps_[step];
        const auto file = NetcdfFile::open(listed(entry));
        if (!file)
            return tl::unexpected(file.error());
        const auto grid = find_grid(*file);
        if (!grid)
            return tl::unexpected(grid.error());
        if (grid->time && time >= file->dimensions()[static_cast<std::size_t>(*grid->time)].length)
            return core::fail(Error::Code::Corrupt,
                              file->name() + " has lost its time-step " + std::to_string(time));
        SourceStep out{{make_grid(*file, *grid)}, {}, {}};
        for (const auto& field : fields)
            if (auto added = add_field(*out.blocks.front(), *file, *grid, field.name, time); !added)
                return tl::unexpected(added.error());
        return out;
    }

  private:
    core::Result<void> add_steps(std::size_t entry, std::vector<TimedEntry>& times) {
        const auto file = NetcdfFile::open(listed(entry));
        if (!file)
            return tl::unexpected(file.error());
        const auto grid = find_grid(*file);
        if (!grid)
            return tl::unexpected(grid.error());
        if (!grid->time) {
            steps_.push_back({entry, 0});
            times.push_back({file->name(), std::nullopt});
            return {};
        }
        const auto length = file->dimensions()[static_cast<std::size_t>(*grid->time)].length;
        if (length == 0)
            return core::fail(Error::Code::Corrupt, file->name() + " has no time-steps yet");
        const auto* variable = coordinates_of(*file, *grid->time);
        if (variable == nullptr) {
            for (std::size_t i = 0; i < length; ++i)
                add_step(*file, entry, i, std::nullopt, times);
            return {};
        }
        auto read = read_times(*file, *variable, reference_);
        if (!read)
            return tl::unexpected(read.error());
        for (std::size_t i = 0; i < length; ++i) {
            if (!std::isfinite(read->seconds[i]))
                return core::fail(Error::Code::Corrupt, step_name(*file, i) + " has no time");
            add_step(*file, entry, i, read->seconds[i], times);
        }
        if (entry == 0) {
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

    core::Result<void> describe() {
        const auto file = NetcdfFile::open(listed(0));
        if (!file)
            return tl::unexpected(file.error());
        const auto grid = find_grid(*file);
        if (!grid)
            return tl::unexpected(grid.error());
        for (std::size_t i = 0; i < 3; ++i)
            if (grid->axes[i].numbered)
                add_note(description_.note, std::string("the file has no coordinates along ") +
                                                "xyz"[i] + ": node numbers are used");
        std::vector<FieldInfo> all;
        for (const auto& name : grid->variables)
            all.push_back({name, 1, FieldInfo::Source::Point, {0.0, 0.0}, {}});
        return read(0, all).map([&](const SourceStep& first) {
            description_.fields = common_fields(first.blocks);
            for (auto& field : description_.fields)
                field.unit = unit_of(*file, *file->variable(field.name)).unit;
            add_note(description_.note, note_on_units(*file, *grid, velocity_names(), time_unit_));
        });
    }

    // Returns an empty list if the choice of the velocity is not clear.
    std::vector<std::string> velocity_names() const {
        std::vector<std::string> out;
        if (const auto chosen = choose_velocity(description_.fields, velocity_))
            for (const auto& array : chosen->parts.arrays)
                out.push_back(array.name);
        return out;
    }

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
