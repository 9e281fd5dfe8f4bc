#include "protocol/wire/wire_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace wakesurf::protocol {

namespace {

using Coded = std::span<const std::uint32_t>;

/// Stands for the change, where other channels have an index.
constexpr std::size_t change_channel = max_attributes + 1;

int predictor_of(const PointCoding& coding, std::size_t channel) {
    return channel == change_channel ? change_predictor : coding.predictor[channel];
}

std::uint16_t tolerance_of(const PointCoding& coding, std::size_t channel) {
    return channel == change_channel ? std::uint16_t{0} : coding.tolerance[channel];
}

/// Adds with wrap-around, because damaged bytes may hold any residual.
std::int32_t wrapped(std::int32_t prediction, std::int32_t residual, std::int32_t step) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(prediction) +
                                     static_cast<std::uint32_t>(residual) *
                                         static_cast<std::uint32_t>(step));
}

/// Rounds differences to whole steps of 2 tolerance + 1; no difference lies in the middle of two.
class Steps {
  public:
    explicit Steps(std::uint16_t tolerance) : step_(2 * tolerance + 1), per_unit_(1.0 / step_) {}

    std::int32_t step() const { return step_; }

    /// Has no branch: the sign of a residual is unpredictable.
    std::int32_t residual(std::int32_t difference) const {
        const double steps = difference * per_unit_;
        return static_cast<std::int32_t>(steps + std::copysign(0.5, steps));
    }

  private:
    std::int32_t step_;
    double per_unit_;
};

template <class Series>
void settle(const Series& x, bool moved, std::uint32_t v, std::size_t k, std::int32_t value) {
    if constexpr (requires { x.move(v, k, value); }) {
        if (moved) {
            x.move(v, k, value);
            return;
        }
    }
    x.add(v, k, value);
}

/// Predicts as the kind prescribes.
template <class Series, class Each>
void predict(const WireDraft& draft,
             const Series& x,
             PointKind kind,
             int predictor,
             Coded coded,
             Each each) {
    const auto& all = draft.after.topology->neighbours;
    if constexpr (!std::is_same_v<Series, ChangeSeries>)
        if (kind == PointKind::Moved)
            return predict_moved(x, predictor, all, coded, each);
    predict_added(x, predictor, all, draft.stay, coded, each);
}

template <class Series, class Truth>
void encode(const WireDraft& draft,
            const Series& x,
            const Truth& truth,
            const PointCoding& coding,
            std::size_t channel,
            Coded coded,
            std::span<std::int32_t> residuals) {
    const Steps steps(tolerance_of(coding, channel));
    const bool moved = coding.kind == PointKind::Moved;
    predict(draft, x, coding.kind, predictor_of(coding, channel), coded,
            [&](std::size_t i, std::uint32_t v, std::size_t k, std::int32_t prediction) {
                const std::int32_t residual = steps.residual(truth(v, k) - prediction);
                residuals[i * Series::components + k] = residual;
                settle(x, moved, v, k, x.clamped(prediction + residual * steps.step()));
            });
}

template <class Series>
void decode(const WireDraft& draft,
            const Series& x,
            const PointCoding& coding,
            std::size_t channel,
            Coded coded,
            std::span<const std::int32_t> residuals) {
    const Steps steps(tolerance_of(coding, channel));
    const bool moved = coding.kind == PointKind::Moved;
    predict(draft, x, coding.kind, predictor_of(coding, channel), coded,
            [&](std::size_t i, std::uint32_t v, std::size_t k, std::int32_t prediction) {
                const std::int32_t residual = residuals[i * Series::components + k];
                settle(x, moved, v, k, x.clamped(wrapped(prediction, residual, steps.step())));
            });
}

constexpr std::size_t trial_segments = 16;
constexpr std::size_t trial_length = 128;

/// Estimates the bits that an entropy coder needs, for some stretches of the vertices.
class BitEstimate {
  public:
    void count(std::int32_t residual) {
        constexpr std::int32_t edge = 31;
        const std::int32_t size = std::abs(residual);
        if (size > edge)
            far_ += 2.0 * std::log2(static_cast<double>(size) / edge) + 1.0;
        ++histogram_[static_cast<std::size_t>(std::clamp(residual, -edge, edge) + edge)];
        ++total_;
    }

    double bits() const {
        constexpr std::size_t zero = 31;
        double sum =
            far_ +
            (histogram_[zero] == total_ ? 0.0 : 1.0); // nothing is cheaper than something constant
        for (const std::uint32_t n : histogram_)
            if (n > 0)
                sum -= n * std::log2(static_cast<double>(n) / total_);
        return sum;
    }

  private:
    std::array<std::uint32_t, 63> histogram_{};
    std::uint32_t total_ = 0;
    double far_ = 0.0;
};

template <class Series, class Truth>
void set_truth(const Series& x, const Truth& truth, bool moved, Coded coded) {
    for (const std::uint32_t v : coded)
        for (std::size_t k = 0; k < Series::components; ++k)
            settle(x, moved, v, k, truth(v, k));
}

