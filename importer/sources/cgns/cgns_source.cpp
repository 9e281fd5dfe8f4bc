#include "importer/base/library_messages.hpp"
#include "importer/base/reading_bounds.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/blocks/block_roles.hpp"
#include "importer/sources/blocks/fluid_blocks.hpp"
#include "importer/sources/blocks/vtk_fields.hpp"
#include "importer/sources/cgns/cgns_file.hpp"
#include "importer/sources/files/formats.hpp"
#include "importer/sources/series/series_source.hpp"

#include <vtkCGNSReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <array>
#include <set>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;

namespace {

void select(vtkCGNSReader& reader, const WantedArrays& wanted) {
    reader.EnableAllBases();
    reader.EnableAllPointArrays();
    reader.EnableAllCellArrays();
    if (wanted.all)
        return;
    reader.DisableAllPointArrays();
    reader.DisableAllCellArrays();
    // A vector is offered component by component.
    const auto enable = [&](FieldInfo::Source source, int count, auto name_of, auto set) {
        for (int i = 0; i < count; ++i) {
            const std::string name = name_of(i);
            for (const auto& field : wanted.fields)
                if (field.source == source && name.starts_with(field.name) &&
                    name.size() <= field.name.size() + 1)
                    set(name.c_str());
        }
    };
    enable(
        FieldInfo::Source::Point, reader.GetNumberOfPointArrays(),
        [&](int i) { return reader.GetPointArrayName(i); },
        [&](const char* name) { reader.SetPointArrayStatus(name, 1); });
    enable(
        FieldInfo::Source::Cell, reader.GetNumberOfCellArrays(),
        [&](int i) { return reader.GetCellArrayName(i); },
        [&](const char* name) { reader.SetCellArrayStatus(name, 1); });
}

// VTK returns structured and unstructured zones, both with points of their own.
void scale_points(vtkDataSet& data, double factor) {
    auto* const points = vtkPointSet::SafeDownCast(&data);
    if (factor == 1.0 || points == nullptr)
        return;
    auto scaled = vtkSmartPointer<vtkPoints>::New();
    scaled->SetDataTypeToDouble();
    scaled->SetNumberOfPoints(points->GetNumberOfPoints());
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i) {
        std::array<double, 3> at{};
        points->GetPoint(i, at.data());
        scaled->SetPoint(i, factor * at[0], factor * at[1], factor * at[2]);
    }
    points->SetPoints(scaled);
}

class CgnsSource final : public SeriesSource<std::optional<double>> {
  public:
    using SeriesSource::SeriesSource;

    core::Result<void> open() {
        std::vector<TimedEntry> times;
        CgnsSurvey first;
        for (std::size_t i = 0; i < series_.entries.size(); ++i) {
            const auto survey = survey_cgns(listed(i));
            if (!survey && i > 0 && ends_series(survey.error())) {
                steps_.push_back({i, std::nullopt});
                times.push_back({listed(i).name, std::nullopt, survey.error()});
                continue;
            }
            if (!survey)
                return tl::unexpected(survey.error());
            if (i == 0)
                first = *survey;
            if (auto rising = check_order(i, survey->times); !rising)
                return rising;
            if (survey->times.empty()) {
                steps_.push_back({i, std::nullopt});
                times.push_back(
                    {listed(i).name, std::nullopt, std::nullopt, series_.entries[i].number});
            }
            for (std::size_t t = 0; t < survey->times.size(); ++t) {
                steps_.push_back({i, survey->times[t]});
                times.push_back(
                    {"time-step " + std::to_string(t) + " of " + listed(i).name, survey->times[t]});
            }
        }
        if (auto settled = settle_steps(times); !settled)
            return settled;
        description_.reader =
            (first.cells_have_other_numbers ? "CGNS library (" : "vtkCGNSReader (") + series_.kind +
            ")";
        add_note(description_.note, first.units.note);
        source_note_ = description_.note;
        return describe_by(0);
    }

    core::Result<void> describe_by(std::size_t step) override {
        if (step == described_)
            return {};
        return survey_cgns(listed(steps_[step].file))
            .and_then([&](const CgnsSurvey& survey) {
                return load(step, {true, {}}, survey);
            })
            .and_then([&](const std::vector<Zone>& zones) { return describe(step, zones); });
    }

    core::Result<SourceStep> read(std::size_t step, const std::vector<FieldInfo>& fields) override {
        // Detects changes since the source was opened, before VTK reads another time-step in place of this
        // one.
        const auto survey = survey_cgns(listed(steps_[step].file));
        if (!survey)
            return tl::unexpected(survey.error());
        const auto& time = steps_[step].time;
        if (time ? std::find(survey->times.begin(), survey->times.end(), *time) ==
                       survey->times.end()
                 : !survey->times.empty())
            return core::fail(Error::Code::Corrupt,
                              step_name(step) + " is not in the file any more");
        const auto zones = load(step, {false, fields}, *survey);
        if (!zones)
            return tl::unexpected(zones.error());
        SourceStep out;
        for (const auto& [place, block] : *zones) {
            if (solids_.contains(place)) {
                out.solids.push_back(boundary_of(*block));
                continue;
            }
            if (auto whole = require_fields(*block, fields, step_name(step)); !whole)
                return tl::unexpected(whole.error());
            keep_only(*block, fields);
            out.blocks.push_back(block);
        }
        if (out.blocks.empty())
            return core::fail(Error::Code::Corrupt,
                              step_name(step) + " has no zone of those with a velocity any more");
        return out;
    }

