# A folder with a minimal Debian, from where this machine's own packages come, or else from deb.debian.org. Sourced by
# docker/verify and docker/try_debian.
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
