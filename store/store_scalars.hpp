// The scalar fields of a store for samplers: the imported ones, then the families that were made since.
#pragma once

#include "core/base/disk.hpp"
#include "core/dataset/scalar_steps.hpp"
#include "core/dataset/slab.hpp"
#include "store/store_reader.hpp"
#include "store/stored_families.hpp"

#include <cstddef>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

/// Serves the families as they were when it was opened; opening it again costs the reading of one small file.
/// Thread safety: concurrent calls are fine.
class StoreScalars final : public core::ScalarSource {
  public:
    /// Opens the scalars, without families of replaced velocities. A families.json that cannot be read counts
    /// as none.
    static std::shared_ptr<const StoreScalars> open(std::shared_ptr<const StoreReader> reader,
                                                    std::shared_ptr<const core::Disk> disk);

    const std::vector<core::FamilyRecord>& families() const { return records_; }

    /// Changes with the families and their values; empty: there are none.
    const std::string& mark() const { return mark_; }

    /// Returns the names of all scalars, in the order of their numbers.
    std::vector<std::string> names() const;

    /// Returns the scalar's number. Error: NotFound, listing what there is.
    core::Result<std::size_t> find(std::string_view name) const;

    /// Returns the times at which a family has values; empty for an imported scalar, which has values at all.
    std::vector<double> times_of(std::size_t scalar) const;

    const std::vector<double>& times() const override { return reader_->times(); }

    /// Returns one float a node. A family at a time-step that it was not made for has no value at any node,
    /// also once it was removed.
    core::Result<std::shared_ptr<const core::Slab>> scalar_values(
        std::size_t scalar, std::size_t index, const std::stop_token& stop) const override;

    /// Returns the brick field of an imported scalar: families are whole.
    std::optional<std::size_t> brick_field(std::size_t scalar) const override {
        return scalar < imported() ? reader_->brick_field(scalar) : std::nullopt;
    }

    /// Returns the bytes that are kept of families at most.
    std::size_t family_memory() const;

  private:
    StoreScalars(std::shared_ptr<const StoreReader> reader,
                 std::shared_ptr<const core::Disk> disk,
                 std::vector<StoredFamily> families);

    std::size_t imported() const { return reader_->layout().scalars.size(); }

    core::Result<core::Slab> load(const StoredFamily& family, std::size_t index) const;

    std::shared_ptr<const StoreReader> reader_;
    std::shared_ptr<const core::Disk> disk_;
    std::vector<StoredFamily> families_;
    std::vector<core::FamilyRecord> records_;
    std::string mark_;
    std::size_t nodes_;
    std::unique_ptr<core::ScalarSteps> kept_;
};

} // namespace wakesurf::store
