#include "core/surface/measures/closed_curve.hpp"

#include "core/surface/contour_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace wakesurf::core {

std::string NoCurve::of_plane() const {
    switch (why) {
    case Why::NotMet:
        return "the surface does not meet it";
    case Why::Several:
        return "the surface meets it along " + std::to_string(curves) + " curves";
    case Why::Open:
        return "the curve along which the surface meets it is not closed";
    case Why::Younger:
        return "not all particles have come to it at that age";
    case Why::LeavesData:
        return "what the tube encloses there is partly outside the data";
    }
    return {};
}

std::string NoCurve::of_ring() const {
    switch (why) {
    case Why::Several:
        return "the particles of that age form " + std::to_string(curves) + " curves";
    case Why::LeavesData:
        return "what the tube encloses there is partly outside the data";
    default:
        return "the particles of that age form no closed curve, as some have ended";
    }
}

tl::expected<ClosedCurve, NoCurve> closed_curve(const QuadComplex& mesh,
                                                const VertexFunction& function,
                                                std::span<const double> ages,
                                                double most_age,
                                                std::span<const std::span<const double>> errors) {
    constexpr std::array zero{0.0};
    const auto with = [&](std::span<const double> carried) {
        return contour_lines(mesh, function, zero, {false, carried});
    };
    auto lines = with(mesh.s);
    if (lines.empty())
        return tl::unexpected(NoCurve{NoCurve::Why::NotMet});
    if (lines.size() > 1)
        return tl::unexpected(NoCurve{NoCurve::Why::Several, lines.size()});
    if (!lines.front().closed)
        return tl::unexpected(NoCurve{NoCurve::Why::Open});
    const auto old = with(ages).front().carried;
    if (*std::ranges::max_element(old) > most_age * (1.0 + 1e-6))
        return tl::unexpected(NoCurve{NoCurve::Why::Younger});
    ClosedCurve out{std::move(lines.front().points), {}, 1};
    // Where s goes round, it jumps back once.
    const std::vector<double>& s = lines.front().carried;
    int grows = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const double change = s[(i + 1) % s.size()] - s[i];
        if (change != 0.0)
            grows += (change > 0.0) == (std::abs(change) < 0.5) ? 1 : -1;
    }
    out.sense = grows < 0 ? -1 : 1;
    for (const std::span<const double> error : errors)
        out.errors.push_back(with(error).front().carried);
    return out;
}

} // namespace wakesurf::core
