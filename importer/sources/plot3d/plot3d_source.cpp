#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/plot3d/plot3d_files.hpp"
#include "importer/sources/series/series_times.hpp"

#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockPLOT3DReader.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace wakesurf::importer {

namespace fs = std::filesystem;
using core::Error;
using core::FieldInfo;

namespace {

constexpr int velocity_function = 200;

void lay_out(vtkMultiBlockPLOT3DReader& reader, const Plot3dLayout& layout) {
    reader.AutoDetectFormatOff();
    reader.SetBinaryFile(layout.ascii ? 0 : 1);
    reader.SetMultiGrid(layout.several ? 1 : 0);
    reader.SetHasByteCount(layout.records ? 1 : 0);
    reader.SetIBlanking(layout.blanking ? 1 : 0);
    reader.SetTwoDimensionalGeometry(0);
    reader.SetDoublePrecision(layout.doubles ? 1 : 0);
    if (layout.big_endian)
        reader.SetByteOrderToBigEndian();
    else
        reader.SetByteOrderToLittleEndian();
}

// Many programs write 0, or a constant, for each. After a restart some are there twice.
bool are_times(const std::vector<double>& headers) {
    return std::ranges::all_of(headers, [](double t) { return std::isfinite(t); }) &&
           2 * std::set(headers.begin(), headers.end()).size() > headers.size();
}

// Returns the five values of a solution at a node, in their places.
std::array<double, 5> values_at(vtkDataSet& block, vtkIdType node) {
    auto& point = *block.GetPointData();
    auto* const momentum = point.GetArray("Momentum");
    return {point.GetArray("Density")->GetTuple1(node), momentum->GetComponent(node, 0),
            momentum->GetComponent(node, 1), momentum->GetComponent(node, 2),
            point.GetArray("StagnationEnergy")->GetTuple1(node)};
}

// A density without a unit is near 1, and of what moves the energy is more than that of its motion. Others use
// the format for what they like: FDS for temperature, u, v, w and heat. Such files state no reference.
bool is_conserved(const Blocks& blocks, const Plot3dHeader& header) {
    constexpr double densest = 10.0;
    if (header[0] != 0.0 || header[1] != 0.0 || header[2] != 0.0)
        return true;
    std::int64_t moving = 0;
    std::int64_t too_fast = 0;
    bool ones = true;
    for (const auto& block : blocks)
        for (vtkIdType node = 0; node < block->GetNumberOfPoints(); ++node) {
            const auto [density, x, y, z, energy] = values_at(*block, node);
            const double squares = x * x + y * y + z * z;
            if (density == 0.0 && squares == 0.0) // blanked
                continue;
            if (density > densest || density < 0.0)
                return false;
            ones = ones && density == 1.0;
            moving += squares > 0.0 ? 1 : 0;
            too_fast += squares > 0.0 && energy * density < 0.5 * squares ? 1 : 0;
        }
    return ones || 2 * too_fast <= moving; // a velocity times 1 is a velocity
}

// Reads "2,3,4": the places of the velocity among the five values.
bool are_places(std::string wish) {
    std::erase(wish, ' ');
    return wish.size() == 5 && wish[1] == ',' && wish[3] == ',' &&
           std::ranges::all_of(std::array{wish[0], wish[2], wish[4]},
                               [](char c) { return c >= '1' && c <= '5'; }) &&
           wish[0] != wish[2] && wish[2] != wish[4] && wish[0] != wish[4];
}

// Replaces what VTK names by five scalars called by their places.
void name_by_place(vtkDataSet& block) {
    auto& point = *block.GetPointData();
    std::array<vtkSmartPointer<vtkFloatArray>, 5> places;
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] = vtkSmartPointer<vtkFloatArray>::New();
        places[i]->SetName(std::to_string(i + 1).c_str());
        places[i]->SetNumberOfTuples(block.GetNumberOfPoints());
    }
    for (vtkIdType node = 0; node < block.GetNumberOfPoints(); ++node) {
        const auto values = values_at(block, node);
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i]->SetValue(node, static_cast<float>(values[i]));
    }
    for (const char* const name : {"Density", "Momentum", "StagnationEnergy", "Velocity"})
        point.RemoveArray(name);
    for (const auto& place : places)
        point.AddArray(place);
}

class Plot3dSource final : public Source {
  public:
    Plot3dSource(Plot3dFiles files, const std::string& velocity)
        : files_(std::move(files)), by_place_(are_places(velocity)), wish_(velocity) {}

    core::Result<void> open() {
        description_.name = files_.name;
        description_.reader = "vtkMultiBlockPLOT3DReader (plot3d)";
        if (auto timed = find_times(); !timed)
            return timed;
        const auto blocks = load(0);
        if (!blocks)
            return tl::unexpected(blocks.error());
        description_.fields = common_fields(*blocks);
        std::erase_if(description_.fields, [](const FieldInfo& field) { // of VTK's own making
            return field.name == "IBlank";
        });
        description_.note = by_place_
                                ? "the five values of the solutions are taken by their places, "
                                  "not as density, momentum and energy"
                                : "the five values of the solutions are taken as density, "
                                  "momentum and energy (by their places: --velocity 2,3,4)";
        if (by_place_ || !wish_.empty() || is_conserved(*blocks, header_))
            return {};
        return core::fail(
            Error::Code::InvalidArgument,
            files_.steps.front().solution.name +
                " may not hold density, momentum and energy: it states no Mach, angle "
                "and Reynolds number, and these values are not of a flow",
            "where the second to fourth of its five values are the velocity, as FDS "
            "writes them, --velocity 2,3,4; else --velocity Momentum,Density");
    }

