#include "importer/kept_steps.hpp"

#include <algorithm>

namespace wakesurf::importer {

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
    bool looked_at = manifest.complete && written.has_value();
    if (!writer.finished_step(index, layout.columns()))
        return false;
    for (std::size_t column = 0; column < layout.columns(); ++column)
        for (const store::StepFile& expected : store::step_files(layout, column, index)) {
            const auto file = disk.identity(writer.folder() / expected.name);
            if (!file || file->size != expected.size)
                return false;
            looked_at = looked_at && file->modified <= written->modified;
        }
    return looked_at || !manifest.complete || recorded(reader, index, {}).has_value();
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
        found.kept.push_back(same_step(found.manifest, plan, i) &&
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
