#include "core/surface/measures/measured_surface.hpp"

#include "core/surface/measures/closed_curve.hpp"
#include "core/surface/measures/cut_curve.hpp"
#include "core/surface/measures/part_bounds.hpp"
#include "core/surface/measures/residence.hpp"
#include "core/surface/measures/section_flux.hpp"
#include "core/surface/patches/tessellation.hpp"
#include "core/surface/time_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wakesurf::core {

namespace {

/// What measuring takes beside the meshes, in bytes a vertex: errors, and up to seven functions and an age at each of the
/// 5 vertices that halved cells have for one of whole ones; and at each of these and of the whole ones a field.
constexpr std::size_t vertex_bytes_measured = 450, vertex_bytes_of_field = 24;

/// Returns one age a vertex; none of a level surface.
std::vector<double> ages_of(const SurfacePlan& plan, const QuadComplex& mesh, double time) {
    const SurfaceParameters& p = plan.parameters;
    std::vector<double> ages;
    if (p.kind == SurfaceKind::Level)
        return ages;
    for (const double t : mesh.t)
        ages.push_back(p.kind == SurfaceKind::Streak ? std::abs(time - t)
                       : p.kind == SurfaceKind::Time ? std::abs(time - p.from)
                                                     : std::abs(t));
    return ages;
}

bool has_ages(const SurfacePlan& plan) {
    return plan.parameters.kind != SurfaceKind::Level;
}

bool grows_with_age(const SurfacePlan& plan) {
    return plan.parameters.kind == SurfaceKind::Stream || plan.parameters.kind == SurfaceKind::Path;
}

/// What the parts of a mesh come to.
struct Sums {
    double area = 0.0, flux = 0.0, approximated = 0.0;
    std::vector<WeightedValue> ages; ///< by area
};

Sums sums_of(const QuadComplex& mesh,
             const std::vector<double>& ages,
             std::span<const VertexFunction> bounds) {
    Sums out;
    visit_parts(mesh, bounds, [&](const SurfacePart& part) {
        const double area = glm::length(part.normal),
                     share = part.moment.x + part.moment.y + part.moment.z;
        out.area += area * share;
        for (int i = 0; i < 3; ++i)
            out.flux += part.moment[i] * glm::dot(part.normal, Vec3(mesh.velocity[part.vertex[i]]));
        out.approximated += area * glm::dot(part.moment, part.at_vertices(mesh.approximated));
        if (!ages.empty() && share > 0.0)
            out.ages.push_back(
                {glm::dot(part.moment, part.at_vertices(ages)) / share, area * share});
    });
    return out;
}

std::vector<double> known_errors(const std::vector<float>& errors, std::size_t count, double most) {
    std::vector<double> out(count, not_known);
    for (std::size_t v = 0; v < errors.size(); ++v)
        if (errors[v] <= most)
            out[v] = errors[v];
    return out;
}

} // namespace

Result<MeasuredSurface> MeasuredSurface::of(const SurfacePlan& plan,
                                            const Surface& state,
                                            std::vector<double> times,
                                            std::span<const AveragedField> fields,
                                            const std::stop_token& stop,
                                            const WorkPart& work) {
    const QuadComplex& mesh = state.mesh;
    const std::size_t bytes = vertex_bytes_measured + fields.size() * vertex_bytes_of_field;
    if (auto room = work.takes(memory_of(mesh) + mesh.vertices() * bytes); !room)
        return tl::unexpected(room.error());
    MeasuredSurface out;
    out.plan_ = plan;
    out.statistics_ = state.statistics;
    out.time_ = state.ended.value_or(plan.parameters.to);
    out.fields_.assign(fields.begin(), fields.end());
    const auto sampled = [&](Mesh& into) -> Result<void> {
        for (const AveragedField& field : fields) {
            auto values = field.values(into.mesh, times, stop);
            if (!values)
                return tl::unexpected(values.error());
            into.values.push_back(*std::move(values));
        }
        return {};
    };
    out.whole_ = {mesh, ages_of(plan, mesh, out.time_)};
    if (auto known = sampled(out.whole_); !known)
        return tl::unexpected(known.error());
    out.errors_ = known_errors(mesh.error, mesh.vertices(), state.statistics.separation);
    out.interval_errors_ =
        known_errors(mesh.interval_error, mesh.vertices(), std::numeric_limits<double>::infinity());
    auto spreader = ErrorSpreader::of(plan, mesh, times, stop);
    if (!spreader)
        return tl::unexpected(spreader.error());
    out.spreader_ = *std::move(spreader);
    if (plan.parameters.kind == SurfaceKind::Level || mesh.cells.empty())
        return out;
    auto halved = tessellate(plan, mesh, times, 2, stop, work);
    if (!halved)
        return tl::unexpected(halved.error());
    auto ages = ages_of(plan, halved->mesh, out.time_);
    out.halved_ = Mesh{std::move(halved->mesh), std::move(ages)};
    if (auto known = sampled(*out.halved_); !known)
        return tl::unexpected(known.error());
    return out;
}

