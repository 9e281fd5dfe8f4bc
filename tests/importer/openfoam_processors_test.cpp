// Decomposed OpenFOAM cases whose processors, or the whole case beside them, have different times.
#include "tests/importer/cavity_case.hpp"

namespace wakesurf::importer::openfoam_processors_test {
namespace {

using namespace tests;
using namespace tests::cavity;
using core::Error;
namespace fs = std::filesystem;

using Processors = CavityCase;

TEST_F(Processors, AreTakenWhereTheyHaveMoreTimesThanTheWholeCase) {
    const auto mesh = foam_block_mesh({});
    put(mesh);
    fs::remove_all(at("0.5"));
    for (const auto& part : decompose(mesh))
        put(part, false, "processor" + std::to_string(part.part));
    const auto decomposed = open();
    EXPECT_EQ(decomposed->description().times.size(), 3u);
    EXPECT_NE(decomposed->description().note.find("processor folders, which have 3 times"),
              std::string::npos)
        << decomposed->description().note;
    fs::remove_all(at("processor0/10"));
    for (const char* const gone :
         {"processor0/0.5", "processor1/0.5", "processor0/1e1", "processor1/1e1"})
        fs::remove_all(at(gone));
    const auto whole = open();
    EXPECT_EQ(whole->description().times, (std::vector<double>{0.0, 10.0}));
    EXPECT_NE(whole->description().note.find("reconstructed"), std::string::npos);
}

TEST_F(Processors, LeaveOutTimesThatNotAllOfThemHave) {
    const auto mesh = foam_block_mesh({});
    const auto put_parts = [&] {
        for (const auto& part : decompose(mesh))
            put(part, false, "processor" + std::to_string(part.part));
    };
    using Times = std::vector<double>;

    const struct {
        const char* gone;
        Times times;
        const char* note;
    } cases[]{{"processor1/1e1/U",
               {0.0, 0.5},
               "time 1e1 is left out: processor1 has no U at 1e1, other processors have"},
              {"processor0/1e1",
               {0.0, 0.5},
               "time 1e1 is left out: processor0 has no U at 1e1, other processors have"},
              {"processor1/0.5",
               {0.0, 10.0},
               "time 0.5 is left out: processor1 has no U at 0.5, other processors have"},
              {"processor1/1e1/p",
               {0.0, 0.5},
               "time 1e1 is left out: processor1 has no p there, other processors have"},
              {"processor0/1e1/p",
               {0.0, 0.5},
               "time 1e1 is left out: processor0 has no p there, other processors have"},
              {"processor1/0.5/p", {0.0, 0.5, 10.0}, "not at every time-step: p"}};

    for (const auto& one : cases) {
        SCOPED_TRACE(one.gone);
        put_parts();
        fs::remove_all(at(one.gone));
        const auto source = open();
        EXPECT_EQ(source->description().times, one.times);
        EXPECT_EQ(source->description().note, one.note);
        const std::size_t last = one.times.size() - 1;
        const auto step = source->read(last, source->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        if (source->description().fields.size() == 2)
            expect_values(*step, one.times.back() == 10.0 ? 2 : 1, mesh.cells.size());
    }
}

FoamMesh empty_mesh(FoamMesh part) {
    part.points.clear();
    part.faces.clear();
    part.cells.clear();
    std::erase_if(part.patches, [](const auto& patch) { return patch.type == "processor"; });
    for (auto& patch : part.patches)
        patch.size = patch.start = 0;
    return part;
}

TEST_F(Processors, WithoutCellsOfARegionHaveThoseOfTheOthers) {
    const auto mesh = foam_block_mesh({});
    const auto parts = decompose(mesh);
    for (int i = 0; i < 2; ++i) {
        const auto place = at("processor" + std::to_string(i));
        const auto metal = i == 0 ? parts[0] : empty_mesh(parts[0]);
        write_foam_mesh(place / "constant" / "air", parts[static_cast<std::size_t>(i)]);
        write_foam_mesh(place / "constant" / "metal", metal);
        for (int step = 0; step < 3; ++step) {
            const auto time = place / time_names[static_cast<std::size_t>(step)];
            for (const auto& field : {velocity(parts[static_cast<std::size_t>(i)], step),
                                      pressure(parts[static_cast<std::size_t>(i)], step)})
                write_foam_field(time / "air", parts[static_cast<std::size_t>(i)], field);
            write_foam_field(time / "metal", metal, pressure(metal, step));
        }
    }
    write_file(at("cavity.foam"), "");
    const auto source = open();
    for (const std::size_t i : {0u, 2u, 1u}) {
        const auto step = source->read(i, source->description().fields);
        ASSERT_TRUE(step.has_value()) << step.error().message;
        expect_values(*step, static_cast<int>(i), mesh.cells.size());
        EXPECT_FALSE(step->solids.empty());
    }
}

// As decomposePar leaves them where the method fills fewer processors than there are.
TEST_F(Processors, WithoutCellsAreReadAsNothing) {
    const auto mesh = foam_block_mesh({});
    for (const bool binary : {false, true}) {
        const auto parts = decompose(mesh);
        put(empty_mesh(parts[0]), binary, "processor0");
        put(parts[0], binary, "processor1");
        put(empty_mesh(parts[0]), binary, "processor2");
        put(parts[1], binary, "processor3");
        const auto source = open();
        EXPECT_EQ(source->description().times.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            const auto step = source->read(i, source->description().fields);
            ASSERT_TRUE(step.has_value()) << step.error().message;
            expect_values(*step, static_cast<int>(i), mesh.cells.size());
        }
    }
    for (int part = 0; part < 4; ++part)
        put(empty_mesh(decompose(mesh)[0]), false, "processor" + std::to_string(part));
    EXPECT_EQ(open_openfoam(at("")).error().message, "the mesh of cavity has no cells");
}

TEST_F(Processors, AreRefusedWithoutATimeInCommon) {
    for (const auto& part : decompose(foam_block_mesh({})))
        put(part, false, "processor" + std::to_string(part.part));
    fs::remove_all(at("processor1/0"));
    fs::remove_all(at("processor1/0.5"));
    fs::remove_all(at("processor0/1e1"));
    const auto refused = open_openfoam(at(""));
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, Error::Code::NotFound);
    EXPECT_EQ(refused.error().message, "the processors of cavity have no time with U in common");
    fs::remove_all(at("processor0/constant"));
    EXPECT_FALSE(open_openfoam(at("")).has_value());
    fs::rename(at("processor0"), at("processor2"));
    EXPECT_EQ(open_openfoam(at("")).error().message, "cavity has processor1, but no processor0");
    fs::create_directories(at("processors2"));
    EXPECT_EQ(open_openfoam(at("")).error().code, Error::Code::Unsupported);
}

TEST_F(Processors, OfARunThatWasKilledWhileItWroteOpenWithTheTimesThatAllHave) {
    const auto mesh = foam_block_mesh({});
    for (const auto& part : decompose(mesh))
        put(part, false, "processor" + std::to_string(part.part));
    using Times = std::vector<double>;
    EXPECT_EQ(open()->description().times, (Times{0.0, 0.5, 10.0}));

    const auto half_written = at("processor1/1e1/U");
    fs::resize_file(half_written, fs::file_size(half_written) / 2);
    const auto source = open();
    EXPECT_EQ(source->description().times, (Times{0.0, 0.5}));
    EXPECT_NE(source->description().note.find("time 1e1 is left out: "), std::string::npos)
        << source->description().note;
    const auto step = source->read(1, source->description().fields);
    ASSERT_TRUE(step) << step.error().message;
    expect_values(*step, 1, mesh.cells.size());

    fs::remove_all(at("processor1/1e1"));
    EXPECT_EQ(open()->description().times, (Times{0.0, 0.5}));
}

} // namespace
} // namespace wakesurf::importer::openfoam_processors_test
