// The scalar fields of a store for samplers: the imported ones, then the families and the means that were made
// since.
#pragma once

#include "core/base/disk.hpp"
#include "core/dataset/scalar_steps.hpp"
#include "core/dataset/slab.hpp"
#include "store/store_reader.hpp"
#include "store/stored_families.hpp"
#include "store/stored_means.hpp"

#include <cstddef>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::store {

/// Serves families and means as they were when it was opened; opening it again costs the reading of two small
/// files. Thread safety: concurrent calls are fine.
class StoreScalars final : public core::ScalarSource {
  public:
    /// Opens the scalars, without families and means of replaced values. A list that cannot be read counts as
    /// empty.
    static std::shared_ptr<const StoreScalars> open(std::shared_ptr<const StoreReader> reader,
                                                    std::shared_ptr<const core::Disk> disk);

    const std::vector<core::FamilyRecord>& families() const { return families_; }

    const std::vector<core::MeanRecord>& means() const { return means_; }

    /// Changes with what is kept and its values; empty: there is nothing.
    const std::string& mark() const { return mark_; }

    /// Returns the names of all scalars, in the order of their numbers.
    std::vector<std::string> names() const;

    /// Returns the scalar's number. Error: NotFound, listing what there is.
    core::Result<std::size_t> find(std::string_view name) const;

    /// Returns the times at which a family has values; empty for others, which have values at all.
    std::vector<double> times_of(std::size_t scalar) const;

    const std::vector<double>& times() const override { return reader_->times(); }

    /// Returns one float a node. A family at a time-step that it was not made for has no value at any node;
    /// nor have a family and a mean that were removed.
    core::Result<std::shared_ptr<const core::Slab>> scalar_values(
        std::size_t scalar, std::size_t index, const std::stop_token& stop) const override;

    /// Returns the brick field of an imported scalar or a mean: families are whole.
    std::optional<std::size_t> brick_field(std::size_t scalar) const override;

    /// Returns the bytes that are kept of families and means at most.
    /// @param by_brick  what is in bricks is read brick by brick
    std::size_t kept_memory(bool by_brick) const;

  private:
    /// A scalar that was made here.
    struct Kept {
        std::string name;
        std::string again; ///< how it is made again
        KeptColumn column;
        std::vector<double> times{};         ///< it has values at these alone; empty: at all
        std::optional<std::size_t> number{}; ///< of the reader's, where it is in bricks
    };

    StoreScalars(std::shared_ptr<const StoreReader> reader, std::shared_ptr<const core::Disk> disk);

    void take(const StoredFamily& family);
    void take(const StoredMean& mean);
    void take(Kept kept);

    std::size_t imported() const { return reader_->layout().scalars.size(); }

    core::Result<core::Slab>
    load(const Kept& kept, std::uint32_t file, const std::stop_token& stop) const;

    std::shared_ptr<const StoreReader> reader_;
    std::shared_ptr<const core::Disk> disk_;
    std::vector<core::FamilyRecord> families_;
    std::vector<core::MeanRecord> means_;
    std::vector<Kept> kept_;
    std::string mark_;
    std::size_t nodes_;
    std::unique_ptr<core::ScalarSteps> recent_;
};

} // namespace wakesurf::store