/// The numbers of a state up to an age; in the order in which they are told.
class NumbersOfState {
  public:
    NumbersOfState(const MeasuredSurface& of, double age, const std::stop_token& stop)
        : of_(of), age_(age), stop_(stop), grows_(grows_with_age(of.plan_)) {}

    Result<SurfaceNumbers> told(const std::optional<Region>& through) {
        const SurfaceParameters& p = of_.plan_.parameters;
        add("time", 0, 1, p.kind == SurfaceKind::Stream ? p.from : shown_time());
        if (p.kind == SurfaceKind::Stream)
            add("age", 0, 1, age_);
        tell_whole();
        if (through) {
            if (auto cut = tell_cut(*through); !cut)
                return tl::unexpected(cut.error());
        } else if (grows_) {
            tell_residence(std::nullopt, {});
        }
        if (grows_ && of_.plan_.seeding.closed())
            if (auto tube = tell_tube(); !tube)
                return tl::unexpected(tube.error());
        return std::move(out_);
    }

  private:
    double shown_time() const {
        const SurfaceParameters& p = of_.plan_.parameters;
        return p.kind == SurfaceKind::Path ? p.from + time_sign(p) * age_ : of_.time_;
    }

    void add(std::string name, int length, int time, double value) {
        out_.numbers.push_back({std::move(name), length, time, value});
    }

    void add(const std::string& name, int length, int time, const Measured& measured) {
        add(name, length, time, measured.value);
        add(name + "_error", length, time, measured.error);
        add(name + "_interval_error", length, time, measured.interval_error);
    }

    void note(std::string sentence) { out_.notes.push_back(std::move(sentence)); }

    std::vector<VertexFunction>
    bounds_of(const MeasuredSurface::Mesh& mesh,
              const std::optional<Region>& region = std::nullopt) const {
        auto bounds = grows_ ? age_bound(mesh.ages, age_) : std::vector<VertexFunction>{};
        if (region)
            add_bounds(bounds, mesh.mesh, *region);
        return bounds;
    }

    /// Area and flux of what is inside bounds.
    struct Extent {
        Measured area, flux;
        double approximated, uncertain, unresolved;
        std::vector<WeightedValue> ages;
    };

    Extent extent(const std::optional<Region>& region) const {
        const auto bounds = bounds_of(of_.whole_, region);
        Sums whole = sums_of(of_.whole_.mesh, of_.whole_.ages, bounds);
        const auto by_error = of_.spreader_->spread(of_.whole_.mesh, bounds, of_.errors_);
        const auto by_interval =
            of_.spreader_->spread(of_.whole_.mesh, bounds, of_.interval_errors_);
        Extent out{{whole.area}, {whole.flux}, not_known, not_known, not_known, {}};
        const double area = whole.area;
        if (of_.halved_) {
            Sums halved =
                sums_of(of_.halved_->mesh, of_.halved_->ages, bounds_of(*of_.halved_, region));
            out.area = extrapolated(whole.area, halved.area);
            out.flux = extrapolated(whole.flux, halved.flux);
            out.ages = std::move(halved.ages);
        }
        const auto add_up = [&](double& error, double change, double left_out) {
            error =
                left_out <= 0.5 * area ? std::isfinite(error) ? error + change : change : not_known;
        };
        // Without pieces that are halved nobody knows how far flat ones are from the surface.
        if (of_.halved_ || area == 0.0) {
            add_up(out.area.error, by_error.area, by_error.left_out);
            add_up(out.flux.error, by_error.flux, by_error.left_out);
        }
        add_up(out.area.interval_error, by_interval.area, by_interval.left_out);
        add_up(out.flux.interval_error, by_interval.flux, by_interval.left_out);
        if (of_.whole_.mesh.interval_error.empty())
            out.area.interval_error = out.flux.interval_error = not_known;
        if (area > 0.0) {
            out.approximated = whole.approximated / area;
            if (!of_.whole_.mesh.error.empty())
                out.uncertain = by_error.left_out / area;
            if (!of_.whole_.mesh.interval_error.empty())
                out.unresolved = by_interval.left_out / area;
        }
        return out;
    }

