#include "store/store_scalars.hpp"

#include "core/base/crc32c.hpp"

#include <algorithm>
#include <limits>

namespace wakesurf::store {

using core::Error;
using core::Result;
using core::Slab;

std::shared_ptr<const StoreScalars> StoreScalars::open(std::shared_ptr<const StoreReader> reader,
                                                       std::shared_ptr<const core::Disk> disk) {
    auto found =
        read_families(reader->layout().folder, *disk).value_or(std::vector<StoredFamily>());
    auto current = current_families(std::move(found), reader->marks());
    return std::shared_ptr<const StoreScalars>(
        new StoreScalars(std::move(reader), std::move(disk), std::move(current)));
}

StoreScalars::StoreScalars(std::shared_ptr<const StoreReader> reader,
                           std::shared_ptr<const core::Disk> disk,
                           std::vector<StoredFamily> families)
    : reader_(std::move(reader)), disk_(std::move(disk)), families_(std::move(families)),
      nodes_(static_cast<std::size_t>(reader_->layout().grid.nodes())),
      kept_(std::make_unique<core::ScalarSteps>(std::min<std::size_t>(2, families_.size()))) {
    for (const StoredFamily& each : families_) {
        records_.push_back(each.record);
        mark_ += each.record.name + ":" + each.stem;
        for (const StoredFamily::Sums& sums : each.sums)
            mark_.append("-").append(std::to_string(sums.values));
        mark_ += " ";
    }
}

std::vector<std::string> StoreScalars::names() const {
    std::vector<std::string> names;
    for (const StoredScalar& each : reader_->layout().scalars)
        names.push_back(each.name);
    for (const core::FamilyRecord& each : records_)
        names.push_back(each.name);
    return names;
}

Result<std::size_t> StoreScalars::find(std::string_view name) const {
    const auto found = std::ranges::find(records_, name, &core::FamilyRecord::name);
    auto scalar = find_scalar(reader_->layout(), name);
    if (scalar || found == records_.end()) {
        if (!scalar && !records_.empty()) {
            scalar.error().hint = "there is ";
            for (const std::string& each : names())
                scalar.error().hint += (scalar.error().hint.size() > 9 ? ", " : "") + each;
        }
        return scalar;
    }
    return imported() + static_cast<std::size_t>(found - records_.begin());
}

std::vector<double> StoreScalars::times_of(std::size_t scalar) const {
    std::vector<double> out;
    if (scalar >= imported() && scalar - imported() < records_.size())
        for (const core::FamilyStep& step : records_[scalar - imported()].steps)
            out.push_back(step.time);
    return out;
}

Result<std::shared_ptr<const Slab>> StoreScalars::scalar_values(std::size_t scalar,
                                                                std::size_t index,
                                                                const std::stop_token& stop) const {
    if (scalar < imported())
        return reader_->scalar_values(scalar, index, stop);
    if (scalar - imported() >= families_.size())
        return core::fail(Error::Code::NotFound, "there is no such scalar field");
    return kept_->get(scalar, index, [&] { return load(families_[scalar - imported()], index); });
}

Result<Slab> StoreScalars::load(const StoredFamily& family, std::size_t index) const {
    Slab slab(step_file_size(nodes_, 1, core::Precision::Single));
    const auto nowhere = [&] {
        auto* const values = reinterpret_cast<float*>(slab.bytes().data());
        std::fill_n(values, nodes_, std::numeric_limits<float>::quiet_NaN());
        return std::move(slab);
    };
    const auto& steps = family.record.steps;
    const auto step = std::ranges::find(steps, index, &core::FamilyStep::index);
    if (step == steps.end())
        return nowhere();
    const std::string name = step_file_name(family.stem, index, core::Precision::Single);
    const auto file = reader_->layout().folder / name;
    const auto size = disk_->size(file);
    if (!size && size.error().code == Error::Code::NotFound)
        return nowhere();
    if (auto read = disk_->read(file, 0, slab.bytes()); !read)
        return tl::unexpected(read.error());
    const auto& sums = family.sums[static_cast<std::size_t>(step - steps.begin())];
    if (core::crc32c(slab.bytes()) != sums.values)
        return core::fail(Error::Code::Corrupt,
                          name + " has changed since it was written: its checksum differs",
                          "remove the family " + family.record.name + " and make it again");
    return slab;
}

std::size_t StoreScalars::family_memory() const {
    return kept_->most() * Slab::reservation(step_file_size(nodes_, 1, core::Precision::Single));
}

} // namespace wakesurf::store
