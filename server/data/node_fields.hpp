// The scalar fields of a dataset at the nodes of its grid, of which level sets are extracted: stored ones, or
// derived from the velocity. The last one stays loaded, so that dragging a level costs the extraction alone.
#pragma once

#include "core/base/memory_account.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/field/flow.hpp"
#include "core/field/sampled_field.hpp"
#include "core/surface/level/level_source.hpp"
#include "store/store_reader.hpp"
#include "store/store_scalars.hpp"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

struct NodeField {
    enum class Source : std::uint8_t { Scalar, Speed, VelocityComponent, Gradient };

    std::string name;
    Source source = Source::Scalar;
    std::size_t index = 0; ///< of the scalar, of the component, or of the derived field

    bool operator==(const NodeField&) const = default;
};

/// Finds a field by its name: a stored scalar, the velocity for its magnitude, or what is made of the velocity.
/// @param scalars    of the store; null for a built-in flow
/// @param parameter  that has the name, for the error. Error: NotFound, saying what there is.
core::Result<NodeField> find_node_field(const std::string& name,
                                        const core::DatasetInfo& info,
                                        const store::StoreScalars* scalars,
                                        std::string_view parameter = "field");

/// Returns the field for samplers, which must not outlive `scalars`.
core::SampledField sampled(const NodeField& field, const store::StoreScalars* scalars);

/// Thread-safe.
class NodeFields final : public core::LevelSource {
  public:
    struct Options {
        std::optional<core::MemoryAccount> account{}; ///< empty: not counted
        /// The fields of the dataset's files, stored or not.
        std::vector<core::FieldInfo> of_files{};
    };

    /// @param velocity  the name of the dataset's
    /// @param scalars   of the store; null: its present ones
    NodeFields(std::shared_ptr<const core::Flow> flow,
               std::shared_ptr<const store::StoreReader> store,
               std::string velocity,
               Options options,
               std::shared_ptr<const store::StoreScalars> scalars = nullptr);
    ~NodeFields() override;

    const core::Grid& grid() const override { return store_->grid(); }

    /// Values are linear between time-steps, and NaN in obstacles. One thread at a time loads; a job of the
    /// compute pool that waits for another lends its place to others meanwhile.
    core::Result<std::shared_ptr<const core::NodeValues>>
    values(const std::string& name, double time, const std::stop_token& stop) const override;
    core::Result<void> check_field(const std::string& name) const override;

  private:
    struct Loaded;
    class Turn;

    core::Result<NodeField> find(const std::string& name) const;
    core::Result<std::shared_ptr<const Loaded>>
    load(const NodeField& field, double time, const std::stop_token& stop) const;
    core::Result<void> read(const NodeField& field,
                            double time,
                            std::span<float> out,
                            const std::stop_token& stop) const;

    std::shared_ptr<const core::Flow> flow_;
    std::shared_ptr<const store::StoreReader> store_;
    std::shared_ptr<const store::StoreScalars> scalars_;
    std::string velocity_;
    Options options_;
    mutable std::mutex mutex_; ///< guards what follows
    mutable std::condition_variable_any idle_;
    mutable bool loading_ = false;
    mutable std::shared_ptr<const Loaded> loaded_; ///< null: none
    std::shared_ptr<void> ticket_;
};

} // namespace wakesurf::server
