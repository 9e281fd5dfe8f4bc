#include "store/store_scalars.hpp"

#include "core/base/crc32c.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

namespace wakesurf::store {

using core::Error;
using core::Result;
using core::Slab;

namespace {

/// The number of the file of a time-step that has none.
constexpr auto no_file = std::numeric_limits<std::uint32_t>::max();

} // namespace

std::shared_ptr<const StoreScalars> StoreScalars::open(std::shared_ptr<const StoreReader> reader,
                                                       std::shared_ptr<const core::Disk> disk) {
    return std::shared_ptr<const StoreScalars>(
        new StoreScalars(std::move(reader), std::move(disk)));
}

StoreScalars::StoreScalars(std::shared_ptr<const StoreReader> reader,
                           std::shared_ptr<const core::Disk> disk)
    : reader_(std::move(reader)), disk_(std::move(disk)),
      nodes_(static_cast<std::size_t>(reader_->layout().grid.nodes())) {
    const auto& layout = reader_->layout();
    const auto marks = reader_->marks();
    auto families = read_families(layout.folder, *disk_).value_or(std::vector<StoredFamily>());
    for (const StoredFamily& each : current_families(std::move(families), marks))
        take(each);
    auto means = read_means(layout.folder, *disk_).value_or(std::vector<StoredMean>());
    for (const StoredMean& each : current_means(std::move(means), layout, marks))
        take(each);
    recent_ = std::make_unique<core::ScalarSteps>(std::min<std::size_t>(2, kept_.size()));
}

void StoreScalars::take(const StoredFamily& family) {
    families_.push_back(family.record);
    Kept kept{family.record.name,
              "remove the family " + family.record.name + " and make it again",
              {family.stem, std::vector<std::uint32_t>(times().size(), no_file), {}}};
    // One file a time-step, with its number.
    kept.column.sums.resize(times().size());
    for (std::size_t i = 0; i < family.record.steps.size(); ++i) {
        const core::FamilyStep& step = family.record.steps[i];
        kept.column.file[step.index] = static_cast<std::uint32_t>(step.index);
        kept.column.sums[step.index] = family.sums[i].values;
        kept.times.push_back(step.time);
    }
    take(std::move(kept));
}

void StoreScalars::take(const StoredMean& mean) {
    means_.push_back(mean.record);
    const auto columns = columns_of(mean, times());
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string& name = mean.record.fields[i].name;
        take(Kept{name,
                  "remove the mean " + name + " and make it again",
                  columns[i],
                  {},
                  reader_->add(columns[i])});
    }
}

void StoreScalars::take(Kept kept) {
    mark_ +=
        fmt::format("{}:{}-{} ", kept.name, kept.column.stem, fmt::join(kept.column.sums, "-"));
    kept_.push_back(std::move(kept));
}

std::vector<std::string> StoreScalars::names() const {
    std::vector<std::string> names;
    for (const StoredScalar& each : reader_->layout().scalars)
        names.push_back(each.name);
    for (const Kept& each : kept_)
        names.push_back(each.name);
    return names;
}

Result<std::size_t> StoreScalars::find(std::string_view name) const {
    auto scalar = find_scalar(reader_->layout(), name);
    if (scalar || kept_.empty())
        return scalar;
    const auto found = std::ranges::find(kept_, name, &Kept::name);
    if (found != kept_.end())
        return imported() + static_cast<std::size_t>(found - kept_.begin());
    scalar.error().hint = fmt::format("there is {}", fmt::join(names(), ", "));
    return scalar;
}

std::vector<double> StoreScalars::times_of(std::size_t scalar) const {
    return scalar >= imported() && scalar - imported() < kept_.size()
               ? kept_[scalar - imported()].times
               : std::vector<double>();
}

std::optional<std::size_t> StoreScalars::brick_field(std::size_t scalar) const {
    if (scalar < imported())
        return reader_->brick_field(scalar);
    if (scalar - imported() >= kept_.size())
        return std::nullopt;
    const auto& number = kept_[scalar - imported()].number;
    return number ? reader_->brick_field(*number) : std::nullopt;
}

Result<std::shared_ptr<const Slab>> StoreScalars::scalar_values(std::size_t scalar,
                                                                std::size_t index,
                                                                const std::stop_token& stop) const {
    if (scalar < imported())
        return reader_->scalar_values(scalar, index, stop);
    if (scalar - imported() >= kept_.size())
        return core::fail(Error::Code::NotFound, "there is no such scalar field");
    const Kept& kept = kept_[scalar - imported()];
    const std::uint32_t file = kept.column.file.at(index);
    return recent_->get(scalar, file, [&] { return load(kept, file, stop); });
}

Result<Slab>
StoreScalars::load(const Kept& kept, std::uint32_t file, const std::stop_token& stop) const {
    Slab slab(step_file_size(nodes_, 1, core::Precision::Single));
    const auto nowhere = [&] {
        auto* const values = reinterpret_cast<float*>(slab.bytes().data());
        std::fill_n(values, nodes_, std::numeric_limits<float>::quiet_NaN());
        return std::move(slab);
    };
    if (file == no_file)
        return nowhere();
    const std::string name = step_file_name(kept.column.stem, file, core::Precision::Single);
    const auto path = reader_->layout().folder / name;
    const auto size = disk_->size(path);
    if (!size && size.error().code == Error::Code::NotFound)
        return nowhere();
    if (kept.number) {
        const auto step = std::ranges::find(kept.column.file, file) - kept.column.file.begin();
        return reader_->load_scalar(*kept.number, static_cast<std::size_t>(step), stop);
    }
    if (auto read = disk_->read(path, 0, slab.bytes()); !read)
        return tl::unexpected(read.error());
    if (core::crc32c(slab.bytes()) != kept.column.sums[file])
        return core::fail(Error::Code::Corrupt,
                          name + " has changed since it was written: its checksum differs",
                          kept.again);
    return slab;
}

std::size_t StoreScalars::kept_memory(bool by_brick) const {
    const auto whole = static_cast<std::size_t>(
        std::ranges::count_if(kept_, [&](const Kept& each) { return !by_brick || !each.number; }));
    return std::min(whole, recent_->most()) *
           Slab::reservation(step_file_size(nodes_, 1, core::Precision::Single));
}

} // namespace wakesurf::store
