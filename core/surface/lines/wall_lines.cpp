#include "core/surface/lines/wall_lines.hpp"

#include "core/surface/lines/thinned_line.hpp"
#include "core/surface/surface_parameters.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace wakesurf::core {

namespace {

/// Steps, after which a line ends.
constexpr std::size_t steps_of_wall_line = 50'000;
/// After so many steps with less way than this part of a gap a line has come to rest: it creeps along places where nearly nothing flows.
constexpr std::size_t steps_of_gap = 500;
constexpr double creeping = 0.1;
/// In a row without any way, at a corner where triangles hand a line round.
constexpr int steps_at_place = 64;
/// A step changes the place in its triangle by less than such a part: the series below is exact to rounding then.
constexpr double part_of_triangle = 0.25;
constexpr std::size_t terms = 9;
/// A line that crosses an edge so near the place where it did before is closed: in gaps.
constexpr double closed_within = 0.01;
/// Past the place on an edge where one of its triangles takes a line in again.
constexpr double past = 1e-9;
/// What the longest way along an edge to a place of rest takes, in ways at the first speed: it takes for ever.
constexpr double slowest = 1e-3;

/// The place in a triangle over a step, as a series in time.
struct Series {
    std::array<Vec3, terms> c;

    Vec3 at(double dt) const {
        Vec3 out = c.back();
        for (std::size_t k = terms - 1; k-- > 0;)
            out = c[k] + dt * out;
        return out;
    }

    double at(double dt, int i) const {
        double out = c.back()[i];
        for (std::size_t k = terms - 1; k-- > 0;)
            out = c[k][i] + dt * out;
        return out;
    }
};

/// Returns when one of the numbers, not below 0 now, is 0 that is below it at the end.
double time_of_zero(const Series& series, int i, double end) {
    double low = 0.0;
    double high = end;
    double at_low = std::max(series.at(0.0, i), 0.0);
    double at_high = series.at(end, i);
    for (int k = 0; k < 60 && high - low > 1e-15 * end; ++k) { // the Illinois method
        const double middle = low + (high - low) * at_low / (at_low - at_high);
        const double value = series.at(middle, i);
        if (value >= 0.0) {
            low = middle;
            at_low = value;
            at_high *= 0.5;
        } else {
            high = middle;
            at_high = value;
            at_low *= 0.5;
        }
        if (value == 0.0)
            return middle;
    }
    return low;
}

/// Follows one line.
class Follower {
  public:
    Follower(const WallWeb& web,
             const StreamLinesRequest& request,
             double sign,
             double gap,
             std::size_t most,
             WorkMemory& memory,
             ThinnedLine& line)
        : web_(web), request_(request), sign_(sign), gap_(gap), most_(most), memory_(memory),
          line_(line) {}

    void follow(std::uint32_t triangle, const Vec3& place, const std::stop_token& stop) {
        in_ = triangle;
        at_ = place;
        line_.begin(web_.place(in_, at_));
        value_ = web_.value(in_, at_);
        for (std::size_t step = 0;; ++step) {
            if (step == steps_of_wall_line || stop.stop_requested()) {
                line_.end = CurveEnd::Budget;
                break;
            }
            if (step > 0 && step % steps_of_gap == 0) {
                if (arc_ - arc_before_ < creeping * gap_) {
                    line_.end = CurveEnd::Stagnation;
                    break;
                }
                arc_before_ = arc_;
            }
            if (!advance())
                break;
        }
        line_.finish(most_, memory_);
    }

  private:
    /// A place on an edge of a triangle, seen from there.
    struct Edge {
        int out;  ///< its number
        double u; ///< so far along it
        WallWeb::Beyond beyond;
    };

    bool ends(CurveEnd end) {
        line_.end = end;
        return false;
    }

