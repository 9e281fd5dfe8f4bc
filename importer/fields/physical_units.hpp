// What the names of units mean that files state: by UDUNITS-2, the library of the CF conventions. Everything a flow is computed
// from comes to metres, seconds and kilograms, since a path in kilometres and hours of a velocity in metres a second is wrong.
#pragma once

#include "core/base/result.hpp"

#include <optional>
#include <string>

namespace wakesurf::importer {

enum class Quantity { Length, Time, Velocity, Momentum, Density };

/// m, s, m s-1, kg m-2 s-1, kg m-3.
const char* si_unit(Quantity quantity);

/// Error: Io, where the library's database of units is not installed. Cost: reads it the first time, 10 ms.
core::Result<void> check_units_known();

// REQUIRES of the following: check_units_known().

/// A unit at all, of whatever quantity?
bool is_unit(const std::string& text);

/// A number without a unit: 1, count; also angles.
bool is_plain_number(const std::string& text);

/// By what a value in this unit is multiplied to be in the quantity's own; nothing where it is no unit of that quantity, or one
/// that has an offset.
std::optional<double> factor_to_si(const std::string& text, Quantity quantity);

/// Whether values in the two units can stand beside each other as they are; also where one of them is not known.
bool may_be_same(const std::string& first, const std::string& second);

/// Months and years: calendars make them longer and shorter.
bool varies_in_length(const std::string& text);

/// "hours since 2000-01-01" -> hours, 2000-01-01; without a reference the second is empty.
struct UnitOfTime {
    std::string unit;
    std::string reference;
};

UnitOfTime split_reference(const std::string& text);

/// Seconds from the first reference to the second, in the usual calendar; nothing where one is no point in time.
std::optional<double> seconds_between(const std::string& first, const std::string& second);

} // namespace wakesurf::importer
