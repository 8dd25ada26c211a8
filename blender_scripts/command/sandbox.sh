# SPDX-License-Identifier: GPL-3.0-or-later
# Runs commands inside a suite with bubblewrap. /usr and /etc are the suite's, read-only; the machine's other folders
# are visible read-only, so that scenes find their textures and libraries; writable are the current folder, the folders
# of outputs, /tmp and the work folders in the cache. Nothing stays mounted afterwards. Temporary files are per work
# folder, because the names of some contain the process id, which can be the same in two sandboxes.

# in_suite SUITE WORK COMMAND...: runs a command in a suite; WORK: the checkout's folder for this suite, contains HOME.
in_suite() {
    suite_root=$cache/$1/root
    work=$2
    shift 2
    for place in "$project" "$cache"; do
        ! is_system "$place" || fail "$place cannot be seen inside Debian $target_name: move it out of /usr, /etc and the like"
    done
    mkdir -p "$work/home" "$work/tmp" "$cache/ccache"
    find "$work" -maxdepth 1 -name 'sandbox.*' -mmin +1 -delete # of killed runs
    options=$(mktemp "$work/sandbox.XXXXXX")
    # In bubblewrap later mounts cover earlier ones, so writable ones come last.
    {
        system_options
        named_options --ro-bind "$@"
        option --ro-bind "$project" "$project"
        is_system "$PWD" || option --bind "$PWD" "$PWD"
        named_options --bind "$@"
        option --bind "$work" "$work" --bind "$cache/ccache" "$cache/ccache" --chdir "$PWD"
        environment_options
        # What would be written to the sandbox's own folders would be lost at its end.
        option --remount-ro / --remount-ro /dev --remount-ro /run
    } >"$options"
    exec 8<"$options"
    rm "$options"
    run_child bwrap --args 8 "$@" 8<&8
}

option() {
    printf '%s\0' "$@"
}

system_options() {
    option --unshare-pid --die-with-parent --clearenv --dev /dev --dev-bind-try /dev/dri /dev/dri --bind-try /dev/shm /dev/shm --proc /proc \
        --tmpfs /run --bind /tmp /tmp
    for entry in "$suite_root"/*; do
        [ ! -h "$entry" ] || option --symlink "$(readlink "$entry")" "/${entry##*/}"
    done
    option --ro-bind "$suite_root/usr" /usr --ro-bind "$suite_root/etc" /etc
    for entry in /*; do
        is_system "$entry" || option --ro-bind-try "$entry" "$entry"
    done
}

# is_system PATH: whether the sandbox has its own folder there instead of the machine's.
is_system() {
    case $1 in
    / | /usr | /usr/* | /etc | /etc/* | /dev | /dev/* | /proc | /proc/* | /run | /tmp) ;;
    /bin | /bin/* | /sbin | /sbin/* | /lib | /lib/* | /lib32 | /lib64 | /libx32 | /boot) ;;
    *) return 1 ;;
    esac
}

# named_options HOW WORD...: mount options for the folders of paths among the words: --bind for outputs, --ro-bind for
# inputs.
named_options() {
    how=$1
    shift
    previous=
    for word in "$@"; do
        named=--ro-bind
        case $previous in -o | --output | --dump | --render-output | --pictures) named=--bind ;; esac
        case $word in --output=* | --dump=* | --pictures=*) named=--bind ;; esac
        case $subcommand in blender | render) named=--bind ;; esac
        previous=$word
        [ "$how" = "$named" ] && folder=$(folder_of "${word#--*=}") || continue
        is_system "$folder" || option "$how" "$folder" "$folder"
    done
}

folder_of() {
    if [ -d "$1" ]; then
        (cd "$1" && pwd)
    else
        case $1 in
        */*) (cd "${1%/*}/" 2>/dev/null && pwd) ;;
        *) return 1 ;; # in the current folder, or not a path
        esac
    fi
}

environment_options() {
    option --setenv PATH /usr/bin:/usr/sbin --setenv HOME "$work/home" --setenv LANG C.UTF-8 --setenv TMPDIR "$work/tmp"
    for name in TERM DISPLAY WAYLAND_DISPLAY XAUTHORITY $(env | sed -n 's/^\(FOVEA_[A-Z_]*\)=.*/\1/p'); do
        eval "value=\${$name-}"
        [ -z "$value" ] || option --setenv "$name" "$value"
    done
    [ -z "${XDG_RUNTIME_DIR-}" ] || option --bind-try "$XDG_RUNTIME_DIR" "$XDG_RUNTIME_DIR" \
        --setenv XDG_RUNTIME_DIR "$XDG_RUNTIME_DIR"
}
