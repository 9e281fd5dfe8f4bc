// The ranges of a surface's values, by attribute.
#pragma once

#include "core/surface/value_range.hpp"

#include <string>
#include <vector>

namespace wakesurf::server {

/// Holds the range of one attribute of the frames.
struct AnnouncedRange {
    std::string attribute;
    core::ValueRange range;

    bool operator==(const AnnouncedRange&) const = default;
};

using ValueRanges = std::vector<AnnouncedRange>;

} // namespace wakesurf::server