/// Tries all predictors on stretches of the vertices, the others having their true values.
template <class Series, class Truth>
std::uint8_t best_predictor(const WireDraft& draft,
                            const Series& x,
                            const Truth& truth,
                            PointCoding coding,
                            std::size_t channel,
                            Coded coded) {
    const bool moved = coding.kind == PointKind::Moved;
    const std::size_t length = std::min(coded.size(), trial_length);
    const std::size_t segments =
        std::clamp<std::size_t>(coded.size() / (2 * length), 1, trial_segments);
    set_truth(x, truth, moved, coded);
    std::vector<std::int32_t> residuals(length * Series::components);
    std::uint8_t best = 0;
    double fewest = std::numeric_limits<double>::infinity();
    const auto candidates = predictors_of_kind[static_cast<std::size_t>(coding.kind)];
    for (std::uint8_t candidate = 0; candidate < candidates && fewest > 0.0; ++candidate) {
        if (moved && Series::components == 1 && candidate == 2)
            continue; // attributes have no last change: this is 1
        coding.predictor[channel] = candidate;
        BitEstimate estimate;
        for (std::size_t s = 0; s < segments; ++s) {
            const std::size_t begin =
                segments == 1 ? 0 : s * (coded.size() - length) / (segments - 1);
            const Coded stretch = coded.subspan(begin, length);
            encode(draft, x, truth, coding, channel, stretch, residuals);
            for (const std::int32_t residual : residuals)
                estimate.count(residual);
            set_truth(x, truth, moved, stretch);
        }
        if (estimate.bits() < fewest) {
            fewest = estimate.bits();
            best = candidate;
        }
    }
    return best;
}

auto position_of(const WireMesh& truth) {
    return [positions = truth.position.data()](std::uint32_t v, std::size_t k) {
        return positions[v][k];
    };
}

auto code_of(const WireMesh& truth, std::size_t attribute) {
    return [codes = truth.codes[attribute].data()](std::uint32_t v, std::size_t) {
        return std::int32_t{codes[v]};
    };
}

auto change_of(const WireMesh& truth) {
    return
        [changes = truth.change.data()](std::uint32_t v, std::size_t k) { return changes[v][k]; };
}

/// Returns true if the vertices that stay keep all their codes: s and t of a moving surface do.
bool keeps_codes(const WireDraft& draft, const WireMesh& truth, std::size_t attribute) {
    const auto& before = draft.codes_before[attribute];
    return std::equal(before.begin(), before.end(), truth.codes[attribute].begin());
}

} // namespace

PointCoding choose_predictors(WireDraft& draft,
                              const WireMesh& truth,
                              PointCoding coding,
                              std::span<const std::uint32_t> coded) {
    coding.predictor.fill(0);
    if (coded.empty())
        return coding;
    coding.predictor[0] =
        best_predictor(draft, positions_of(draft), position_of(truth), coding, 0, coded);
    for (std::size_t a = 0; a < coding.attributes; ++a)
        if (coding.kind != PointKind::Moved || !keeps_codes(draft, truth, a))
            coding.predictor[a + 1] =
                best_predictor(draft, codes_of(draft, a), code_of(truth, a), coding, a + 1, coded);
    return coding;
}

Residuals make_residuals(WireDraft& draft,
                         const WireMesh& truth,
                         const PointCoding& coding,
                         std::span<const std::uint32_t> coded) {
    Residuals result{coding, static_cast<std::uint32_t>(coded.size()), {}, {}, {}};
    result.position.resize(3 * coded.size());
    encode(draft, positions_of(draft), position_of(truth), coding, 0, coded, result.position);
    for (std::size_t a = 0; a < coding.attributes; ++a) {
        auto& codes = result.codes.emplace_back(coded.size());
        if (coding.kind != PointKind::Moved || coding.predictor[a + 1] != 0 ||
            !keeps_codes(draft, truth, a))
            encode(draft, codes_of(draft, a), code_of(truth, a), coding, a + 1, coded, codes);
    }
    if (coding.kind == PointKind::Added) {
        result.change.resize(3 * coded.size());
        if (truth.change.empty())
            decode(draft, changes_of(draft), coding, change_channel, coded, result.change);
        else
            encode(draft, changes_of(draft), change_of(truth), coding, change_channel, coded,
                   result.change);
    }
    return result;
}

void apply_residuals(WireDraft& draft,
                     const Residuals& residuals,
                     std::span<const std::uint32_t> coded) {
    const PointCoding& coding = residuals.coding;
    decode(draft, positions_of(draft), coding, 0, coded, residuals.position);
    for (std::size_t a = 0; a < coding.attributes; ++a)
        decode(draft, codes_of(draft, a), coding, a + 1, coded, residuals.codes[a]);
    if (coding.kind == PointKind::Added)
        decode(draft, changes_of(draft), coding, change_channel, coded, residuals.change);
}

} // namespace wakesurf::protocol
