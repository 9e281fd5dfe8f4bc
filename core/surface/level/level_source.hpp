// The source of the field that a level set is of: the scalars of a dataset, or a test's closed form.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/grid.hpp"

#include <array>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::core {

/// A scalar field at one time.
struct NodeValues {
    std::vector<float> values;             ///< one a node; not finite: none there
    std::array<double, 2> range{0.0, 0.0}; ///< of those that are finite
    bool any = true;                       ///< false: none is finite
    std::vector<double>
        times{}; ///< where there are none: those at which there are; empty: not known
};

/// Thread safety: concurrent calls are allowed.
class LevelSource {
  public:
    virtual ~LevelSource() = default;

    /// Returns the grid that the values are at the nodes of.
    virtual const Grid& grid() const = 0;

    /// Returns the values of a field. Error: NotFound, naming the fields there are; OverLimit without memory;
    /// Cancelled; what reading reports.
    virtual Result<std::shared_ptr<const NodeValues>>
    values(const std::string& field, double time, const std::stop_token& stop) const = 0;

    /// Checks that the field exists. Error: NotFound, naming the fields there are.
    virtual Result<void> check_field(const std::string& name) const = 0;
};

} // namespace wakesurf::core
