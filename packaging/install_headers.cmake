# Installs the public headers, and whatever they include, below include/wakesurf: a program includes <wakesurf/core/...>. All others are
# private, and may change between versions. Run by `cmake --install`, with SOURCES, the root of the repository, and MADE, a folder of the build
# tree.
#
# Sources include each other from the root of the repository, as "core/...". On a program's search path that would find the program's own
# core/, and the program ours; so the installed headers have the prefix in their includes, line by line the same otherwise.
cmake_policy(VERSION 3.25)
set(waiting
    core/dataset/scalar_steps.hpp
    core/dataset/steps_in_memory.hpp
    core/dataset/time_step_cache.hpp
    core/field/analytic_flow.hpp
    core/field/function_flow.hpp
    core/field/sample_grid.hpp
    core/field/sample_scalar.hpp
    core/field/stored_flow.hpp
    core/field/velocity_gradient.hpp
    core/surface/contour_lines.hpp
    core/surface/quad_complex.hpp
    core/surface/obstacle_surface.hpp
    core/surface/patches/tessellation.hpp
    core/surface/playback/played_surface.hpp
    core/surface/playback/surface_at.hpp
    core/surface/rake.hpp
    core/surface/suggestion/scene_suggestion.hpp
    core/surface/builder/surface_builder.hpp
    core/surface/surface.hpp
    protocol/files/mesh_file.hpp
    protocol/wire/mesh_decoder.hpp
    protocol/wire/mesh_stream.hpp
    store/open_store.hpp)
set(installed)
while(waiting)
    list(POP_FRONT waiting header)
    if(header IN_LIST installed)
        continue()
    endif()
    list(APPEND installed ${header})
    file(READ ${SOURCES}/${header} text)
    string(REGEX REPLACE "#include \"((core|protocol|store)/[^\"]+)\"" "#include <wakesurf/\\1>" text "${text}")
    file(WRITE ${MADE}/include/wakesurf/${header} "${text}")
    get_filename_component(folder ${header} DIRECTORY)
    file(INSTALL ${MADE}/include/wakesurf/${header} DESTINATION ${CMAKE_INSTALL_PREFIX}/include/wakesurf/${folder})
    file(STRINGS ${SOURCES}/${header} lines REGEX "^#include \"(core|protocol|store)/")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" included "${line}")
        list(APPEND waiting ${included})
    endforeach()
endwhile()
