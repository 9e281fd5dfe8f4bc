# Part of `cmake --install --component program`: what the built programs make of themselves, and what names the prefix. Wants SOURCES, MADE
# (a folder of the build tree), WAKESURF and WAKESURF_IMPORT (the programs).
file(MAKE_DIRECTORY ${MADE})

# made FILE COMMAND...: a default that this shell's environment gives is not the program's own.
function(made file)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=WAKESURF_LISTEN ${ARGN} OUTPUT_FILE ${MADE}/${file}
        COMMAND_ERROR_IS_FATAL ANY)
endfunction()
made(wakesurf.1 ${WAKESURF} --man-page)
made(wakesurf-import.1 ${WAKESURF_IMPORT} --man-page)
made(wakesurf ${WAKESURF} --bash-completion)
configure_file(${SOURCES}/packaging/wakesurf.service.in ${MADE}/wakesurf.service @ONLY)

file(INSTALL ${MADE}/wakesurf.1 ${MADE}/wakesurf-import.1 DESTINATION ${CMAKE_INSTALL_PREFIX}/share/man/man1)
file(INSTALL ${MADE}/wakesurf DESTINATION ${CMAKE_INSTALL_PREFIX}/share/bash-completion/completions)
file(INSTALL ${MADE}/wakesurf.service DESTINATION ${CMAKE_INSTALL_PREFIX}/lib/systemd/system)
