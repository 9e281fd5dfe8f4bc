# Writes OUTPUT, the source of built_commit() of version.hpp, when the commit of SOURCES has changed: cmake -DSOURCES= -DOUTPUT= [-DCOMMIT=] -P.
# COMMIT wins, for builds without git; then git; then what `git archive` wrote into packaging/commit.txt.
if(NOT COMMIT)
    find_program(GIT git)
    if(GIT AND EXISTS ${SOURCES}/.git)
        execute_process(COMMAND ${GIT} -C ${SOURCES} rev-parse --short=12 HEAD
            OUTPUT_VARIABLE COMMIT ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
        execute_process(COMMAND ${GIT} -C ${SOURCES} diff-index --quiet HEAD
            RESULT_VARIABLE changed ERROR_QUIET OUTPUT_QUIET)
        if(COMMIT AND NOT changed EQUAL 0)
            string(APPEND COMMIT " with changes")
        endif()
    elseif(EXISTS ${SOURCES}/packaging/commit.txt)
        file(STRINGS ${SOURCES}/packaging/commit.txt COMMIT REGEX "^[0-9a-f]+$")
        string(SUBSTRING "${COMMIT}" 0 12 COMMIT)
    endif()
endif()
if(NOT COMMIT MATCHES "^[0-9a-f]+( with changes)?$")
    set(COMMIT unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "server/app/version.hpp"

namespace wakesurf::server {

std::string_view built_commit() { return "@COMMIT@"; }

} // namespace wakesurf::server
]])
