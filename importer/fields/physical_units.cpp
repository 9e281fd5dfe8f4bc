#include "importer/fields/physical_units.hpp"

#include "importer/base/text.hpp"

#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <string_view>

namespace wakesurf::importer {

namespace {

struct FreeUnit {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};

using Unit = std::unique_ptr<ut_unit, FreeUnit>;

// Returns the database, which lives as long as the process; null if it is not installed.
ut_system* database() {
    static ut_system* const read = [] {
        ut_set_error_message_handler(ut_ignore); // it would print
        return ut_read_xml(nullptr);
    }();
    return read;
}

Unit parsed(std::string text) {
    const auto first = text.find_first_not_of(" \t\n");
    const auto last = text.find_last_not_of(" \t\n");
    text = first == std::string::npos ? "" : text.substr(first, last - first + 1);
    if (text.empty())
        return nullptr;
    if (Unit found(ut_parse(database(), text.c_str(), UT_UTF8)); found)
        return found;
    text = lower_case(text);
    return Unit(
        ut_parse(database(), text.c_str(), UT_UTF8)); // "Hours", which UDUNITS does not know
}

bool convertible(const Unit& unit, const char* to) {
    return unit && ut_are_convertible(unit.get(), parsed(to).get()) != 0;
}

struct FreeConverter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};

using Converter = std::unique_ptr<cv_converter, FreeConverter>;

Converter converter(const Unit& from, const Unit& to) {
    return Converter(from && to ? ut_get_converter(from.get(), to.get()) : nullptr);
}

} // namespace

const char* si_unit(Quantity quantity) {
    constexpr std::array names{"m", "s", "m s-1", "kg m-2 s-1", "kg m-3"};
    return names[static_cast<std::size_t>(quantity)];
}

core::Result<void> check_units_known() {
    if (database() != nullptr)
        return {};
    return core::fail(core::Error::Code::Io, "the database of units is not installed",
                      "install the package libudunits2-data");
}

bool is_unit(const std::string& text) {
    return parsed(text) != nullptr;
}

bool is_plain_number(const std::string& text) {
    return convertible(parsed(text), "1");
}

std::optional<double> factor_to_si(const std::string& text, Quantity quantity) {
    const Unit unit = parsed(text);
    const char* to = si_unit(quantity);
    if (!convertible(unit, to))
        return std::nullopt;
    const auto convert = converter(unit, parsed(to));
    if (!convert || cv_convert_double(convert.get(), 0.0) != 0.0)
        return std::nullopt;
    const double factor = cv_convert_double(convert.get(), 1.0);
    return std::isfinite(factor) && factor > 0.0 ? std::optional(factor) : std::nullopt;
}

bool may_be_same(const std::string& first, const std::string& second) {
    const Unit a = parsed(first);
    const Unit b = parsed(second);
    return !a || !b || ut_compare(a.get(), b.get()) == 0;
}

bool varies_in_length(const std::string& text) {
    const auto seconds = factor_to_si(text, Quantity::Time);
    const auto year = factor_to_si("year", Quantity::Time);
    const auto month = factor_to_si("month", Quantity::Time);
    constexpr double rounding = 1e-9;
    const auto same = [&](const std::optional<double>& other) {
        return seconds && other && std::abs(*seconds / *other - 1.0) < rounding;
    };
    return same(year) || same(month);
}

UnitOfTime split_reference(const std::string& text) {
    constexpr std::string_view since = " since ";
    for (std::size_t at = 0; at + since.size() <= text.size(); ++at) {
        bool here = true;
        for (std::size_t i = 0; here && i < since.size(); ++i)
            here = (text[at + i] | ' ') == since[i];
        if (here)
            return {text.substr(0, at), text.substr(at + since.size())};
    }
    return {text, {}};
}

std::optional<double> seconds_between(const std::string& first, const std::string& second) {
    const auto convert =
        converter(parsed("seconds since " + second), parsed("seconds since " + first));
    if (!convert)
        return std::nullopt;
    return cv_convert_double(convert.get(), 0.0);
}

} // namespace wakesurf::importer
