// A field's values at a time-step -> its files in a store, whole or in bricks, in the store's precision.
#pragma once

#include "core/base/result.hpp"
#include "store/store_layout.hpp"
#include "store/store_writer.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace wakesurf::store {

/// The next values, x fastest, valid until the next call; none at the end.
using NextValues = std::function<core::Result<std::span<const float>>()>;

/// Returns what StoreWriter::finish_step wants to know of the column. Memory: of bricks, as BrickSlabs.
/// Error: Io, or what `next` reports. Nothing is left of the file being written then.
core::Result<std::uint32_t> write_values(StoreWriter& writer,
                                         const StoreLayout& layout,
                                         std::size_t column,
                                         std::size_t index,
                                         const NextValues& next);

/// Writes values that are in memory.
core::Result<std::uint32_t> write_values(StoreWriter& writer,
                                         const StoreLayout& layout,
                                         std::size_t column,
                                         std::size_t index,
                                         std::span<const float> values);

} // namespace wakesurf::store
