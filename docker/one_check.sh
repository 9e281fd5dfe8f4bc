# One line a check, counted. Sourced by docker/verify and packaging/verify; wants `work`, a folder for what commands write.
# shellcheck shell=bash disable=SC2154 # work comes from the script that sources this

say() { printf '%s\n' "$*"; }

passed=0 failed=0
# check WORDS COMMAND...: one line; of a failure also what it wrote.
check() {
    local words=$1
    shift
    if "$@" >"$work/check.log" 2>&1; then
        passed=$((passed + 1))
        say "  ok      $words"
    else
        failed=$((failed + 1))
        say "  FAILED  $words"
        tail -n 20 "$work/check.log" | sed 's/^/          /'
    fi
}

fails_saying() { # WORDS COMMAND...
    local words=$1
    shift
    if "$@" >"$work/said" 2>&1; then
        echo "it did not fail"
        return 1
    fi
    cat "$work/said"
    grep -q -- "$words" "$work/said"
}
prints() { # WORDS COMMAND...
    local words=$1
    shift
    "$@" >"$work/said" 2>&1 || {
        cat "$work/said"
        return 1
    }
    cat "$work/said"
    grep -q -- "$words" "$work/said"
}
not() { ! "$@"; }