    void tell_whole() {
        const Extent all = extent(std::nullopt);
        flux_ = all.flux;
        add("area", 2, 0, all.area);
        add("flux", 3, -1, all.flux);
        add("approximated", 0, 0, all.approximated);
        add("uncertain", 0, 0, all.uncertain);
        add("unresolved", 0, 0, all.unresolved);
        tell_means("", std::nullopt);
        const SurfaceStatistics& statistics = of_.statistics_;
        if (!(all.area.value > 0.0))
            note("the surface has no area then");
        if (of_.plan_.parameters.kind == SurfaceKind::Level)
            note("no error is known of a level surface");
        if (of_.whole_.mesh.interval_error.empty() && !statistics.interval_left_out.empty())
            note("no error between stored times: " + statistics.interval_left_out);
        if (statistics.torn.value_or(0) > 0)
            note("the surface is torn: " + std::to_string(*statistics.torn) +
                 " cells were deleted among living particles, and are not counted");
        if (!statistics.stopped.empty())
            note("the surface ends early: " + statistics.stopped);
    }

    /// No error is told: how much a field changes along a vertex's own is not known.
    void tell_means(const std::string& where, const std::optional<Region>& region) {
        for (std::size_t k = 0; k < of_.fields_.size(); ++k) {
            const AveragedField& field = of_.fields_[k];
            const auto over = [&](const MeasuredSurface::Mesh& on) {
                return integral_over(on.mesh, bounds_of(on, region), on.values[k]);
            };
            FieldIntegral found = over(of_.halved_ ? *of_.halved_ : of_.whole_);
            // An error is known at the vertices that the builder made alone.
            if (!(found.area > 0.0) && of_.halved_)
                found = over(of_.whole_);
            out_.numbers.push_back({where + "mean_" + field.name, 0, 0, found.mean(), field.unit});
            if (const double area = found.area + found.unknown; found.unknown > 0.005 * area)
                note(field.name + " is known on " +
                     std::to_string(std::lround(100.0 * found.area / area)) + " % of the area" +
                     (where.empty() ? "" : " inside"));
        }
    }

    Result<void> tell_cut(const Region& region) {
        const auto cut = [&](const MeasuredSurface::Mesh& mesh) {
            auto bounds = bounds_of(mesh);
            const std::size_t others = bounds.size();
            add_bounds(bounds, mesh.mesh, region);
            // Errors are those of the vertices that the builder made.
            const bool whole = &mesh == &of_.whole_;
            const std::array<std::span<const double>, 2> errors{of_.errors_, of_.interval_errors_};
            return cut_curve(mesh.mesh, bounds, others, mesh.ages,
                             whole ? std::span(errors) : std::span(errors).first(0));
        };
        const CutCurve whole = cut(of_.whole_);
        CutCurve ages = whole;
        Measured length{whole.length};
        if (of_.halved_) {
            ages = cut(*of_.halved_);
            length = extrapolated(whole.length, ages.length);
        }
        add("cut_length", 1, 0, length.value);
        const bool plane = std::holds_alternative<Plane>(region);
        if (has_ages(of_.plan_)) {
            // Pieces of half the size have other ages at the same share: that is what pieces miss.
            const double pieces =
                std::max({std::abs(ages.least - whole.least), std::abs(ages.median - whole.median),
                          std::abs(ages.p90 - whole.p90)});
            add("age_least", 0, 1, ages.least);
            add("age_median", 0, 1, ages.median);
            add("age_p90", 0, 1, ages.p90);
            add("age_error", 0, 1, pieces + whole.error99[0]);
            add("age_interval_error", 0, 1, whole.error99[1]);
        }
        if (!(whole.length > 0.0))
            note(plane ? "the surface does not meet the plane"
                       : "the surface does not meet the box");
        if (plane)
            return tell_section(std::get<Plane>(region));
        tell_inside(region, whole.error99);
        return {};
    }

