# A folder with a minimal Debian, from where this machine's own packages come. Sourced by docker/verify and docker/try_debian.
# shellcheck shell=bash

# make_debian SUITE FOLDER: what debootstrap says goes to FOLDER.log.
make_debian() {
    local suite=$1 folder=$2 archive security
    # shellcheck disable=SC2016 # apt expands it
    archive=$(apt-get indextargets --format '$(REPO_URI)' | grep -v security | sort -u | head -n 1)
    # shellcheck disable=SC2016
    security=$(apt-get indextargets --format '$(REPO_URI)' | grep security | sort -u | head -n 1)
    debootstrap --variant=minbase "$suite" "$folder" "$archive" >"$folder.log" 2>&1 || {
        tail -n 20 "$folder.log" >&2
        return 1
    }
    printf 'deb %s main\n' "$archive $suite" "$archive $suite-updates" ${security:+"$security $suite-security"} \
        >"$folder/etc/apt/sources.list"
}
