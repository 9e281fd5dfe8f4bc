#include "server/import/kept_steps.hpp"

#include <algorithm>

namespace wakesurf::server {

namespace {

std::shared_ptr<const core::StoreReader> open_store(const protocol::StoreManifest& manifest,
                                                    const std::filesystem::path& folder) {
    auto reader = core::StoreReader::open(protocol::store_layout(manifest, folder),
                                          std::make_shared<core::PosixDisk>());
    return reader ? *reader : nullptr;
}

bool has_size(const std::filesystem::path& file, std::size_t bytes) {
    const auto size = core::PosixDisk().size(file);
    return size && *size == bytes;
}

bool whole_step(const StoreWriter& writer, const core::StoreLayout& layout, std::size_t index) {
    const auto whole = [&](std::string_view stem, std::size_t components) {
        return has_size(writer.folder() / core::step_file_name(stem, index, layout.precision),
                        core::step_file_size(layout.grid.nodes(), components, layout.precision));
    };
    return writer.finished_step(index, 1 + layout.scalars.size()) &&
           whole(core::velocity_stem, 3) &&
           std::all_of(layout.scalars.begin(), layout.scalars.end(),
                       [&](const core::StoredScalar& scalar) { return whole(scalar.stem, 1); });
}

std::vector<core::StoredScalar> stored_scalars(const ImportPlan& plan) {
    std::vector<core::StoredScalar> out;
    for (const auto& scalar : plan.choice.scalars)
        out.push_back(scalar.stored);
    return out;
}

// How many time-steps of the plan the store was made for; 0 where it was made for another source.
std::size_t common_steps(const protocol::StoreManifest& before, const ImportPlan& plan) {
    const auto& old = before.source;
    const std::size_t count = old.steps.size();
    const bool same =
        old.files == plan.made_from.files && old.selection == plan.made_from.selection &&
        before.layout.precision == plan.precision &&
        before.layout.scalars == stored_scalars(plan) &&
        before.info.velocity == plan.choice.velocity_name && count > 0 &&
        count <= plan.made_from.steps.size() && before.layout.times.size() == count &&
        std::equal(old.steps.begin(), old.steps.end(), plan.made_from.steps.begin()) &&
        std::equal(before.layout.times.begin(), before.layout.times.end(), plan.times.begin());
    return same ? count : 0;
}

} // namespace

std::optional<EarlierImport> earlier_import(const StoreWriter& writer, const ImportPlan& plan) {
    auto before = protocol::read_store_manifest(writer.folder(), core::PosixDisk());
    if (!before)
        return std::nullopt;
    const std::size_t count = common_steps(*before, plan);
    if (count == 0)
        return std::nullopt;
    auto reader = open_store(*before, writer.folder());
    if (reader == nullptr)
        return std::nullopt;
    EarlierImport found{std::move(*before), count == plan.times.size(), std::move(reader), {}};
    for (std::size_t i = 0; i < plan.times.size(); ++i)
        found.kept.push_back(i < count && whole_step(writer, found.manifest.layout, i));
    return found;
}

std::optional<StepRecord> recorded(const core::StoreReader& store,
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

} // namespace wakesurf::server