    void tell_inside(const Region& region, const std::vector<double>& error99) {
        Extent inside = extent(region);
        add("inside_area", 2, 0, inside.area);
        tell_means("inside_", region);
        if (has_ages(of_.plan_)) {
            add("inside_age_median", 0, 1, weighted_quantile(inside.ages, 0.5));
            add("inside_age_p90", 0, 1, weighted_quantile(inside.ages, 0.9));
        }
        if (grows_)
            tell_residence(std::get<Box>(region), error99);
    }

    /// Both the time at which a particle comes in and that at which it leaves are off by what the cut's ages are.
    void tell_residence(const std::optional<Box>& box, const std::vector<double>& error99) {
        const auto stay = [&](const MeasuredSurface::Mesh& mesh) {
            return residence(mesh.mesh, bounds_of(mesh), mesh.ages, age_, box,
                             of_.plan_.seeding.closed());
        };
        const Residence whole = stay(of_.whole_);
        const Residence found = of_.halved_ ? stay(*of_.halved_) : whole;
        add("residence_median", 0, 1, found.median);
        add("residence_p90", 0, 1, found.p90);
        add("residence_mean", 0, 1, found.mean);
        if (box) {
            const double pieces =
                std::max({std::abs(found.median - whole.median), std::abs(found.p90 - whole.p90),
                          std::abs(found.mean - whole.mean)});
            add("residence_error", 0, 1, pieces + 2.0 * error99[0]);
            add("residence_interval_error", 0, 1, 2.0 * error99[1]);
        }
        add("entered", 0, 0, found.entered);
        add("still_inside", 0, 0, found.inside);
        if (direction_of(of_.plan_.parameters) == Direction::Both && found.entered > 0.0)
            note("times of stay add up both directions");
    }

    /// The flux through the one closed curve along which a function is 0, positive along the normal about which s grows counter-clockwise.
    struct Section {
        Measured flux;
        Vec3 area{0.0};
        std::optional<NoCurve> refused{};
    };

    template <class Function>
    Result<Section> section(const Function& function, double time) const {
        Section out;
        const std::array<std::span<const double>, 2> errors{of_.errors_, of_.interval_errors_};
        constexpr double endless = std::numeric_limits<double>::infinity();
        std::array<SectionFlux, 2> found; // of whole pieces, and of halved ones
        for (std::size_t k = 0; k < 2; ++k) {
            const MeasuredSurface::Mesh& mesh = k == 1 ? *of_.halved_ : of_.whole_;
            auto curve = closed_curve(mesh.mesh, function(mesh), mesh.ages, grows_ ? age_ : endless,
                                      k == 0 ? std::span(errors) : std::span(errors).first(0));
            if (!curve) {
                out.refused = curve.error();
                return out;
            }
            auto flux = section_flux(of_.plan_, curve->points, curve->errors, time,
                                     of_.statistics_.separation, stop_);
            if (!flux && flux.error().code == Error::Code::OutOfDomain) {
                out.refused = NoCurve{NoCurve::Why::LeavesData};
                return out;
            }
            if (!flux)
                return tl::unexpected(flux.error());
            found[k] = *std::move(flux);
            found[k].value *= curve->sense;
            found[k].area *= curve->sense;
        }
        out.area = found[1].area;
        out.flux = extrapolated(found[0].value, found[1].value);
        out.flux.pieces += found[1].quadrature;
        out.flux.error = out.flux.pieces + found[0].errors[0];
        out.flux.interval_error = found[0].errors[1];
        return out;
    }

