#include "store/finite_values.hpp"

#include <cstdint>
#include <cstring>

namespace wakesurf::store {

namespace {

// An exponent of all ones is infinity or NaN; or-ing keeps the loop free of branches.
template <class Bits, Bits exponent>
bool all_finite_bits(std::span<const std::byte> values) {
    std::uint32_t bad = 0;
    for (std::size_t at = 0; at + sizeof(Bits) <= values.size(); at += sizeof(Bits)) {
        Bits bits = 0;
        std::memcpy(&bits, values.data() + at, sizeof(bits));
        bad |= static_cast<std::uint32_t>((bits & exponent) == exponent);
    }
    return bad == 0;
}

} // namespace

bool all_finite(std::span<const std::byte> values, core::Precision precision) {
    return precision == core::Precision::Half ? all_finite_bits<std::uint16_t, 0x7c00u>(values)
                                              : all_finite_bits<std::uint32_t, 0x7f800000u>(values);
}

} // namespace wakesurf::store
