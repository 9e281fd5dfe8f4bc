// Small .vti and .pvd files written by hand, so that every fault can be put into them.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// Returns an ASCII array; `value` is called with the index of every number.
inline std::string vti_array(const std::string& name,
                             int components,
                             std::size_t tuples,
                             const std::function<double(std::size_t)>& value,
                             const std::string& type = "Float32") {
    std::string out = "<DataArray type=\"" + type + "\" Name=\"" + name +
                      "\" NumberOfComponents=\"" + std::to_string(components) +
                      "\" format=\"ascii\">\n";
    std::ostringstream numbers;
    numbers.precision(17);
    for (std::size_t i = 0; i < tuples * static_cast<std::size_t>(components); ++i)
        numbers << value(i) << ' ';
    out += numbers.str();
    return out + "\n</DataArray>\n";
}

struct VtiText {
    std::array<int, 3> nodes{3, 4, 5};
    std::string origin = "0 0 0";
    std::string spacing = "1 1 1";
    std::string direction{};
    std::string points{}; ///< arrays, as vti_array makes them
    std::string cells{};
    std::string field{};

    std::size_t point_count() const {
        return static_cast<std::size_t>(nodes[0] * nodes[1] * nodes[2]);
    }

    std::size_t cell_count() const {
        return static_cast<std::size_t>((nodes[0] - 1) * (nodes[1] - 1) * (nodes[2] - 1));
    }

    std::string extent() const {
        std::string out;
        for (const int n : nodes)
            out += "0 " + std::to_string(n - 1) + " ";
        return out;
    }

    std::string text() const {
        return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\" "
               "byte_order=\"LittleEndian\">\n<ImageData WholeExtent=\"" +
               extent() + "\" Origin=\"" + origin + "\" Spacing=\"" + spacing + "\"" +
               (direction.empty() ? "" : " Direction=\"" + direction + "\"") + ">\n" +
               (field.empty() ? "" : "<FieldData>" + field + "</FieldData>\n") +
               "<Piece Extent=\"" + extent() + "\">\n<PointData>\n" + points +
               "</PointData>\n<CellData>\n" + cells +
               "</CellData>\n</Piece>\n</ImageData>\n</VTKFile>\n";
    }
};

/// Returns a valid file: velocity U = offset, offset + 1, ... over all numbers.
inline VtiText sample_vti(double offset = 0.0) {
    VtiText out;
    out.points = vti_array("U", 3, out.point_count(),
                           [offset](std::size_t i) { return offset + static_cast<double>(i); });
    return out;
}

inline std::string pvd_text(const std::vector<std::pair<std::string, std::string>>& time_and_file) {
    std::string out =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (const auto& [time, file] : time_and_file)
        out += "<DataSet timestep=\"" + time + "\" file=\"" + file + "\"/>\n";
    return out + "</Collection>\n</VTKFile>\n";
}

} // namespace wakesurf::tests
