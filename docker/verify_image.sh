# Sourced by docker/verify: tries `image` with podman. Wants `root`, `work`, `image`, `containers` and say().
# shellcheck shell=bash disable=SC2154 # those come from docker/verify

# shellcheck source=docker/one_check.sh
. "$root/docker/one_check.sh"

# runc and these limits: crun does not start where control groups are of both versions, nor without the right to raise limits.
podman_run() {
    timeout 120 podman --cgroup-manager cgroupfs --runtime runc run --network none \
        --ulimit nofile=8192:8192 --ulimit nproc=2000:2000 "$@"
}
hardened=(--read-only --tmpfs /tmp --cap-drop ALL --security-opt no-new-privileges --memory 512m --memory-swap 512m
    --pids-limit 512)

# start NAME [OPTION...] -- [ARGUMENT...]
start() {
    local name=$1 options=()
    shift
    while [ "$1" != -- ]; do
        options+=("$1")
        shift
    done
    shift
    podman rm --force --volumes --time 0 "$name" >/dev/null 2>&1 || true
    containers+=("$name")
    podman_run --detach --name "$name" "${hardened[@]}" "${options[@]}" "$image" "$@" >/dev/null
}
healthy() { # NAME, within 30 s: the importer has its first step by then, and the server listens before
    local end=$((SECONDS + 30))
    until podman healthcheck run "$1" >/dev/null 2>&1; do
        [ $SECONDS -lt $end ] || {
            podman logs "$1"
            return 1
        }
        sleep 0.2
    done
}
pid_of() { podman inspect --format '{{.State.Pid}}' "$1"; }
inside() { # NAME COMMAND...: a command of this machine on the container's network
    local pid
    pid=$(pid_of "$1")
    shift
    timeout 120 nsenter --target "$pid" --net "$@"
}
url_of() { podman logs "$1" 2>/dev/null | sed -n 's/^wakesurf: //p' | tail -n 1; }
say "one command at a time"
check "--version says the version" prints '^wakesurf [0-9]' podman_run --rm "${hardened[@]}" "$image" --version
check "--help lists the commands" prints 'serve' podman_run --rm "${hardened[@]}" "$image" --help
check "info of a built-in flow" prints 'analytic' podman_run --rm "${hardened[@]}" "$image" info flow:abc --json
check "an unknown command is refused" fails_saying 'is not a command' podman_run --rm "${hardened[@]}" "$image" nonsense
check "an unknown dataset is named" fails_saying 'case.pvd' podman_run --rm "${hardened[@]}" "$image" /data/case.pvd
check "it has at most 450 MB" test "$(podman image inspect --format '{{.Size}}' "$image")" -le 450000000
say "          $(podman image inspect --format '{{.Size}}' "$image" | awk '{ printf "%.0f MB", $1 / 1e6 }')"
check "--version names the commit" prints '^commit [0-9a-f]\{12\}' podman_run --rm "${hardened[@]}" "$image" --version
check "it says whose the libraries are" podman_run --rm --entrypoint sh "$image" -c \
    'ls /var/lib/dpkg/status.d | grep -q libvtk && ls /usr/share/doc/libvtk9*/copyright'
for file in share/doc/wakesurf/LICENSE share/doc/wakesurf/THIRD_PARTY.txt share/wakesurf/web/index.html share/wakesurf/web/third-party-notices.txt; do
    check "it has $file" podman_run --rm --entrypoint test "$image" -s "/usr/local/$file"
done

say "without arguments, hardened: no rights, read-only root, 512 MB, 512 processes"
podman volume rm --force wakesurf-verify >/dev/null 2>&1 || true
volume=(--volume wakesurf-verify:/var/lib/wakesurf)
check "starts" start wakesurf-verify "${volume[@]}" --
check "is healthy" healthy wakesurf-verify
check "says that it serves the bundled simulation" prints event=bundled_simulation podman logs wakesurf-verify
check "warns of nothing" not prints 'level=\(warn\|error\)' podman logs wakesurf-verify
check "prints the address with its token" prints '^http://127.0.0.1:8080/#token=.' url_of wakesurf-verify
check "serves the page" prints '<title>' inside wakesurf-verify curl -sSf http://127.0.0.1:8080/
check "wants the token" prints '^401' inside wakesurf-verify \
    curl -sS -o /dev/null -w '%{http_code}\n' http://127.0.0.1:8080/metrics
