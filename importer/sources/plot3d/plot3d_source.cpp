#include "importer/sources/plot3d/plot3d_source.hpp"

#include "importer/base/process_memory.hpp"
#include "importer/base/vtk_messages.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/files/file_names.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/plot3d/fortran_numbers.hpp"
#include "importer/sources/plot3d/plot3d_files.hpp"
#include "importer/sources/plot3d/plot3d_layout.hpp"
#include "importer/sources/series/series_times.hpp"

#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockPLOT3DReader.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <set>

namespace wakesurf::importer {

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

class Plot3dSource final : public Source {
  public:
    explicit Plot3dSource(Plot3dFiles files) : files_(std::move(files)) {}

    core::Result<void> open() {
        description_.name = files_.name;
        description_.reader = "vtkMultiBlockPLOT3DReader (plot3d)";
        if (auto timed = find_times(); !timed)
            return timed;
        return load(0).map([&](const Blocks& blocks) {
            description_.fields = common_fields(blocks);
            std::erase_if(description_.fields, [](const FieldInfo& field) { // of VTK's own making
                return field.name == "IBlank";
            });
        });
    }

    const SourceDescription& description() const override { return description_; }

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
        std::vector<double> headers;
        for (const auto& step : files_.steps) {
            const auto layout = grid_layout(step.grid);
            if (!layout)
                return tl::unexpected(layout.error());
            const auto time = check_solution(step.solution, *layout);
            if (!time)
                return tl::unexpected(time.error());
            headers.push_back(*time);
            entries.push_back({step.solution.name, step.time});
        }
        const bool listed = files_.steps.front().time.has_value();
        const bool stated = !listed && are_times(headers);
        for (std::size_t i = 0; stated && i < headers.size(); ++i)
            entries[i].time = headers[i];
        auto settled = settle_times(entries);
        if (!settled)
            return tl::unexpected(settled.error());
        description_.times = std::move(settled->times);
        description_.places = std::move(settled->places);
        description_.time_note =
            listed || stated ? std::move(settled->note)
                             : "the times in the solutions do not increase: 0, 1, 2, ... are used";
        std::vector<Plot3dStep> kept;
        for (const std::size_t i : settled->order)
            kept.push_back(std::move(files_.steps[i]));
        files_.steps = std::move(kept);
        return {};
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
        try {
            reader->Update();
        } catch (const std::bad_alloc&) {
            return core::fail(Error::Code::OverLimit,
                              "there is not enough memory to read " + solution.name);
        }
        if (auto clean = messages.verdict(solution.name); !clean)
            return tl::unexpected(clean.error());
        Blocks blocks;
        for (const auto& leaf : leaves_of(reader->GetOutput())) {
            auto block = fluid_part(*leaf.data, grid.name);
            if (!block)
                return tl::unexpected(block.error());
            blocks.push_back(std::move(*block));
        }
        if (blocks.size() != layout->blocks.size())
            return core::fail(Error::Code::Corrupt,
                              grid.name + " does not have the grids that it declares");
        if (auto thick = check_thickness(blocks, grid.name); !thick)
            return tl::unexpected(thick.error());
        return blocks;
    }

    Plot3dFiles files_;
    SourceDescription description_;
};

} // namespace

bool is_plot3d(const std::filesystem::path& path) {
    return is_plot3d_grid(path) || lower_extension(path) == ".q";
}

core::Result<std::unique_ptr<Source>> open_plot3d(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish) {
    auto files = find_plot3d_files(path, wish.alone);
    if (!files)
        return tl::unexpected(files.error());
    auto source = std::make_unique<Plot3dSource>(std::move(*files));
    if (auto opened = source->open(); !opened)
        return tl::unexpected(opened.error());
    return source;
}

} // namespace wakesurf::importer