  private:
    // VTK searches the times of the file as if they were sorted, and would read another time-step.
    core::Result<void> check_order(std::size_t entry, const std::vector<double>& times) const {
        const auto back = std::adjacent_find(times.begin(), times.end(),
                                             [](double a, double b) { return !(a < b); });
        if (back == times.end())
            return {};
        const auto step = static_cast<std::size_t>(back - times.begin());
        return core::fail(Error::Code::Unsupported,
                          "time-step " + std::to_string(step + 1) + " of " + listed(entry).name +
                              " is at time " + time_text(times[step + 1]) + ", after time " +
                              time_text(times[step]) + ": within one file times must increase",
                          "write what follows a restart into a file of its own");
    }

    struct Zone {
        std::string place; ///< names of its base and of the zone
        vtkSmartPointer<vtkDataSet> block;
    };

    core::Result<void> describe(std::size_t step, const std::vector<Zone>& zones) {
        described_ = step;
        solids_.clear();
        Blocks blocks;
        for (const auto& zone : zones)
            blocks.push_back(zone.block);
        BlockRoles roles = block_roles(blocks, velocity_);
        Blocks fluid;
        for (std::size_t i = 0; i < zones.size(); ++i)
            if (roles.fluid[i])
                fluid.push_back(zones[i].block);
            else
                solids_.insert(zones[i].place);
        description_.fields = std::move(roles.fields);
        description_.note = source_note_;
        add_note(description_.note, roles.note);
        return {};
    }

    std::string step_name(std::size_t step) const {
        const auto& [file, time] = steps_[step];
        return listed(file).name + (time ? " at time " + time_text(*time) : "");
    }

    core::Result<std::vector<Leaf>> leaves_by_vtk(std::size_t step,
                                                  const WantedArrays& wanted) const {
        const std::string name = step_name(step);
        const VtkMessages messages;
        auto reader =
            vtkSmartPointer<vtkCGNSReader>::New(); // a new one keeps nothing of other steps
        reader->SetFileName(listed(steps_[step].file).path.c_str());
        reader->DoublePrecisionMeshOn();
        const auto update = [&] {
            reader->UpdateInformation();
            select(*reader, wanted);
            reader->UpdateInformation();
            if (steps_[step].time)
                reader->UpdateTimeStep(*steps_[step].time);
            else
                reader->Update();
            return messages.verdict(name);
        };
        return within_memory(name, update).map([&] {
            return leaves_of(reader->GetOutputDataObject(0));
        });
    }

    core::Result<std::vector<Zone>>
    load(std::size_t step, const WantedArrays& wanted, const CgnsSurvey& survey) const {
        const auto& [file, time] = steps_[step];
        const auto place = std::find(survey.times.begin(), survey.times.end(), time);
        const auto leaves =
            survey.cells_have_other_numbers
                ? read_cgns_zones(listed(file), survey.dimension,
                                  time ? std::optional<std::size_t>(place - survey.times.begin())
                                       : std::nullopt,
                                  wanted)
                : leaves_by_vtk(step, wanted);
        if (!leaves)
            return tl::unexpected(leaves.error());
        const std::string name = step_name(step);
        std::vector<Zone> zones;
        const auto solid = [](const Leaf& leaf) { return has_solid_cells(*leaf.data); };
        const bool plane = std::ranges::none_of(*leaves, solid);
        for (const auto& leaf : *leaves) {
            if (!plane && !solid(leaf))
                continue;
            scale_points(*leaf.data, survey.units.coordinates);
            auto block = fluid_part(*leaf.data, name);
            if (!block)
                return tl::unexpected(block.error());
            std::string path;
            for (const auto& part : leaf.path)
                path += "/" + part;
            zones.push_back({std::move(path), std::move(*block)});
        }
        if (zones.empty())
            return core::fail(Error::Code::Unsupported, name + " holds no cells");
        return zones;
    }

    std::optional<std::size_t> described_; ///< the time-step
    std::string source_note_;              ///< without what that time-step shows
    /// The names of the zones without the velocity.
    std::set<std::string> solids_;
};

} // namespace

bool is_cgns(const std::filesystem::path& path) {
    return lower_extension(path) == ".cgns";
}

Opened open_cgns(const std::filesystem::path& path, const command::SourceOptions& wish) {
    return open_series<CgnsSource>(path, wish);
}

} // namespace wakesurf::importer
