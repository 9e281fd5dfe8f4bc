#include "core/dataset/cell_mesh.hpp"

#include <span>

namespace wakesurf::core {

namespace {

constexpr std::array<CellFace, 4> tetrahedron{
    {{3, {0, 1, 3, 0}}, {3, {1, 2, 3, 0}}, {3, {2, 0, 3, 0}}, {3, {0, 2, 1, 0}}}};
constexpr std::array<CellFace, 5> pyramid{{{4, {0, 3, 2, 1}},
                                           {3, {0, 1, 4, 0}},
                                           {3, {1, 2, 4, 0}},
                                           {3, {2, 3, 4, 0}},
                                           {3, {3, 0, 4, 0}}}};
constexpr std::array<CellFace, 5> wedge{{{3, {0, 1, 2, 0}},
                                         {3, {3, 5, 4, 0}},
                                         {4, {0, 3, 4, 1}},
                                         {4, {1, 4, 5, 2}},
                                         {4, {2, 5, 3, 0}}}};
constexpr std::array<CellFace, 6> hexahedron{{{4, {0, 4, 7, 3}},
                                              {4, {1, 2, 6, 5}},
                                              {4, {0, 1, 5, 4}},
                                              {4, {3, 7, 6, 2}},
                                              {4, {0, 3, 2, 1}},
                                              {4, {4, 5, 6, 7}}}};

std::span<const CellFace> faces(CellShape shape) {
    switch (shape) {
    case CellShape::Tetrahedron:
        return tetrahedron;
    case CellShape::Pyramid:
        return pyramid;
    case CellShape::Wedge:
        return wedge;
    case CellShape::Hexahedron:
        break;
    }
    return hexahedron;
}

} // namespace

std::size_t node_count(CellShape shape) {
    constexpr std::array<std::size_t, 4> counts{4, 5, 6, 8};
    return counts[static_cast<std::size_t>(shape)];
}

std::size_t face_count(CellShape shape) {
    return faces(shape).size();
}

CellFace face(CellShape shape, std::size_t number) {
    return faces(shape)[number];
}

} // namespace wakesurf::core
