// Numbers as programs write them into text: Fortran's exponents in Plot3D files, and what is no number in legacy VTK files.
#include "importer/sources/plot3d/plot3d_files.hpp"
#include "tests/importer/import_fixture.hpp"

#include <cmath>
#include <functional>
#include <sstream>

namespace wakesurf::importer::written_numbers_test {
namespace {

using WrittenNumbers = Import;

TEST(UsualNumbers, HaveAnExponentEverybodyReads) {
    for (const auto& [fortran, usual] :
         std::vector<std::pair<std::string, std::string>>{{"1.0D+00", "1.0E+00"},
                                                          {"-2.5d-3", "-2.5E-3"},
                                                          {"0.123-101", "0.123E-101"},
                                                          {"-0.5+102", "-0.5E+102"},
                                                          {"1.E-5", "1.E-5"},
                                                          {"-3", "-3"},
                                                          {"12", "12"},
                                                          {"", ""}})
        EXPECT_EQ(usual_number(fortran), usual);
}

/// 3 x 3 x 3 nodes from 0 to 2, in the notation of `real`.
std::string grid(const std::function<std::string(double)>& real) {
    std::string out = "3 3 3\n";
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < 27; ++i)
            out += real(c == 0 ? i % 3 : c == 1 ? i / 3 % 3 : i / 9) + "\n";
    return out;
}

/// Density 2, velocity (1, z, 0); one velocity is as small as 32 bits cannot hold.
std::string solution(const std::function<std::string(double)>& real) {
    std::string out =
        "3 3 3\n" + real(0.2) + " " + real(0.0) + " " + real(100.0) + " " + real(4.5) + "\n";
    for (int c = 0; c < 5; ++c)
        for (int i = 0; i < 27; ++i)
            out += real(c == 0   ? 2.0
                        : c == 1 ? 2.0
                        : c == 2 ? 2.0 * (i / 9)
                        : c == 3 ? 1.23e-102
                                 : 5.0) +
                   "\n";
    return out;
}

std::string with_d(double value) {
    std::ostringstream out;
    out.precision(12);
    out << std::scientific << value;
    std::string text = out.str();
    const auto mark = text.find('e');
    // Three digits of exponent leave no place for the letter.
    if (text.size() - mark > 4)
        return text.erase(mark, 1);
    text[mark] = 'D';
    return text;
}

TEST_F(WrittenNumbers, OfFortranAreReadInPlot3dText) {
    put("flow.xyz", grid(with_d));
    put("flow.q", solution(with_d));
    const auto outcome = run("flow.xyz");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto v = velocity(0);
    ASSERT_EQ(v.size(), 81u);
    for (std::size_t i = 0; i < 27; ++i) {
        EXPECT_EQ(v[3 * i], 1.0f);
        EXPECT_EQ(v[3 * i + 1], static_cast<float>(i / 9));
        EXPECT_EQ(v[3 * i + 2], 0.0f);
    }
    EXPECT_EQ(reader()->times(), (std::vector<double>{4.5}));
}

TEST_F(WrittenNumbers, ThatAreNoneAreGapsInLegacyFiles) {
    for (const std::string type : {"float", "double"}) {
        std::string text = "# vtk DataFile Version 3.0\nnan of a run\nASCII\nDATASET "
                           "STRUCTURED_POINTS\nDIMENSIONS 3 3 3\nORIGIN 0 0 0\nSPACING 1 1 "
                           "1\nPOINT_DATA 27\nVECTORS U " +
                           type + "\n";
        const std::array<std::string, 4> gaps{"nan", "-nan", "NaN", "inf"};
        for (std::size_t i = 0; i < 27; ++i)
            text += (i < 4 ? gaps[i] : std::string("1.5")) + " 2 3e0\n";
        put(type + ".vtk", text);
        const auto outcome = run(type + ".vtk");
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        const auto v = velocity(0);
        for (std::size_t i = 0; i < 27; ++i) {
            EXPECT_EQ(std::isnan(v[3 * i]), i < 4) << i;
            EXPECT_EQ(v[3 * i + 1], 2.0f);
        }
        std::filesystem::remove_all(store());
    }
}

} // namespace
} // namespace wakesurf::importer::written_numbers_test