status() { grep "^$1:" "/proc/$(pid_of wakesurf-verify)/status"; }
check "runs as user 10001" prints '10001' status Uid
check "has no capability" prints '0000000000000000' status CapEff
check "cannot gain rights" prints '1' status NoNewPrivs
check "cannot write its root" fails_saying 'Read-only' podman exec wakesurf-verify touch /x
cat >"$work/surface.py" <<'END_OF_PYTHON'
import sys
sys.path.insert(0, sys.argv[1])
from wakesurf import Client
session = Client(sys.argv[2]).session()
rake = session.rake(line=[(-1.5, -1.2, 1), (-1.5, 1.2, 5)], seeds=32)
surface = session.surface(rake, "streak", dataset="sqcyl", from_=8.5, to=16)
quads = surface.wait(timeout=100)["quads"]
print("quads", quads, "points", len(surface.mesh().points), "session", session.id, surface.id)
END_OF_PYTHON
surface_of() { inside "$1" /usr/bin/python3 "$work/surface.py" "$root/python" "$(url_of "$1")"; }
check "builds a streak surface for a script" prints 'quads [1-9]' surface_of wakesurf-verify
say "          $(grep -o 'quads.*points [0-9]*' "$work/said" || true)"
ids=$(sed -n 's/.* session //p' "$work/said")
limit='' most=''
while IFS=: read -r number controllers group; do # control groups of version 1 and 2
    case $number:$controllers in
    *:memory) limit=/sys/fs/cgroup/memory$group/memory.limit_in_bytes most=/sys/fs/cgroup/memory$group/memory.max_usage_in_bytes ;;
    0:) [ -n "$limit" ] || limit=/sys/fs/cgroup$group/memory.max most=/sys/fs/cgroup$group/memory.peak ;;
    esac
done <"/proc/$(pid_of wakesurf-verify)/cgroup"
check "is limited to 512 MB" prints "^$((512 << 20))$" cat "$limit"
say "          most memory so far: $(($(cat "$most" || echo 0) >> 20)) MB"
stops_soon() {
    local start end
    start=$(date +%s%N)
    podman stop --time 10 wakesurf-verify
    end=$(date +%s%N)
    echo "$(((end - start) / 1000000)) ms, exit status $(podman inspect --format '{{.State.ExitCode}}' wakesurf-verify)"
    [ $((end - start)) -lt 2000000000 ] && [ "$(podman inspect --format '{{.State.ExitCode}}' wakesurf-verify)" = 0 ]
}
token=$(url_of wakesurf-verify)
check "stops within 2 s, with status 0" stops_soon
say "          $(tail -n 1 "$work/check.log")"

say "the volume, without a server"
check "sessions list shows the session" prints "${ids% *}" \
    podman_run --rm "${hardened[@]}" "${volume[@]}" "$image" sessions list

say "started again on the same volume"
check "starts" start wakesurf-verify "${volume[@]}" --
check "is healthy" healthy wakesurf-verify
check "has the same token" test "$(url_of wakesurf-verify)" = "$token"
cat >"$work/kept.py" <<'END_OF_PYTHON'
import sys
sys.path.insert(0, sys.argv[1])
from wakesurf import Client
session = Client(sys.argv[2]).session(sys.argv[3])
surfaces = session.surfaces()
print("kept", sys.argv[4] in [each.id for each in surfaces], "quads", surfaces[-1].wait(timeout=100)["quads"])
END_OF_PYTHON
kept() {
    # shellcheck disable=SC2086 # two ids
    inside wakesurf-verify /usr/bin/python3 "$work/kept.py" "$root/python" "$(url_of wakesurf-verify)" $ids
}
check "has the session with its surface" prints 'kept True quads [1-9]' kept
podman rm --force --volumes --time 2 wakesurf-verify >/dev/null 2>&1

say "other options"
check "--listen on the command line wins" start wakesurf-verify "${volume[@]}" -- flow:abc --listen 127.0.0.1:9123
check "the health check follows it" healthy wakesurf-verify
check "and so does the address" prints ':9123/' url_of wakesurf-verify
check "-e WAKESURF_LISTEN does as well" start wakesurf-verify "${volume[@]}" -e WAKESURF_LISTEN=127.0.0.1:9124 -- flow:abc
check "and the health check follows that" healthy wakesurf-verify
check "--web, --store, --state and --token-file win" start wakesurf-verify --tmpfs /other:mode=1777 -- \
    flow:abc --web /usr/local/share/wakesurf/web --store /other/store --state /other/state --token-file /other/token
check "with them it is healthy" healthy wakesurf-verify
check "data mounted at /data are served when none are named" start wakesurf-verify "${volume[@]}" \
    --volume "$root/data/sqcyl:/data:ro" --
check "with them it is healthy" healthy wakesurf-verify
check "and they are not the bundled ones" not prints event=bundled_simulation podman logs wakesurf-verify
podman rm --force --volumes --time 2 wakesurf-verify >/dev/null 2>&1

say "mistakes are told with their cure"
mkdir -p "$work/of-root" "$work/closed"
chmod 755 "$work" "$work/of-root"
chmod 700 "$work/closed"
check "a volume of another user" fails_saying 'chown -R 10001' \
    podman_run --rm "${hardened[@]}" --volume "$work/of-root:/var/lib/wakesurf" "$image"
say "          $(tail -n 1 "$work/said")"
check "data that its user cannot read" fails_saying 'chmod -R o+rX' \
    podman_run --rm "${hardened[@]}" --volume "$work/closed:/data:ro" "$image"
say "          $(tail -n 1 "$work/said")"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