    /// Goes on through the triangle, to its edge at most.
    bool advance() {
        if (sliding_)
            return slide(*std::exchange(sliding_, std::nullopt));
        const auto found = web_.rates(in_);
        if (!found)
            return ends(CurveEnd::Domain);
        const WallWeb::Rates rates = sign_ * *found;
        const Vec3 rate = rates * at_;
        const double speed = glm::length(web_.way(in_, rate));
        if (!(speed > web_.rest()))
            return ends(CurveEnd::Stagnation);
        double fastest = 0.0;
        for (int i = 0; i < 3; ++i)
            fastest = std::max(fastest, std::abs(rates[0][i]) + std::abs(rates[1][i]) +
                                            std::abs(rates[2][i]));
        double dt = part_of_triangle / fastest;
        if (request_.duration > 0.0)
            dt = std::min(dt, request_.duration - time_);
        Series series;
        series.c[0] = at_;
        for (std::size_t k = 1; k < terms; ++k)
            series.c[k] = rates * series.c[k - 1] / static_cast<double>(k);
        const Vec3 after = series.at(dt);
        int out = -1;
        for (int i = 0; i < 3; ++i)
            if (after[i] < 0.0)
                if (const double when = time_of_zero(series, i, dt); out < 0 || when < dt) {
                    dt = when;
                    out = i;
                }
        standing_ = dt * fastest < 1e-12 ? standing_ + 1 : 0;
        if (standing_ > steps_at_place)
            return ends(CurveEnd::Stagnation);
        const Vec3 last = rates * series.at(dt);
        const double turn = angle_between(web_.way(in_, rate), web_.way(in_, last));
        const int parts = std::max(1, static_cast<int>(std::ceil(turn / turn_between)));
        for (int i = 1; i <= parts; ++i) {
            at_ = series.at(dt * i / parts);
            if (!add(web_.place(in_, at_), web_.value(in_, at_), dt / parts))
                return false;
        }
        return out < 0 || cross(out);
    }

    /// Takes a point, or what of the way to it is not too far. Returns false where the line ends.
    bool add(const Vec3& place, float value, double dt) {
        const Vec3 from = line_.here();
        const double way = glm::distance(from, place);
        double part = 1.0;
        bool on = true;
        const auto no_farther = [&](double left, double whole) {
            if (left > whole)
                return;
            part = std::min(part, whole > 0.0 ? left / whole : 1.0);
            on = false;
        };
        no_farther(request_.length - arc_, way);
        if (request_.duration > 0.0)
            no_farther(request_.duration - time_, dt);
        arc_ += part * way;
        time_ += part * dt;
        // What is mixed with no number is none for ever.
        value_ = on ? value : glm::mix(value_, value, static_cast<float>(part));
        const LinePoint next{glm::mix(from, place, part), static_cast<float>(sign_ * time_),
                             value_};
        return line_.add(next, arc_, gap_, most_, memory_) && on;
    }

    /// Crosses the edge that one corner is opposite to.
    bool cross(int out) {
        const int j = (out + 1) % 3, k = (out + 2) % 3;
        const double both = std::max(at_[j], 0.0) + std::max(at_[k], 0.0);
        const double u = both > 0.0 ? std::clamp(at_[k] / both, 0.0, 1.0) : 0.5;
        const auto beyond = web_.beyond(in_, out);
        if (!beyond)
            return ends(CurveEnd::Domain);
        if (closes(out, u))
            return false;
        const auto rates = web_.rates(beyond->triangle);
        if (!rates)
            return ends(CurveEnd::Domain);
        const Vec3 there = beyond->place(u);
        if ((sign_ * *rates * there)[beyond->opposite] > 0.0) {
            in_ = beyond->triangle;
            at_ = there;
            return true;
        }
        return slide({out, u, *beyond});
    }

    /// Says whether the line was at this place of this edge before: it is compared with a crossing that is moved on more and more seldom.
    bool closes(int out, double u) {
        const double length = glm::length(web_.edge(in_, out));
        if (in_ == marked_in_ && out == marked_out_ &&
            std::abs(u - marked_u_) * length < closed_within * gap_)
            return true;
        if (++crossings_ == next_mark_) {
            next_mark_ *= 2;
            marked_in_ = in_;
            marked_out_ = out;
            marked_u_ = u;
        }
        return false;
    }

