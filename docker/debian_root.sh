# A folder with a minimal Debian, from where this machine's own packages come, or else from deb.debian.org. Sourced by
# docker/image.sh, docker/try_debian and packaging.
# shellcheck shell=bash

# debian_source LABEL: the address of Debian's archive of that label in this machine's sources; nothing where it has none.
debian_source() {
    # shellcheck disable=SC2016 # apt expands it
    apt-get indextargets --format '$(ORIGIN)/$(LABEL) $(REPO_URI)' 2>/dev/null |
        awk -v label="Debian/$1" '$1 == label && !found { print $2; found = 1 }'
}

# make_debian SUITE FOLDER: what debootstrap says goes to FOLDER.log.
make_debian() {
    local suite=$1 folder=$2 archive security
    archive=$(debian_source Debian)
    security=$(debian_source Debian-Security)
    : "${archive:=http://deb.debian.org/debian/}" "${security:=http://deb.debian.org/debian-security/}"
    debootstrap --variant=minbase "$suite" "$folder" "$archive" >"$folder.log" 2>&1 || {
        echo "debootstrap could not make a Debian of $suite from $archive; the end of $folder.log:" >&2
        tail -n 20 "$folder.log" >&2
        return 1
    }
    printf 'deb %s main\n' "$archive $suite" "$archive $suite-updates" "$security $suite-security" \
        >"$folder/etc/apt/sources.list"
}

# in_debian FOLDER [--bind FROM TO]... COMMAND...: as root in that Debian, in a namespace of mounts of its own, so that nothing stays
# mounted; FROM is a folder of this machine, TO one of that Debian. CCACHE_DIR is /ccache there.
in_debian() {
    local folder=$1 binds=()
    shift
    cp /etc/resolv.conf "$folder/etc/resolv.conf"
    while [ "$1" = --bind ]; do
        mkdir -p "$folder$3"
        binds+=("$2" "$folder$3")
        shift 3
    done
    # shellcheck disable=SC2016 # expanded by the inner shell
    unshare --mount bash -euc '
        folder=$0
        for ((i = 0; i < $1; i += 2)); do mount --bind "${@:i + 2:1}" "${@:i + 3:1}"; done
        shift $(($1 + 1))
        mount -t proc proc "$folder/proc"
        mount --rbind /dev "$folder/dev"
        exec chroot "$folder" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 CI=true CCACHE_DIR=/ccache "$@"' \
        "$folder" "${#binds[@]}" ${binds[@]+"${binds[@]}"} "$@"
}
