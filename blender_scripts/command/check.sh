# SPDX-License-Identifier: GPL-3.0-or-later
# `fovea check`: format, lint and rules of the sources, without building them. The suites share the checks, in parallel.

check_sources() {
    trap 'stop_children; exit 130' INT TERM
    [ -z "$on" ] || fail "check takes no --on: each Debian suite looks at what it has the tools for"
    fix=
    tidied=
    while [ $# -gt 0 ]; do
        case $1 in
        --fix) fix=--fix ;;
        --all) tidied=native ;;
        --since)
            [ $# -gt 1 ] || fail "--since needs a revision of git"
            tidied=$(changed_since "$2") || fail "git does not tell what has changed since '$2'"
            shift
            ;;
        *) say "check takes --fix, --all and --since REVISION, not '$1'" && exit 2 ;;
        esac
        shift
    done
    for suite in $all_suites; do
        (check_on "$suite" $fix --tidy $tidied) &
        eval "child_$suite=$!"
    done
    check_status=0
    for suite in $all_suites; do
        wait_for "$suite" || check_status=1
    done
    [ "$check_status" -ne 0 ] || say "all sources are as they should be"
    return "$check_status"
}

# Tools per suite: only sid has a recent ruff; clang-format's output depends on its version, and trixie stays at 19.
check_tools() {
    case $1 in
    sid) echo ruff ;;
    trixie) echo clang-format-19 clang-tidy-19 ;;
    esac
}

# check_on SUITE WORDS...: runs the checks in the project's folder, which is writable for them.
check_on() {
    use_suite "$1" && set_up_suite "$1" $(check_tools "$1") && cd "$project" || return
    shift
    run_command check "$@"
}

# changed_since REVISION: prints the C++ files of native/ that differ from a git revision, and untracked ones.
changed_since() {
    cd "$project" && git diff --name-only --diff-filter=d "$1" -- native >"$cache/log/changed" &&
        git ls-files --others --exclude-standard native >>"$cache/log/changed" &&
        sed -n '/\.\(h\|cpp\)$/p' "$cache/log/changed"
}
