// The meaning of units that files name, by UDUNITS-2, the library of the CF conventions. Everything that a
// flow is computed from is converted to metres, seconds and kilograms: a path in kilometres and hours of a
// velocity in metres a second would be wrong.
#pragma once

#include "core/base/result.hpp"

#include <optional>
#include <string>

namespace wakesurf::importer {

enum class Quantity { Length, Time, Velocity, Momentum, Density };

/// Returns m, s, m s-1, kg m-2 s-1 or kg m-3.
const char* si_unit(Quantity quantity);

/// Returns Io if the library's database of units is not installed. Cost: reads it the first time, 10 ms.
core::Result<void> check_units_known();

// The functions below REQUIRE check_units_known().

/// Says whether a text is a unit, of whatever quantity.
bool is_unit(const std::string& text);

/// Says whether a text stands for a number without a unit: 1, count; also angles.
bool is_plain_number(const std::string& text);

/// Returns the factor from values in this unit to the quantity's own; empty if it is no unit of that
/// quantity, or one that has an offset.
std::optional<double> factor_to_si(const std::string& text, Quantity quantity);

/// Says whether values in the two units can stand beside each other as they are; true if one of them is
/// unknown.
bool may_be_same(const std::string& first, const std::string& second);

/// Is true of months and years: calendars make them longer and shorter.
bool varies_in_length(const std::string& text);

/// Splits "hours since 2000-01-01" into hours and 2000-01-01; without a reference the second is empty.
struct UnitOfTime {
    std::string unit;
    std::string reference;
};

UnitOfTime split_reference(const std::string& text);

/// Returns the seconds from the first reference to the second, in the usual calendar; empty if one is no
/// point in time.
std::optional<double> seconds_between(const std::string& first, const std::string& second);

} // namespace wakesurf::importer
