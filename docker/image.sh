# Builds the image with buildah, as root and without a daemon. Sourced by docker/verify and ./package; wants `root`, `work` (a folder for
# temporary files) and say().
# shellcheck shell=bash disable=SC2154 # those come from the script that sources this

# shellcheck source=docker/debian_root.sh
. "$root/docker/debian_root.sh"

# debian_image SUITE: an image of that release, made once; prints its name.
debian_image() {
    local suite=$1 tag=localhost/wakesurf-base:$1 container
    if ! buildah inspect --type image "$tag" >/dev/null 2>&1; then
        say "making $tag with debootstrap ..." >&2
        make_debian "$suite" "$work/debian" || return 1
        # What the slim images of Debian leave out as well.
        rm -rf "$work"/debian/var/cache/apt/* "$work"/debian/var/lib/apt/lists/* "$work"/debian/usr/share/{man,locale,info}/*
        container=$(buildah from scratch)
        buildah add --quiet "$container" "$work/debian" / >/dev/null
        buildah commit --quiet --rm "$container" "$tag" >/dev/null
        rm -rf "$work/debian"
    fi
    printf '%s\n' "$tag"
}

# build_image NAME BASE CA CCACHE COMMIT: empty where not given. BASE: an image, or debootstrap[:SUITE], a Debian made here.
build_image() {
    local name=$1 base=$2 ca=$3 ccache=$4 commit=$5 context=$work/context arguments=() start=$SECONDS
    mkdir -p "$context"
    # What a clone would have, with what is not committed yet.
    (cd "$root" && git ls-files -z --cached --others --exclude-standard | tar --null -T - -c) | tar -x -C "$context"
    # What this machine was told to trust beside Debian's own, its image needs too while it is built.
    if [ -n "$ca" ]; then
        cp "$ca" "$context/docker/ca/extra.crt"
    else
        find /usr/local/share/ca-certificates -name '*.crt' -exec cp -t "$context/docker/ca" {} + 2>/dev/null || true
    fi
    case $base in
    debootstrap*)
        base=${base#debootstrap} base=${base#:}
        base=$(debian_image "${base:-bookworm}")
        arguments+=(--pull-never)
        ;;
    esac
    [ -z "$base" ] || arguments+=(--build-arg "BASE=$base")
    [ -z "$commit" ] || arguments+=(--build-arg "COMMIT=$commit")
    [ -z "$ccache" ] || arguments+=(--volume "$ccache:/ccache")
    say "building on ${base:-the Dockerfile\'s base} ..."
    buildah bud --layers --format docker --isolation chroot "${arguments[@]}" \
        -f "$context/docker/Dockerfile" -t "$name" "$context" >"$work/build.log" 2>&1 || {
        tail -n 60 "$work/build.log" >&2
        say "the image was not built"
        return 1
    }
    say "built in $((SECONDS - start)) s: $(podman image inspect --format '{{.Size}}' "$name" | awk '{ printf "%.0f MB", $1 / 1e6 }')"
}