    Result<void> tell_section(const Plane& plane) {
        Section found;
        std::string why;
        if (!of_.plan_.seeding.closed()) {
            why = "the surface is no closed tube, since the rake is not a whole circle";
        } else if (of_.halved_) {
            const auto height = [&](const MeasuredSurface::Mesh& mesh) {
                VertexFunction out;
                for (const Vec3& p : mesh.mesh.position)
                    out.push_back(plane.height(p));
                return out;
            };
            auto made = section(height, frozen_or_shown());
            if (!made)
                return tl::unexpected(made.error());
            found = *std::move(made);
            if (glm::dot(found.area, plane.normal) < 0.0)
                found.flux.value = -found.flux.value;
            if (found.refused)
                why = found.refused->of_plane();
        }
        add("section_flux", 3, -1, found.flux);
        if (!why.empty())
            note("no flux through the plane: " + why);
        else if (of_.plan_.parameters.kind == SurfaceKind::Path)
            note("the particles come to the plane at different times; section_flux is that at the "
                 "time of the row");
        return {};
    }

    /// The flux through the ring of particles of one age, what it was at the rake, and why it has changed.
    Result<void> tell_tube() {
        const SurfaceParameters& p = of_.plan_.parameters;
        Section found;
        Measured start;
        std::string why;
        if (direction_of(p) == Direction::Both) {
            why = "the surface goes both ways";
        } else if (of_.halved_) {
            // At its very end there is nothing older that would tell where the ring is.
            const double age = std::min(age_, time_span(p) * (1.0 - 1e-9));
            const auto made = section(
                [&](const MeasuredSurface::Mesh& mesh) {
                    return age_bound(mesh.ages, age).front();
                },
                frozen_or_shown());
            if (!made)
                return tl::unexpected(made.error());
            found = *made;
            if (found.refused)
                why = found.refused->of_ring();
            auto begun = at_rake();
            if (!begun)
                return tl::unexpected(begun.error());
            start = *begun;
        }
        const double sign = start.value < 0.0 ? -1.0 : 1.0;
        for (Measured* flux : {&found.flux, &start})
            flux->value *= sign;
        add("tube_flux", 3, -1, found.flux);
        add("tube_flux_at_rake", 3, -1, start.value);
        if (p.kind == SurfaceKind::Stream) {
            const Measured& wall = flux_;
            const bool known = found.flux.known() && start.known();
            add("tube_flux_lost_by_tracing", 3, -1, known ? sign * wall.value : not_known);
            add("tube_flux_lost_by_tracing_error", 3, -1, known ? wall.pieces : not_known);
            add("tube_flux_gained_by_divergence", 3, -1,
                found.flux.value - start.value + sign * wall.value);
            add("tube_flux_gained_by_divergence_error", 3, -1,
                found.flux.pieces + start.pieces + wall.pieces);
        }
        if (!why.empty())
            note("no flux through the tube: " + why);
        return {};
    }

    /// Returns the flux through the rake, which is not known where the data do not fill it.
    Result<Measured> at_rake() const {
        std::array<SectionFlux, 2> found;
        for (std::size_t k = 0; k < 2; ++k) {
            std::vector<Vec3> ring(256 * (k + 1));
            for (std::size_t i = 0; i < ring.size(); ++i)
                ring[i] =
                    of_.plan_.seeding.at(static_cast<double>(i) / static_cast<double>(ring.size()));
            const auto flux = section_flux(of_.plan_, ring, {}, of_.plan_.parameters.from,
                                           of_.statistics_.separation, stop_);
            if (!flux && flux.error().code == Error::Code::OutOfDomain)
                return Measured{};
            if (!flux)
                return tl::unexpected(flux.error());
            found[k] = *flux;
        }
        return extrapolated(found[0].value, found[1].value);
    }

    double frozen_or_shown() const {
        const SurfaceParameters& p = of_.plan_.parameters;
        return p.kind == SurfaceKind::Stream ? p.from : shown_time();
    }

    const MeasuredSurface& of_;
    double age_;
    const std::stop_token& stop_;
    bool grows_;
    Measured flux_; ///< through the surface
    SurfaceNumbers out_;
};

Result<SurfaceNumbers> MeasuredSurface::numbers(double age,
                                                const std::optional<Region>& through,
                                                const std::stop_token& stop) const {
    return NumbersOfState(*this, age, stop).told(through);
}

} // namespace wakesurf::core
