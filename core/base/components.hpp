// Three components in two registers of two doubles, which every x86-64 has: by itself the compiler leaves
// them scalar.
#pragma once

#include "core/base/vec3.hpp"

namespace wakesurf::core {

struct Components {
    using Pair = double __attribute__((vector_size(16)));
    Pair xy{}, z{};

    Components() = default;

    Components(Pair xy_, Pair z_) : xy(xy_), z(z_) {}

    explicit Components(const Vec3& v) : xy{v.x, v.y}, z{v.z, 0.0} {}

    friend Components operator+(const Components& a, const Components& b) {
        return {a.xy + b.xy, a.z + b.z};
    }

    friend Components operator-(const Components& a, const Components& b) {
        return {a.xy - b.xy, a.z - b.z};
    }

    friend Components operator*(const Components& a, double k) { return {a.xy * k, a.z * k}; }

    Vec3 vector() const { return {xy[0], xy[1], z[0]}; }
};

} // namespace wakesurf::core