    /// Goes along an edge to which the flow comes from both sides, as far as it does. What of the flow lies in the edge is the same in
    /// both triangles.
    bool slide(const Edge& on) {
        const auto& [out, u, beyond] = on;
        const int j = (out + 1) % 3, k = (out + 2) % 3;
        const WallWeb::Rates here = sign_ * *web_.rates(in_);
        const WallWeb::Rates there = sign_ * *web_.rates(beyond.triangle);
        const auto between = [](const std::pair<double, double>& of, double at) {
            return of.first + at * (of.second - of.first);
        };
        const Vec3 edge = web_.edge(in_, out);
        const double length = glm::length(edge);
        const auto along = [&](int corner) {
            return sign_ * glm::dot(web_.velocity(in_, corner), edge) / (length * length);
        };
        const std::pair speed{along(j), along(k)};
        const std::pair in_here{here[j][out], here[k][out]};
        const std::pair in_there{there[beyond.first][beyond.opposite],
                                 there[beyond.second][beyond.opposite]};
        const double now = between(speed, u);
        if (!(std::abs(now) * length > web_.rest()))
            return ends(CurveEnd::Stagnation);
        double to = now > 0.0 ? 1.0 : 0.0;
        enum class Then { Corner, Rest, Here, There } then = Then::Corner;
        const auto stop_at_zero = [&](const std::pair<double, double>& of, Then what) {
            const double zero = of.first / (of.first - of.second);
            if (std::isfinite(zero) && (zero - u) * now > 0.0 && (to - zero) * now > 0.0 &&
                (what == Then::Rest || (of.second - of.first) * now > 0.0)) {
                to = zero;
                then = what;
            }
        };
        stop_at_zero(speed, Then::Rest);
        stop_at_zero(in_here, Then::Here);
        stop_at_zero(in_there, Then::There);
        if (then == Then::Here || then == Then::There)
            to = std::clamp(to + std::copysign(past, now), 0.0, 1.0);
        const double ratio = std::max(between(speed, to) / now, slowest);
        const double dt =
            (to - u) / now * (std::abs(ratio - 1.0) < 1e-6 ? 1.0 : std::log(ratio) / (ratio - 1.0));
        standing_ = to == u ? standing_ + 1 : 0;
        if (standing_ > steps_at_place)
            return ends(CurveEnd::Stagnation);
        Vec3 at(0.0);
        at[j] = 1.0 - to;
        at[k] = to;
        if (!add(web_.place(in_, at), web_.value(in_, at), dt))
            return false;
        at_ = at;
        if (then == Then::Rest)
            return ends(CurveEnd::Stagnation);
        if (then == Then::Here)
            return true;
        if (then == Then::There) {
            in_ = beyond.triangle;
            at_ = beyond.place(to);
            return true;
        }
        return leave_corner(to == 1.0 ? k : j);
    }

    /// Goes on from a corner of the triangle: into the triangle that takes the line in, or along an edge.
    bool leave_corner(int corner) {
        const std::uint32_t triangle = in_;
        double best = 0.0;
        for (const auto& [other, c] : web_.around(triangle, corner)) {
            const auto rates = web_.rates(other);
            if (!rates)
                continue;
            const Vec3 rate = sign_ * (*rates)[c];
            const double least = std::min(rate[(c + 1) % 3], rate[(c + 2) % 3]);
            const double most = std::max(rate[(c + 1) % 3], rate[(c + 2) % 3]);
            if (least >= 0.0 && most > best) {
                best = most;
                enter(other, c);
            }
        }
        if (best > 0.0)
            return true;
        // Along the edge that lies most in the flow, of those to which it comes from both sides.
        double most = web_.rest();
        for (const auto& [other, c] : web_.around(triangle, corner))
            for (const int out : {(c + 1) % 3, (c + 2) % 3}) {
                const int far = 3 - c - out;
                const Vec3 way = web_.corner(other, far) - web_.corner(other, c);
                const double speed =
                    sign_ * glm::dot(web_.velocity(other, c), way) / glm::length(way);
                const auto beyond = web_.beyond(other, out);
                if (!(speed > most) || !beyond || !web_.rates(other) ||
                    !web_.rates(beyond->triangle))
                    continue;
                const bool first = c == (out + 1) % 3;
                const double into = sign_ * (*web_.rates(other))[c][out];
                const int there = first ? beyond->first : beyond->second;
                const double beyond_into =
                    sign_ * (*web_.rates(beyond->triangle))[there][beyond->opposite];
                if (into > 0.0 || beyond_into > 0.0)
                    continue;
                most = speed;
                enter(other, c);
                sliding_ = Edge{out, at_[(out + 2) % 3], *beyond};
            }
        return sliding_ || ends(CurveEnd::Stagnation);
    }