    core::Result<std::vector<store::SourceFile>> shared_files() const override {
        std::vector<NamedFile> shared;
        for (const auto& path : files_.index)
            shared.push_back({path, path.filename().string()});
        if (one_grid())
            shared.push_back({files_.steps.front().grid.path, files_.steps.front().grid.name});
        return fingerprint(shared);
    }

    core::Result<std::vector<store::SourceFile>> files(std::size_t step) const override {
        const auto& [grid, solution, time] = files_.steps[step];
        std::vector<NamedFile> own{{solution.path, solution.name}};
        if (!one_grid())
            own.push_back({grid.path, grid.name});
        return fingerprint(own);
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        const auto blocks = load(step);
        if (!blocks)
            return tl::unexpected(blocks.error());
        SourceStep out;
        for (const auto& block : *blocks) {
            if (auto whole = require_fields(*block, fields, files_.steps[step].solution.name);
                !whole)
                return tl::unexpected(whole.error());
            keep_only(*block, fields);
            out.blocks.push_back(block);
        }
        return out;
    }

  private:
    bool one_grid() const {
        return std::all_of(files_.steps.begin(), files_.steps.end(), [&](const Plot3dStep& step) {
            return step.grid.path == files_.steps.front().grid.path;
        });
    }

    core::Result<void> find_times() {
        std::vector<TimedEntry> entries;
        std::vector<double> headers; // of the solutions that can be read
        for (const auto& step : files_.steps) {
            const auto layout = grid_layout(step.grid);
            using Header = decltype(check_solution(step.solution, *layout));
            const auto header = layout ? check_solution(step.solution, *layout)
                                       : Header(tl::unexpected(layout.error()));
            entries.push_back({step.solution.name, step.time});
            if (header) {
                headers.push_back(header->back());
                header_ = headers.size() == 1 ? *header : header_;
            } else if (entries.size() > 1 && ends_series(header.error())) {
                entries.back().unreadable = header.error();
            } else {
                return tl::unexpected(header.error());
            }
        }
        const bool listed = files_.steps.front().time.has_value();
        const bool stated = !listed && are_times(headers);
        auto next = headers.begin();
        for (auto& entry : entries)
            if (stated && !entry.unreadable)
                entry.time = *next++;
        return describe_times(std::move(entries), description_).map([&](const auto& order) {
            if (!listed && !stated)
                description_.time_note =
                    "the times in the solutions do not increase: 0, 1, 2, ... are used";
            add_note(description_.time_note, files_.note);
            keep_in_order(files_.steps, order);
        });
    }

    core::Result<Blocks> load(std::size_t step) const {
        const auto& [grid, solution, time] = files_.steps[step];
        const auto layout = grid_layout(grid);
        if (!layout)
            return tl::unexpected(layout.error());
        if (const auto sound = check_solution(solution, *layout); !sound)
            return tl::unexpected(sound.error());
        constexpr std::uint64_t bytes_a_node = 32; // a place, and five values of the solution
        for (const auto& [ni, nj, nk] : layout->blocks)
            if (auto fits =
                    check_claim(grid.name,
                                static_cast<std::uint64_t>(ni) * static_cast<std::uint64_t>(nj) *
                                    static_cast<std::uint64_t>(nk),
                                bytes_a_node);
                !fits)
                return tl::unexpected(fits.error());
        const VtkMessages messages;
        auto reader = vtkSmartPointer<vtkMultiBlockPLOT3DReader>::New();
        std::optional<UsualNumbers> points;
        std::optional<UsualNumbers> values;
        if (layout->ascii) {
            points.emplace(grid.path.string());
            values.emplace(solution.path.string());
        }
        reader->SetXYZFileName((points ? points->path() : grid.path.string()).c_str());
        reader->SetQFileName((values ? values->path() : solution.path.string()).c_str());
        lay_out(*reader, *layout);
        reader->AddFunction(velocity_function);
        const auto update = [&] {
            reader->Update();
            return messages.verdict(solution.name);
        };
        if (auto clean = within_memory(solution.name, update); !clean)
            return tl::unexpected(clean.error());
        Blocks blocks;
        for (const auto& leaf : leaves_of(reader->GetOutput())) {
            auto block = fluid_part(*leaf.data, grid.name);
            if (!block)
                return tl::unexpected(block.error());
            if (by_place_)
                name_by_place(**block);
            blocks.push_back(std::move(*block));
        }
        if (blocks.size() != layout->blocks.size())
            return core::fail(Error::Code::Corrupt,
                              grid.name + " does not have the grids that it declares");
        return blocks;
    }

    Plot3dFiles files_;
    bool by_place_;         ///< the velocity is asked for by places among the five values
    std::string wish_;      ///< the velocity asked for; may be empty
    Plot3dHeader header_{}; ///< of the first solution
};

} // namespace

bool is_plot3d(const std::filesystem::path& path) {
    return is_plot3d_grid(path) || lower_extension(path) == ".q";
}

Opened open_plot3d(const fs::path& path, const command::SourceOptions& wish) {
    return find_plot3d_files(path, wish.alone).and_then([&](Plot3dFiles files) {
        return opened<Plot3dSource>(std::move(files), wish.velocity);
    });
}

} // namespace wakesurf::importer
