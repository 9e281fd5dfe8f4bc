# What ./run and ./check share: packages, npm packages, build, web client. Sourced by bash; wants `root` and `log`.
# Every step does nothing, fast, when there is nothing to do. Progress goes to standard error, one line a stage.
# shellcheck shell=bash disable=SC2034,SC2154 # root and log come from the script that sources this

release=$root/build/release
web=$root/web-client

say() { printf '%s\n' "$*" >&2; }

# Only one set-up at a time works on the build folder.
begin_setup() {
    mkdir -p "$root/build"
    : >"$log"
    exec 9>"$root/build/.lock"
    flock -n 9 || {
        say "waiting for another ./run or ./check to finish its set-up ..."
        flock 9
    }
}

end_setup() { exec 9>&-; }

# announce TESTS: what this start takes besides Debian packages, which install_packages counts. Said before anything begins.
announce() {
    local parts=() cores minutes=12 # of one slow core, with g++ 12: the programs
    [ "$1" != ON ] || minutes=26    # with all tests
    cores=$(nproc)
    [ -d "$web/node_modules" ] || parts+=("up to 140 MB of npm packages to download")
    [ -n "$(ls "$release/bin" 2>/dev/null)" ] ||
        parts+=("some $(((minutes + cores - 1) / cores)) min of compiling on the $cores cores of this machine")
    case ${#parts[@]} in
    1) say "the first start takes ${parts[0]}" ;;
    2) say "the first start takes ${parts[0]} and ${parts[1]}" ;;
    esac
}

# stage TITLE COMMAND...: the output goes to the log; of a failure the end is shown.
stage() {
    local title=$1 start=$SECONDS
    shift
    printf '%s ... ' "$title" >&2
    printf '\n== %s: %s\n' "$title" "$*" >>"$log"
    if "$@" </dev/null >>"$log" 2>&1; then
        say "$((SECONDS - start)) s"
    else
        say "failed; the end of $log:"
        tail -n 40 "$log" >&2
        return 1
    fi
}

setup_packages() {
    [ "${WAKESURF_PACKAGES:-}" = present ] && return
    # Asked for first, in sight: sudo may want a password.
    "$root/packaging/install_packages" "$@" >&2
    "$root/packaging/unpack_vtk" "$root/build/vtk" >>"$log" || {
        say "VTK's headers could not be downloaded: install libvtk9-dev by hand, then start again"
        return 1
    }
}

setup_npm() {
    # shellcheck source=/dev/null
    . "$web/toolchain/activate.sh" >>"$log" # a node that is new enough, first in PATH
    local stamp=$web/node_modules/.wakesurf-lock now
    now=$(sha256sum <"$web/package-lock.json")
    [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$now" ] && return
    stage "npm packages" npm --prefix "$web" ci --no-audit --no-fund --prefer-offline || return 1
    printf '%s\n' "$now" >"$stamp"
}

# The paths and contents of everything the web client is built from.
web_fingerprint() {
    (cd "$web" && find . ../python \( -name node_modules -o -name dist -o -name coverage \) -prune -o -type f -print0 |
        LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum)
}

setup_web() {
    local stamp=$root/build/web-client.sha256 now
    "$root/protocol/api/generate" --build || return 1
    now=$(web_fingerprint)
    [ -f "$web/dist/index.html" ] && [ -f "$stamp" ] && [ "$(cat "$stamp")" = "$now" ] && return
    stage "web client" npm --prefix "$web" run build || return 1
    printf '%s\n' "$now" >"$stamp"
}

cached() { sed -n "s/^$2:[A-Z]*=//p" "$1/CMakeCache.txt" 2>/dev/null; }

# configure PRESET: `release`, or `tested`, which adds the tests. Both have build/release, where the tests stay once they are there, so that ./run
# after ./check rebuilds nothing.
configure() {
    local preset=$1 tests=OFF home
    [ "$(cached "$release" WAKESURF_TESTS)" != ON ] || preset=tested
    [ "$preset" = release ] || tests=ON
    home=$(cached "$release" CMAKE_HOME_DIRECTORY)
    [ -z "$home" ] || [ "$home" = "$root" ] || rm -rf "$release"
    if [ -f "$release/build.ninja" ] && [ "$(cached "$release" WAKESURF_TESTS)" = "$tests" ] &&
        [ ! "$root/CMakePresets.json" -nt "$release/CMakeCache.txt" ]; then
        return
    fi
    # --fresh: what CMake remembers of packages that have gone since then is wrong.
    (cd "$root" && stage "configuring" cmake --fresh --preset "$preset") || return 1
    touch "$release/CMakeCache.txt"
}
