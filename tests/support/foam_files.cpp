#include "tests/support/foam_files.hpp"

#include "tests/support/temporary_folder.hpp"

#include <cstdint>
#include <sstream>

namespace wakesurf::tests {

namespace {

constexpr const char* banner = "/*----*- C++ -*----*\\\n"
                               "| \\\\    /   O peration |\n"
                               "\\*-----------------*/\n";

std::string header(const std::string& type, const std::string& object, bool binary) {
    return banner + std::string("FoamFile\n{\n    version     2.0;\n") +
           std::string(
               binary ? "    format      binary;\n    arch        \"LSB;label=32;scalar=64\";\n"
                      : "    format      ascii;\n") +
           "    class       " + type + ";\n    object      " + object + ";\n}\n// * * * //\n\n";
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

// Rows of one or several numbers: N ( ... ), numbers of a row in brackets of their own.
template <class T>
std::string list(const std::vector<std::vector<T>>& rows, bool binary) {
    std::ostringstream out;
    out.precision(9);
    out << rows.size() << (binary ? "\n(" : "\n(\n");
    for (const auto& row : rows) {
        if (binary) {
            out << bytes_of(row);
            continue;
        }
        if (row.size() > 1)
            out << '(';
        for (std::size_t i = 0; i < row.size(); ++i)
            out << (i > 0 ? " " : "") << row[i];
        out << (row.size() > 1 ? ")\n" : "\n");
    }
    out << ")\n";
    return out.str();
}

std::string face_list(const FoamMesh& mesh, bool binary) {
    if (binary) {
        std::vector<std::vector<std::int32_t>> offsets{{0}};
        std::vector<std::vector<std::int32_t>> nodes;
        for (const auto& face : mesh.faces) {
            for (const int node : face.nodes)
                nodes.push_back({node});
            offsets.push_back({static_cast<std::int32_t>(nodes.size())});
        }
        return header("faceCompactList", "faces", true) + list(offsets, true) + list(nodes, true);
    }
    std::ostringstream out;
    out << header("faceList", "faces", false) << mesh.faces.size() << "\n(\n";
    for (const auto& face : mesh.faces) {
        out << face.nodes.size() << '(';
        for (std::size_t i = 0; i < face.nodes.size(); ++i)
            out << (i > 0 ? " " : "") << face.nodes[i];
        out << ")\n";
    }
    out << ")\n";
    return out.str();
}

} // namespace

void write_foam_mesh(const std::filesystem::path& folder, const FoamMesh& mesh, bool binary) {
    const auto place = folder / "polyMesh";
    std::filesystem::create_directories(place);
    std::vector<std::vector<double>> points;
    for (const auto& p : mesh.points)
        points.push_back({p[0], p[1], p[2]});
    std::vector<std::vector<std::int32_t>> owners;
    std::vector<std::vector<std::int32_t>> neighbours;
    for (const auto& face : mesh.faces) {
        owners.push_back({face.owner});
        if (face.neighbour >= 0)
            neighbours.push_back({face.neighbour});
    }
    write_file(place / "points", header("vectorField", "points", binary) + list(points, binary));
    write_file(place / "faces", face_list(mesh, binary));
    write_file(place / "owner", header("labelList", "owner", binary) + list(owners, binary));
    write_file(place / "neighbour",
               header("labelList", "neighbour", binary) + list(neighbours, binary));
    std::ostringstream out;
    out << header("polyBoundaryMesh", "boundary", false) << mesh.patches.size() << "\n(\n";
    for (const auto& patch : mesh.patches) {
        out << patch.name << "\n{\n    type " << patch.type << ";\n    nFaces " << patch.size
            << ";\n    startFace " << patch.start << ";\n";
        if (patch.other_part >= 0)
            out << "    myProcNo " << mesh.part << ";\n    neighbProcNo " << patch.other_part
                << ";\n";
        if (!patch.other_patch.empty())
            out << "    neighbourPatch " << patch.other_patch << ";\n";
        out << "}\n";
    }
    out << ")\n";
    write_file(place / "boundary", out.str());
}

void write_foam_field(const std::filesystem::path& folder,
                      const FoamMesh& mesh,
                      const FoamField& field,
                      bool binary) {
    std::filesystem::create_directories(folder);
    const bool vector = field.values.empty() ? field.name == "U" : field.values.front().size() == 3;
    std::string out = header(vector ? "volVectorField" : "volScalarField", field.name, binary) +
                      "dimensions      " + field.dimensions +
                      ";\n\ninternalField   nonuniform List<" + (vector ? "vector" : "scalar") +
                      "> " + list(field.values, binary) + ";\n\nboundaryField\n{\n";
    for (const auto& patch : mesh.patches) {
        const auto given = field.patches.find(patch.name);
        out += patch.name + "\n{\n    ";
        if (patch.type == "processor")
            out += std::string("type processor; value uniform ") + (vector ? "(0 0 0)" : "0") + ";";
        else
            out += given == field.patches.end() ? "type zeroGradient;" : given->second;
        out += "\n}\n";
    }
    write_file(folder / field.name, out + "}\n");
}

FoamField part_of(const FoamField& field, const FoamMesh& part) {
    FoamField out = field;
    out.values.clear();
    for (const int cell : part.cells)
        out.values.push_back(field.values[static_cast<std::size_t>(cell)]);
    return out;
}

} // namespace wakesurf::tests
