# SPDX-License-Identifier: GPL-3.0-or-later
# The target of a sub-command: a Debian suite, or the user's own Blender.

# choose_target [sid|trixie|/path/to/blender]: sets target_name, blender, python, python_include and module; sets up the suite.
choose_target() {
    case ${1:-} in
    sid | trixie) use_suite "$1" ;;
    */*) must_use_own_blender "$1" ;;
    '') choose_blender_at_hand ;;
    *) say "--on takes sid, trixie or the path of a Blender, not '$1'" && return 2 ;;
    esac
}

use_suite() {
    target_name=$1
    blender=/usr/bin/blender
    python=/usr/bin/python3
    python_include=
    module= # is built
    set_up_suite "$1"
}

# Uses Debian sid or, if it cannot be installed at the moment, the stable release.
use_newest_suite() {
    use_suite sid && return
    [ "$(id -u)" = 0 ] || return # without root the other suite cannot be set up either
    say "going on with Debian trixie and its Blender, as sid cannot be installed today (the reason stands above); --on sid tries it again"
    use_suite trixie
}

must_use_own_blender() {
    use_own_blender "$1" || { say "$reason" && return 1; }
}

choose_blender_at_hand() {
    if [ -n "${BLENDER:-}" ]; then
        must_use_own_blender "$BLENDER"
    elif on_path=$(command -v blender); then
        use_own_blender "$on_path" || { say "$reason; using Fovea's own Blender" && use_newest_suite; }
    else
        use_newest_suite
    fi
}

# run_command SUBCOMMAND ARGUMENTS...: runs a sub-command on the chosen target.
run_command() {
    work=$(work_folder)
    mkdir -p "$work/home"
    set -- "$python" -B "$here/main.py" "$target_name" "$work" "$cache" "$blender" "$python_include" "$module" "$@"
    case $target_name in
    own-*) run_child "$@" ;;
    *) in_suite "$target_name" "$work" "$@" ;;
    esac
}

# run_child COMMAND...: runs a command as a child that is waited for, so that an interrupt of this shell alone reaches it.
run_child() {
    "$@" <&0 &
    child=$!
    wait "$child"
}

# Interrupts the child, or the command in its sandbox, and ends when it has put its things in order.
interrupt() {
    trap '' INT TERM
    running=${child:-}
    while [ "$(cat "/proc/$running/comm" 2>/dev/null)" = bwrap ]; do
        running=$(cut -d ' ' -f 1 "/proc/$running/task/$running/children")
    done
    [ -z "$running" ] || kill -INT "$running" 2>/dev/null || true
    [ -z "${child:-}" ] || wait "$child" || true
    exit 130
}

# Prints this checkout's work folder for the chosen target.
work_folder() {
    echo "$cache/$target_name/work-$(short_hash "$project")"
}

short_hash() {
    printf %s "$1" | sha256sum | cut -c 1-8
}
