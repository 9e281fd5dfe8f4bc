// How fast an import is beside the least it could do: VTK's reader, in this process, reading the same files and nothing
// else. Files lie in the page cache for both; the import also writes them. The reader has one core, as its users have; the
// import takes what it takes by default: a process a core. Short series are mostly the import's start and the mesh, which is
// converted once; long ones the time-steps. Time-steps of a long one are few files under many names.
#include "server/service/catalogue/import_process.hpp"
#include "tests/bench/benchmarks.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>
#include <vtkCellType.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

namespace wakesurf::bench {

namespace import_bench {

namespace fs = std::filesystem;

struct Size {
    int nodes; ///< along each axis
    int steps;
    int turns;
};

constexpr Size brief{96, 8, 5};
constexpr Size long_image{160, 24, 3};
constexpr Size long_mesh{96, 24, 3};
constexpr int different = 8;   ///< files written; time-steps beyond them are further links
constexpr double target = 0.5; // of the reader's speed

vtkSmartPointer<vtkDataSet> image(int nodes) {
    auto data = vtkSmartPointer<vtkImageData>::New();
    data->SetDimensions(nodes, nodes, nodes);
    data->SetSpacing(0.1, 0.1, 0.1);
    return data;
}

vtkSmartPointer<vtkDataSet> hexahedra(int nodes) {
    auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (int k = 0; k < nodes; ++k)
        for (int j = 0; j < nodes; ++j)
            for (int i = 0; i < nodes; ++i)
                points->InsertNextPoint(0.1 * i, 0.1 * j, 0.1 * k + 0.01 * i);
    data->SetPoints(points);
    for (vtkIdType k = 0; k + 1 < nodes; ++k)
        for (vtkIdType j = 0; j + 1 < nodes; ++j)
            for (vtkIdType i = 0; i + 1 < nodes; ++i) {
                const vtkIdType at = i + nodes * (j + nodes * k);
                const vtkIdType up = at + nodes * nodes;
                const vtkIdType cell[8] = {at, at + 1, at + nodes + 1, at + nodes,
                                           up, up + 1, up + nodes + 1, up + nodes};
                data->InsertNextCell(VTK_HEXAHEDRON, 8, cell);
            }
    return data;
}

void put_velocity(vtkDataSet& data, int step) {
    auto u = vtkSmartPointer<vtkFloatArray>::New();
    u->SetName("U");
    u->SetNumberOfComponents(3);
    u->SetNumberOfTuples(data.GetNumberOfPoints());
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        double p[3];
        data.GetPoint(i, p);
        u->SetTuple3(i, std::sin(p[2]) + std::cos(p[1]) + step, std::sin(p[0]) + std::cos(p[2]),
                     std::sin(p[1]) + std::cos(p[0]));
    }
    data.GetPointData()->AddArray(u);
}

struct Series {
    fs::path folder;
    std::vector<std::string> files;

    ~Series() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
};

template <class Writer>
void write_series(vtkDataSet& data,
                  const std::string& extension,
                  const Size& size,
                  Series& series) {
    series.folder =
        fs::temp_directory_path() / fmt::format("wakesurf-bench-{}-{}", ::getpid(), extension);
    fs::create_directories(series.folder);
    for (int i = 0; i < size.steps; ++i) {
        series.files.push_back((series.folder / fmt::format("flow_{}.{}", i, extension)).string());
        if (i >= different) {
            fs::create_hard_link(series.files[static_cast<std::size_t>(i % different)],
                                 series.files.back());
            continue;
        }
        put_velocity(data, i);
        auto writer = vtkSmartPointer<Writer>::New();
        writer->SetFileName(series.files.back().c_str());
        writer->SetInputData(&data);
        writer->SetCompressorTypeToNone();
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
        if (writer->Write() == 0)
            throw std::runtime_error("cannot write the series to import");
    }
    ::sync(); // else the first import, which waits for its own files to reach the disk, waits for these
}

template <class Action>
double seconds(const Action& action) {
    const auto start = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(),
                     values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

template <class Reader>
void read_all(const Series& series) {
    for (const auto& file : series.files) {
        auto reader = vtkSmartPointer<Reader>::New();
        reader->SetFileName(file.c_str());
        reader->Update();
        benchmark::DoNotOptimize(reader->GetOutputDataObject(0));
    }
}

template <class Reader, class Writer>
void measure(benchmark::State& state,
             vtkDataSet& data,
             const std::string& extension,
             const Size& size) {
    Series series;
    write_series<Writer>(data, extension, size, series);
    std::vector<double> reading;
    std::vector<double> importing;
    for (auto _ : state)
        for (int turn = 0; turn < size.turns; ++turn) {
            reading.push_back(seconds([&] { read_all<Reader>(series); }));
            const fs::path store = series.folder / "store";
            importing.push_back(seconds([&] {
                const auto done = server::run_import_process({series.files.front(), store, {}, {}},
                                                             [](const store::ImportProgress&) {});
                if (!done)
                    throw std::runtime_error(done.error().message);
            }));
            fs::remove_all(store);
        }
    state.counters["vtk_reader_ms"] = 1e3 * median(reading);
    state.counters["import_ms"] = 1e3 * median(importing);
    state.counters["speed_of_reader"] = median(reading) / median(importing);
    state.counters["target"] = target;
    state.counters["steps"] = size.steps;
    state.counters["import_cores"] = std::thread::hardware_concurrency();
}

} // namespace import_bench

void register_import_benchmarks() {
    using namespace import_bench;
    const auto add = [](const std::string& name, auto measured) {
        benchmark::RegisterBenchmark(name.c_str(), measured)
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    };
    for (const bool long_series : {false, true}) {
        const std::string end = long_series ? "/long" : "";
        add("import/image" + end, [long_series](benchmark::State& state) {
            const Size& size = long_series ? long_image : brief;
            measure<vtkXMLImageDataReader, vtkXMLImageDataWriter>(state, *image(size.nodes), "vti",
                                                                  size);
        });
        add("import/hexahedra" + end, [long_series](benchmark::State& state) {
            const Size& size = long_series ? long_mesh : brief;
            measure<vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter>(
                state, *hexahedra(size.nodes), "vtu", size);
        });
    }
}

} // namespace wakesurf::bench
