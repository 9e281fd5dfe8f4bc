#include "importer/import_store.hpp"

#include "importer/base/text.hpp"
#include "importer/sources/series/series_times.hpp"
#include "store/store_grid.hpp"

#include <algorithm>
#include <cstdio>

namespace wakesurf::importer {

namespace {

// A velocity made of several arrays is a field of its own, which the source does not list.
void add_velocity(const ImportPlan& plan, std::vector<core::FieldInfo>& fields) {
    const auto& parts = plan.choice.velocity;
    if (parts.arrays.size() == 1 && parts.divisor.empty())
        return;
    const std::string unit = parts.divisor.empty() ? parts.arrays.front().unit : "";
    fields.push_back({plan.choice.velocity_name, 3, parts.arrays.front().source, {0.0, 0.0}, unit});
}

core::FieldInfo* field_of(store::StoreManifest& manifest,
                          const std::string& name,
                          int components,
                          core::FieldInfo::Source source) {
    auto& fields = manifest.info.fields;
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const core::FieldInfo& f) {
        return f.name == name && f.components == components && f.source == source;
    });
    return found == fields.end() ? nullptr : &*found;
}

void widen(std::array<double, 2>& range, const Range& by, bool replace) {
    if (by.empty())
        return;
    range = replace ? std::array{by.lo, by.hi}
                    : std::array{std::min(range[0], by.lo), std::max(range[1], by.hi)};
}

} // namespace

core::Result<store::StoreManifest> describe_store(const ImportPlan& plan,
                                                  const FirstStepReading& reading) {
    const GridAssembly& assembly = reading.first.assembly;
    const SourceDescription& source = plan.source->description();
    store::StoreManifest manifest;
    manifest.source = plan.made_from;
    auto& layout = manifest.layout;
    layout.grid = store::stored_grid(assembly.grid, assembly.curvilinear);
    layout.grid.periodic = reading.first.periodic;
    const auto brick_cells = store::brick_cells_for(plan.placement, layout.grid);
    if (!brick_cells)
        return tl::unexpected(brick_cells.error());
    layout.brick_cells = *brick_cells;
    layout.times = plan.times;
    layout.precision = plan.precision;
    for (const auto& scalar : plan.choice.scalars)
        layout.scalars.push_back(scalar.stored);
    layout.mask = std::find(reading.first.mask.fluid.begin(), reading.first.mask.fluid.end(), 0) !=
                  reading.first.mask.fluid.end();
    layout.walls = !reading.walls.triangles.empty();
    auto& info = manifest.info;
    info.dataset = info.name = source.name;
    info.reader = source.reader;
    info.grid = layout.grid.kind;
    info.bounds = core::bounds(assembly.grid);
    if (info.grid == core::GridKind::Uniform) {
        info.dimensions = layout.grid.uniform.dimensions;
        info.spacing = layout.grid.uniform.spacing;
    } else if (info.grid == core::GridKind::Rectilinear) {
        info.dimensions = layout.grid.dimensions;
    }
    info.finest_spacing = core::finest_spacing(assembly.grid);
    info.points = core::node_count(assembly.grid);
    info.cells = assembly.source_cells;
    info.times = plan.times;
    info.length_unit = source.length_unit;
    info.time_unit = source.time_unit;
    info.steady = plan.times.size() == 1;
    info.fields = plan.fields;
    const core::FieldInfo& velocity = plan.choice.velocity.arrays.front();
    for (core::FieldInfo& field : info.fields)
        if (field.name != velocity.name || field.source != velocity.source)
            field.name = told_apart(field, plan.fields);
    add_velocity(plan, info.fields);
    for (const ChosenScalar& scalar : plan.choice.scalars)
        if (scalar.is_magnitude())
            info.fields.push_back(scalar.info());
    info.velocity = plan.choice.velocity_name;
    store::mark_stored(layout, info);
    info.why = plan.choice.why;
    info.precision = plan.precision;
    info.periodic = layout.grid.periodic;
    layout.patches = info.patches = reading.walls.patches;
    info.obstacle = layout.mask ||
                    core::body_triangles(reading.walls.patches, reading.walls.triangles.size()) > 0;
    info.bytes_per_step = store::step_file_size(info.points, 3, core::Precision::Single);
    add_note(info.note, plan.time_note);
    add_note(info.note, plan.end_note);
    add_note(info.note, source.note);
    add_note(info.note, assembly.note);
    add_note(info.note, plan.choice.note);
    if (plan.choice.velocity.arrays.front().source == core::FieldInfo::Source::Cell)
        add_note(info.note, std::string("approximate: the velocity at a node is the mean of the "
                                        "cells around it") +
                                (source.ignores_boundary_values
                                     ? "; of the boundary's own values only walls at rest are used"
                                     : ""));
    return manifest;
}

std::string note_on_missing_velocity(const std::vector<std::size_t>& steps,
                                     const std::vector<double>& times) {
    if (steps.empty())
        return {};
    constexpr std::size_t most = 5;
    std::string out = "no velocity is a number (in single precision) at " +
                      std::to_string(steps.size()) + " of " + std::to_string(times.size()) +
                      (times.size() == 1 ? " time-step" : " time-steps") + ": time ";
    for (std::size_t i = 0; i < std::min(most, steps.size()); ++i)
        out += (i == 0 ? "" : ", ") + time_text(times.at(steps[i]));
    return out + (steps.size() > most ? ", ..." : "");
}

