#include "importer/filter/vtkIntegralSurface.h"

#include "core/field/stored_flow.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "core/surface/playback/surface_at.hpp"
#include "importer/filter/pipeline_source.hpp"
#include "importer/filter/polygonal_data.hpp"

#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace ws = wakesurf::core;
using wakesurf::importer::PipelineStep;
using Pipeline = vtkStreamingDemandDrivenPipeline;

struct vtkIntegralSurface::Internals {
    std::vector<double> times; ///< of the data; {0} where they have none
    bool timed = false;

    // The times asked for, and the flow made of them.
    std::vector<double> wanted;
    std::vector<PipelineStep> steps;
    vtkMTimeType made = 0; ///< time stamp of the last of them
    std::string velocity;
    std::shared_ptr<const ws::Flow> flow;

    double from = 0.0, to = 0.0;

    /// Returns the times of the steps around what the surface needs.
    std::vector<double> window(bool frozen) const {
        const auto [first, last] = std::minmax(from, frozen ? from : to);
        auto lo = std::upper_bound(times.begin(), times.end(), first);
        auto hi = std::lower_bound(times.begin(), times.end(), last);
        lo = lo == times.begin() ? lo : lo - 1;
        hi = hi == times.end() ? hi : hi + 1;
        return {lo, std::max(lo, hi)};
    }
};

vtkStandardNewMacro(vtkIntegralSurface);

vtkIntegralSurface::vtkIntegralSurface() : Internal(std::make_unique<Internals>()) {
    SetNumberOfInputPorts(2);
}

vtkIntegralSurface::~vtkIntegralSurface() = default;

void vtkIntegralSurface::PrintSelf(ostream& os, vtkIndent indent) {
    Superclass::PrintSelf(os, indent);
    os << indent << "Kind: " << Kind << "\n"
       << indent << "Accuracy: " << Accuracy << "\n"
       << indent << "Point1: " << Point1[0] << ", " << Point1[1] << ", " << Point1[2] << "\n"
       << indent << "Point2: " << Point2[0] << ", " << Point2[1] << ", " << Point2[2] << "\n"
       << indent << "Seeds: " << Seeds << "\n"
       << indent << "From: " << From << "\n"
       << indent << "To: " << To << "\n"
       << indent << "Separation: " << Separation << "\n"
       << indent << "Sweep: " << Sweep[0] << ", " << Sweep[1] << ", " << Sweep[2] << "\n"
       << indent << "Velocity: " << Velocity << "\n";
}

int vtkIntegralSurface::FillInputPortInformation(int port, vtkInformation* info) {
    if (port == 1) {
        info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
        info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
        return 1;
    }
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
    return 1;
}

int vtkIntegralSurface::RequestInformation(vtkInformation*,
                                           vtkInformationVector** inputs,
                                           vtkInformationVector* outputs) {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    Internals& now = *Internal;
    now.timed = in->Has(Pipeline::TIME_STEPS()) != 0;
    const int count = now.timed ? in->Length(Pipeline::TIME_STEPS()) : 0;
    const double* times = count > 0 ? in->Get(Pipeline::TIME_STEPS()) : nullptr;
    now.times.assign(times, times + count);
    if (now.times.empty()) {
        now.timed = false;
        now.times = {0.0};
    }
    const bool all = From == To;
    now.from = all ? now.times.front() : From;
    now.to = all ? now.times.back() : To;
    out->Remove(Pipeline::TIME_STEPS());
    out->Remove(Pipeline::TIME_RANGE());
    if (now.timed && Kind != STREAM) {
        out->Set(Pipeline::TIME_STEPS(), now.times.data(), count);
        double range[2] = {std::min(now.from, now.to), std::max(now.from, now.to)};
        out->Set(Pipeline::TIME_RANGE(), range, 2);
    }
    return 1;
}

