// Where the number of a file is in its name, and whether a dot in it is that of a decimal: `flow_0.25` is at a quarter, while
// `out2.10` is the tenth of a series called out2.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace wakesurf::importer {

/// A name in three parts.
struct NumberInName {
    std::string prefix;
    std::string number; ///< digits, perhaps with a sign, a dot or an exponent
    std::string suffix; ///< with the extension
};

/// The last number of a name without its extension: digits that no letter follows, with a sign where a separator is before
/// it, with what stands before a dot, and with an exponent that has a sign: a_10_b.vtk, t_-3.vtk, t_0.25.vtk, t_1e-05.vtk.
std::optional<NumberInName> number_in_name(const std::string& name);

/// The same where the dot separates: what is before it goes to the prefix.
NumberInName behind_the_dot(const NumberInName& whole);

/// The value of a name's middle between `prefix` and what follows it; nothing where it is no number.
/// @param decimals  dots and exponents are allowed
std::optional<double>
number_after(const std::string& prefix, const std::string& text, bool decimals);

/// Whether the dots in the numbers of a series are those of decimals. Where both readings fit, what stands before tells: out2.1, but t0.5.
/// @param numbers  of all files with one prefix and suffix
bool are_decimals(const std::string& prefix, std::span<const std::string> numbers);

} // namespace wakesurf::importer
