# What a sub-command runs on: a Debian suite, or a Blender of the user's own.

# choose_target [sid|trixie|/path/to/blender]: sets target_name and, for an own Blender, own_blender.
choose_target() {
    own_blender=
    case ${1:-} in
    sid | trixie) target_name=$1 ;;
    '') choose_blender_at_hand ;;
    */*) use_own_blender "$1" ;;
    *) say "--on takes sid, trixie or the path of a Blender, not '$1'" && return 2 ;;
    esac || return
    [ -n "$own_blender" ] || set_up_suite "$target_name"
}

choose_blender_at_hand() {
    target_name=sid
    if [ -n "${BLENDER:-}" ]; then
        use_own_blender "$BLENDER"
    fi
}

# run_command SUBCOMMAND ARGUMENTS...: on the chosen target.
run_command() {
    work=$cache/$target_name/work-$(printf %s "$project" | sha256sum | cut -c 1-8)
    mkdir -p "$work"
    set -- python3 -B "$here/main.py" --target "$target_name" --work "$work" --cache "$cache" "$@"
    if [ -n "$own_blender" ]; then
        on_this_machine "$work" "$@"
    else
        in_suite "$target_name" "$work" "$@"
    fi
}