int vtkIntegralSurface::RequestUpdateExtent(vtkInformation*,
                                            vtkInformationVector** inputs,
                                            vtkInformationVector*) {
    Internals& now = *Internal;
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    auto wanted = now.window(Kind == STREAM);
    if (wanted != now.wanted || Velocity != now.velocity) {
        now.wanted = std::move(wanted);
        now.steps.clear();
        now.flow.reset();
    }
    // Time-steps already held are requested again: upstream has them at hand, and the request shows whether
    // they have changed.
    const std::size_t next = now.flow ? now.wanted.size() - 1 : now.steps.size();
    if (now.timed)
        in->Set(Pipeline::UPDATE_TIME_STEP(), now.wanted[next]);
    // One piece without ghosts: the whole of it.
    in->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    in->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    in->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    return 1;
}

int vtkIntegralSurface::RequestData(vtkInformation* request,
                                    vtkInformationVector** inputs,
                                    vtkInformationVector* outputs) {
    Internals& now = *Internal;
    vtkPolyData* output = vtkPolyData::GetData(outputs);
    const auto failed = [&](const ws::Error& error) {
        request->Remove(Pipeline::CONTINUE_EXECUTING());
        now.steps.clear();
        vtkErrorMacro(<< error.message << (error.hint.empty() ? "" : "; ") << error.hint);
        output->Initialize();
        return 0;
    };
    vtkDataObject* data = vtkDataObject::GetData(inputs[0]);
    const vtkMTimeType changed = std::max(data->GetMTime(), data->GetUpdateTime());
    if (now.flow && now.made != changed) { // everything again
        now.flow.reset();
        now.steps.clear();
        request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
        return 1;
    }
    if (!now.flow) {
        auto copy = vtkSmartPointer<vtkDataObject>::Take(data->NewInstance());
        copy->ShallowCopy(data);
        now.steps.push_back({now.wanted[now.steps.size()], copy});
        if (now.steps.size() < now.wanted.size()) {
            request->Set(Pipeline::CONTINUE_EXECUTING(), 1);
            return 1;
        }
        request->Remove(Pipeline::CONTINUE_EXECUTING());
        auto steps = wakesurf::importer::steps_of(std::exchange(now.steps, {}), Velocity);
        if (!steps)
            return failed(steps.error());
        now.flow = ws::make_stored_flow(
            std::make_shared<ws::TimeStepCache>(*steps, ws::TimeStepCache::Options{}));
        now.made = changed;
        now.velocity = Velocity;
    }
    request->Remove(Pipeline::CONTINUE_EXECUTING());

    ws::Rake rake{ws::Rake::Kind::Line,
                  {{Point1[0], Point1[1], Point1[2]}, {Point2[0], Point2[1], Point2[2]}},
                  static_cast<std::uint32_t>(Seeds)};
    if (auto* given = vtkPolyData::GetData(inputs[1])) {
        rake.points = wakesurf::importer::rake_points(*given);
        rake.kind = rake.points.size() == 2 ? ws::Rake::Kind::Line : ws::Rake::Kind::Polyline;
    }
    ws::SurfaceParameters asked;
    asked.kind = static_cast<ws::SurfaceKind>(Kind);
    asked.accuracy = static_cast<ws::Accuracy>(Accuracy);
    asked.from = now.from;
    asked.to = now.to;
    asked.separation = Separation;
    if (Kind == TIME)
        asked.sweep = ws::Vec3(Sweep[0], Sweep[1], Sweep[2]);
    const auto plan = ws::plan_surface(now.flow, rake, asked);
    if (!plan)
        return failed(plan.error());
    vtkInformation* out = outputs->GetInformationObject(0);
    std::optional<double> time;
    if (Kind != STREAM && now.timed && out->Has(Pipeline::UPDATE_TIME_STEP()) != 0)
        time = std::clamp(out->Get(Pipeline::UPDATE_TIME_STEP()), std::min(now.from, now.to),
                          std::max(now.from, now.to));
    const auto surface = ws::surface_at(*plan, time, ws::SteadyClock{}, {});
    if (!surface)
        return failed(surface.error());
    wakesurf::importer::fill(*output, surface->mesh);
    if (time)
        output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), *time);
    return 1;
}
