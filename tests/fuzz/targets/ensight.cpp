// An EnSight case, its geometry and a variable: the input is the three files, a line of equals signs between them.
#include "importer/sources/ensight/ensight_case.hpp"
#include "importer/sources/ensight/ensight_file.hpp"
#include "importer/sources/files/formats.hpp"
#include "tests/fuzz/targets/all.hpp"
#include "tests/fuzz/targets/scratch_file.hpp"
#include "tests/support/ensight_text.hpp"

#include <algorithm>
#include <functional>

namespace wakesurf::fuzz {

namespace {

using tests::EnsightEncoding;
using tests::EnsightText;
using FieldSource = core::FieldInfo::Source;

constexpr std::string_view border = "\n====\n";

std::string_view part_of(std::string_view& rest) {
    const auto end = std::min(rest.find(border), rest.size());
    const auto part = rest.substr(0, end);
    rest.remove_prefix(std::min(end + border.size(), rest.size()));
    return part;
}

std::string case_text(const std::string& place) {
    return "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: geo\nVARIABLE\nvector per " + place +
           ": 1 velocity vel\nscalar per " + place +
           ": 2 p \"p.**\"\nTIME\ntime set: 1\nnumber of steps: 2\nfilename start number: 0\n"
           "filename increment: 5\ntime values: 0.5 1.5\ntime set: 2\nnumber of steps: 1\n"
           "filename numbers: 3\ntime values:\n0.5\n";
}

void put_points(EnsightText& out, int count) {
    out.line("coordinates");
    out.integers({count});
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<float> along;
        for (int i = 0; i < count; ++i)
            along.push_back(static_cast<float>(i >> axis & 1));
        out.numbers(along);
    }
}

// Elements of every kind that is read in its own way, and a block of each shape.
std::string geometry(EnsightEncoding encoding) {
    EnsightText out(encoding);
    if (encoding == EnsightEncoding::Fortran)
        out.line("Fortran Binary");
    else if (encoding != EnsightEncoding::Text)
        out.line("C Binary");
    for (const char* const line : {"made", "by hand", "node id off", "element id off", "part"})
        out.line(line);
    out.integers({1});
    out.line("fluid");
    put_points(out, 8);
    const std::vector<std::pair<const char*, std::vector<std::vector<int>>>> sections{
        {"hexa8", {{1, 2, 4, 3, 5, 6, 8, 7}}},
        {"tria3", {{1, 2, 3}}},
        {"nsided", {{4}, {1, 2, 4, 3}}},
        {"g_tetra4", {{1, 2, 3, 5}}},
        {"nfaced", {{4}, {3, 3, 3, 3}, {1, 2, 3, 1, 2, 5, 2, 3, 5, 1, 3, 5}}}};
    for (const auto& [type, rows] : sections) {
        out.line(type);
        out.integers({1});
        for (const auto& row : rows)
            out.integers(row);
    }
    int number = 2;
    for (const char* const shape :
         {"block iblanked", "block rectilinear", "block uniform iblanked"}) {
        out.line("part");
        out.integers({number++});
        out.line("wall");
        out.line(shape);
        out.integers({2, 2, 2});
        const std::string_view name = shape;
        const bool curved = name == "block iblanked";
        for (int axis = 0; axis < (name == "block uniform iblanked" ? 2 : 3); ++axis)
            out.numbers(std::vector<float>(curved ? 8 : name == "block rectilinear" ? 2 : 3, 1.0f));
        if (name.ends_with("iblanked"))
            out.integers({1, 1, 1, 1, 1, 1, 1, 0});
    }
    return out.text();
}

std::string variable(EnsightEncoding encoding, FieldSource source) {
    EnsightText out(encoding);
    out.line("a variable");
    const auto section = [&](const char* type, std::size_t count) {
        out.line(type);
        for (int c = 0; c < 3; ++c)
            out.numbers(std::vector<float>(count, 0.5f));
    };
    for (int number = 1; number < 5; ++number) {
        out.line("part");
        out.integers({number});
        if (number > 1) {
            section("block", source == FieldSource::Point ? 8 : 1);
        } else if (source == FieldSource::Point) {
            section("coordinates", 8);
        } else {
            for (const char* const type : {"hexa8", "tria3", "nsided", "g_tetra4", "nfaced"})
                section(type, 1);
        }
    }
    return out.text();
}

void run(Input input) {
    std::string_view rest = text_of(input);
    const auto path = scratch_file("a.case", part_of(rest));
    const auto geometry = scratch_file("geo", part_of(rest));
    const auto values = scratch_file("vel", rest);
    if (const auto read = importer::read_ensight_case(path)) {
        demand(!read->times.empty() &&
                   std::adjacent_find(read->times.begin(), read->times.end(),
                                      std::greater_equal<>()) == read->times.end(),
               "times rise");
        if (const auto source = importer::open_ensight(path))
            (*source)->read(0, (*source)->description().fields);
    }
    const auto parts = importer::read_ensight_geometry({geometry, "geo"});
    for (const auto from : {FieldSource::Point, FieldSource::Cell})
        if (parts)
            importer::read_ensight_variable({values, "vel"}, *parts,
                                            {"velocity", 3, from, {0, 0}, ""});
}

std::vector<std::string> seeds() {
    const std::string between(border);
    std::vector<std::string> seeds{
        "FORMAT\ntype: ensight\n" + between,
        // Numbers of files that no int holds, and more of them than any memory.
        "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: geo\nVARIABLE\nvector per node: 1 u u.*\n"
        "TIME\ntime set: 1\nnumber of steps: 9999999\nfilename start number: 2000000000\n"
        "filename increment: 2000000000 1 1 1\ntime values: 0.5 1.5 1e999" +
            between};
    for (const auto encoding : {EnsightEncoding::Text, EnsightEncoding::Binary,
                                EnsightEncoding::SwappedBinary, EnsightEncoding::Fortran})
        for (const auto from : {FieldSource::Point, FieldSource::Cell})
            seeds.push_back(case_text(from == FieldSource::Point ? "node" : "element") + between +
                            geometry(encoding) + between + variable(encoding, from));
    return seeds;
}

} // namespace

const Target ensight_target{"ensight", run, seeds};

} // namespace wakesurf::fuzz
