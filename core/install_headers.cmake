# Installs the public headers, and whatever they include. All others are private, and may change between versions.
# Run by `cmake --install`, with SOURCES, the root of the repository.
cmake_policy(VERSION 3.25)
set(waiting
    core/dataset/scalar_source.hpp
    core/dataset/time_step_cache.hpp
    core/field/analytic_flow.hpp
    core/field/sample_grid.hpp
    core/field/sample_scalar.hpp
    core/field/stored_flow.hpp
    core/field/velocity_gradient.hpp
    core/surface/contour_lines.hpp
    core/surface/keyed_mesh.hpp
    core/surface/obstacle_surface.hpp
    core/surface/patches/tessellation.hpp
    core/surface/playback/surface_at.hpp
    core/surface/rake_check.hpp
    core/surface/suggestion/scene_suggestion.hpp
    core/surface/surface_builder.hpp
    core/surface/vertex_times.hpp)
set(installed)
while(waiting)
    list(POP_FRONT waiting header)
    if(header IN_LIST installed)
        continue()
    endif()
    list(APPEND installed ${header})
    get_filename_component(folder ${header} DIRECTORY)
    file(INSTALL ${SOURCES}/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/include/wakesurf/${folder})
    file(STRINGS ${SOURCES}/${header} lines REGEX "^#include \"core/")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
        list(APPEND waiting ${included})
    endforeach()
endwhile()
