#include "tests/bench/vtk/streaklines.hpp"

#include "tests/bench/support/interleaved.hpp"
#include "tests/bench/vtk/image_of.hpp"

#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreaklineFilter.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <cmath>

namespace wakesurf::bench {

namespace {

constexpr int time_steps = 65;
constexpr int seeds = 200;
constexpr int rk4_steps_per_interval = 2;

/// The series is played five times as fast as it was sampled: VTK's two steps an interval are then as long as the
/// engine's ten. Longer ones would cost VTK more cell searches: 0.9 instead of 1.6 million vertex-steps/s (ABC).
double interval_of(const SampledFlow& flow) {
    return flow.interval / 5.0;
}

/// The endless series as the start of a pipeline.
class SeriesSource final : public vtkImageAlgorithm {
  public:
    static SeriesSource* New();
    vtkTypeMacro(SeriesSource, vtkImageAlgorithm)

        const SampledFlow* flow = nullptr;

  protected:
    SeriesSource() { SetNumberOfInputPorts(0); }

    int RequestInformation(vtkInformation*,
                           vtkInformationVector**,
                           vtkInformationVector* outputs) override {
        vtkInformation* out = outputs->GetInformationObject(0);
        std::vector<double> times;
        for (int i = 0; i < time_steps; ++i)
            times.push_back(i * interval_of(*flow));
        const double range[2] = {times.front(), times.back()};
        constexpr int last = SampledFlow::nodes_per_side - 1;
        const int extent[6] = {0, last, 0, last, 0, last};
        out->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), time_steps);
        out->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
        out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
        return 1;
    }

    int
    RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override {
        vtkInformation* out = outputs->GetInformationObject(0);
        const double time = out->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
        const auto index = static_cast<std::size_t>(std::lround(time / interval_of(*flow)));
        vtkImageData* image = vtkImageData::GetData(out);
        show_as_image(flow->grid, flow->step(index), image);
        image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
        return 1;
    }
};

vtkStandardNewMacro(SeriesSource)

    struct Pipeline {
    explicit Pipeline(const SampledFlow& flow) {
        source->flow = &flow;
        const core::Box box = flow.grid.bounds();
        vtkNew<vtkPoints> points;
        points->SetDataTypeToDouble();
        for (int i = 0; i < seeds; ++i) {
            const core::Vec3 fraction(0.3 + 0.4 * i / (seeds - 1), 0.45, 0.3);
            const core::Vec3 p = box.lo + box.extent() * fraction;
            points->InsertNextPoint(p.x, p.y, p.z);
        }
        rake->SetPoints(points);
        filter->SetInputConnection(0, source->GetOutputPort());
        filter->SetInputData(1, rake);
        filter->SetIntegratorType(vtkParticleTracerBase::RUNGE_KUTTA4);
        filter->SetIgnorePipelineTime(false);
        filter->SetComputeVorticity(false);
        filter->SetForceReinjectionEveryNSteps(1);
        filter->SetStaticSeeds(1);
        filter->SetStaticMesh(1);
    }

    vtkNew<SeriesSource> source;
    vtkNew<vtkPolyData> rake;
    vtkNew<vtkStreaklineFilter> filter;
};

} // namespace

VtkStreaklines::VtkStreaklines(const SampledFlow& flow) : flow_(flow) {
    Pipeline pipeline(flow);
    for (int i = 0; i + 1 < time_steps; ++i) {
        pipeline.filter->UpdateTimeStep(i * interval_of(flow));
        const auto alive = pipeline.filter->GetOutput()->GetNumberOfPoints();
        vertex_steps_ += rk4_steps_per_interval * static_cast<double>(alive);
    }
}

double VtkStreaklines::run() const {
    Pipeline pipeline(flow_);
    return seconds_of(
        [&] { pipeline.filter->UpdateTimeStep((time_steps - 1) * interval_of(flow_)); });
}

} // namespace wakesurf::bench