    void enter(std::uint32_t triangle, int corner) {
        in_ = triangle;
        at_ = Vec3(0.0);
        at_[corner] = 1.0;
    }

    std::optional<Edge> sliding_; ///< along it, next
    const WallWeb& web_;
    const StreamLinesRequest& request_;
    double sign_;
    double gap_;
    std::size_t most_;
    WorkMemory& memory_;
    ThinnedLine& line_;
    std::uint32_t in_ = 0; ///< the triangle
    Vec3 at_{0.0};         ///< the place in it, in parts of its corners
    float value_ = 0.0F;
    double arc_ = 0.0;
    double arc_before_ = 0.0; ///< some steps ago
    double time_ = 0.0;
    int standing_ = 0;
    std::size_t crossings_ = 0, next_mark_ = 1;
    std::uint32_t marked_in_ = WallWeb::none;
    int marked_out_ = -1;
    double marked_u_ = 0.0;
};

} // namespace

Result<StreamLines> trace_wall_lines(const StreamLinesRequest& request,
                                     const WallFlow& flow,
                                     std::span<const WallPlace> seeds,
                                     double gap,
                                     WorkMemory& memory,
                                     const std::stop_token& stop) {
    const std::size_t bytes = WallWeb::bytes(flow.wall);
    constexpr std::size_t line_bytes = 2 * sizeof(ThinnedLine) + sizeof(LinePoint);
    if (!memory.grow(bytes + seeds.size() * line_bytes))
        return tl::unexpected(memory.refusal());
    const WallWeb web(flow, SurfaceParameters{}.stagnation_speed);
    StreamLines lines;
    lines.seeds = static_cast<std::uint32_t>(seeds.size());
    lines.offsets.push_back(0);
    std::vector<std::uint32_t> triangles;
    std::vector<Vec3> places;
    std::vector<LinePoint> begins;
    for (std::size_t i = 0; i < seeds.size(); ++i) {
        const auto in = static_cast<std::uint32_t>(seeds[i].triangle);
        if (!web.rates(in))
            continue;
        triangles.push_back(in);
        places.push_back(web.parts(in, seeds[i].place));
        begins.push_back({web.place(in, places.back()), 0.0F, web.value(in, places.back())});
        lines.seed.push_back(static_cast<std::uint32_t>(i));
    }
    lines.outside = lines.seeds - static_cast<std::uint32_t>(begins.size());
    const std::size_t most = most_of_curve(request.most_points, begins.size(), request.direction);
    std::array<std::vector<ThinnedLine>, 2> ways{std::vector<ThinnedLine>(begins.size()),
                                                 std::vector<ThinnedLine>(begins.size())};
    for (const bool forth : {false, true}) {
        if (request.direction == (forth ? Direction::Backward : Direction::Forward))
            continue;
        tbb::parallel_for(std::size_t{0}, begins.size(), [&](std::size_t i) {
            ThinnedLine& line = ways[forth ? 1 : 0][i];
            if (!memory.exhausted() && !stop.stop_requested())
                Follower(web, request, forth ? 1.0 : -1.0, gap, most, memory, line)
                    .follow(triangles[i], places[i], stop);
        });
    }
    if (memory.exhausted())
        return tl::unexpected(memory.refusal());
    if (stop.stop_requested())
        return fail(Error::Code::Cancelled, "the lines were cancelled");
    gather_lines(ways[0], ways[1], begins, request.direction, request.most_points, lines);
    find_range(lines);
    memory.shrink(bytes);
    return lines;
}

} // namespace wakesurf::core