void include(const ImportPlan& plan,
             const StepRecord& record,
             bool first,
             store::StoreManifest& manifest) {
    widen(manifest.velocity_range, record.speed, first);
    const auto source = plan.choice.velocity.arrays.front().source;
    if (auto* field = field_of(manifest, plan.choice.velocity_name, 3, source))
        field->range = manifest.velocity_range;
    for (std::size_t i = 0; i < plan.choice.scalars.size() && i < record.scalars.size(); ++i) {
        const core::FieldInfo scalar = plan.choice.scalars[i].info();
        if (auto* field = field_of(manifest, scalar.name, 1, scalar.source))
            widen(field->range, record.scalars[i], first);
    }
}

std::string rounding_note(std::span<const float> velocity) {
    char number[32];
    std::snprintf(number, sizeof(number), "%.2g", rounding_error(velocity));
    return "half precision: values are rounded by at most 2^-11 of themselves (0.05 %), the "
           "velocity of "
           "the first time-step by at most " +
           std::string(number);
}

namespace {

std::shared_ptr<const store::StoreReader> open_store(const store::StoreManifest& manifest,
                                                     const std::filesystem::path& folder) {
    auto reader = store::StoreReader::open(store::store_layout(manifest, folder),
                                           std::make_shared<core::PosixDisk>());
    return reader ? *reader : nullptr;
}

// Returns true if the files have their sizes and none was written after the manifest, which comes last; else
// if their checksums are right. Those of an unfinished store are checked when it is resumed.
bool whole_step(const store::StoreWriter& writer,
                const store::StoreManifest& manifest,
                const store::StoreReader& reader,
                std::size_t index) {
    const core::PosixDisk disk;
    const auto& layout = manifest.layout;
    const auto written = disk.identity(writer.folder() / store::manifest_file_name);
    bool unchanged = manifest.complete && written.has_value();
    if (!writer.finished_step(index, layout.columns()))
        return false;
    for (std::size_t column = 0; column < layout.columns(); ++column)
        for (const store::StepFile& expected : store::step_files(layout, column, index)) {
            const auto file = disk.identity(writer.folder() / expected.name);
            if (!file || file->size != expected.size)
                return false;
            unchanged = unchanged && file->modified <= written->modified;
        }
    return unchanged || !manifest.complete || recorded(reader, index, {}).has_value();
}

std::vector<store::StoredScalar> stored_scalars(const ImportPlan& plan) {
    std::vector<store::StoredScalar> out;
    for (const auto& scalar : plan.choice.scalars)
        out.push_back(scalar.stored);
    return out;
}

bool same_but_for_steps(const store::StoreManifest& before, const ImportPlan& plan) {
    return before.source.files == plan.made_from.files &&
           before.source.selection == plan.made_from.selection &&
           before.layout.precision == plan.precision &&
           store::goes_on(plan.placement, before.layout.brick_cells) &&
           before.layout.scalars == stored_scalars(plan) &&
           before.info.velocity == plan.choice.velocity_name &&
           before.source.steps.size() >= before.layout.times.size();
}

bool same_step(const store::StoreManifest& before, const ImportPlan& plan, std::size_t index) {
    return index < before.layout.times.size() && index < plan.times.size() &&
           before.source.steps[index] == plan.made_from.steps[index] &&
           before.layout.times[index] == plan.times[index];
}

} // namespace

std::optional<EarlierImport> earlier_import(const store::StoreWriter& writer,
                                            const ImportPlan& plan) {
    auto before = store::read_store_manifest(writer.folder(), core::PosixDisk());
    if (!before || !same_but_for_steps(*before, plan) || !same_step(*before, plan, 0))
        return std::nullopt;
    const std::size_t columns = before->layout.columns();
    const std::size_t steps = std::max(before->layout.times.size(), plan.times.size());
    bool same = before->source.steps == plan.made_from.steps;
    for (std::size_t i = 0; i < steps; ++i) {
        const bool matches = same_step(*before, plan, i);
        same = same && matches;
        if (!matches && writer.finished_step(i, columns))
            return std::nullopt; // one that was converted is another one now
    }
    auto reader = open_store(*before, writer.folder());
    if (reader == nullptr)
        return std::nullopt;
    EarlierImport found{std::move(*before), same, std::move(reader), {}};
    for (std::size_t i = 0; i < plan.times.size(); ++i)
        found.reusable.push_back(same_step(found.manifest, plan, i) &&
                                 whole_step(writer, found.manifest, *found.reader, i));
    return found;
}

std::optional<StepRecord> recorded(const store::StoreReader& store,
                                   std::size_t index,
                                   const std::vector<std::uint8_t>& fluid) {
    StepRecord record;
    const auto step = store.load(index, {});
    if (!step)
        return std::nullopt;
    record.speed = speed_range((*step)->velocity(), fluid);
    for (std::size_t i = 0; i < store.layout().scalars.size(); ++i) {
        const auto values = store.load_scalar(i, index, {});
        if (!values)
            return std::nullopt;
        const auto bytes = values->bytes();
        record.scalars.push_back(value_range(
            {reinterpret_cast<const float*>(bytes.data()), bytes.size() / sizeof(float)}));
    }
    return record;
}

} // namespace wakesurf::importer
