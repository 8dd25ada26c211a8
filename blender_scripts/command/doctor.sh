# SPDX-License-Identifier: GPL-3.0-or-later
# `fovea doctor`: what there is to draw with, what fits, what is missing and the remedy. Plain sh, as the machine may have
# nothing yet; it sets up nothing and needs no root. Returns 1 where `fovea draw` could not draw.

doctor() {
    [ -z "$on" ] || fail "doctor takes no --on: it looks at all; name a Blender by BLENDER="
    told_as=text
    case "$*" in
    '') ;;
    --json) told_as=json ;;
    *) say "doctor takes --json, not '$*'" && exit 2 ;;
    esac
    blenders= modules= uses= uses_name= remedy= renderer= hardware=false
    look_at_own_blenders
    look_at_suite sid
    look_at_suite trixie
    choose_as_draw_does
    look_at_modules
    look_at_gpu
    "tell_$told_as"
    [ -n "$uses" ]
}

look_at_own_blenders() {
    [ -z "${BLENDER:-}" ] || look_at_own BLENDER= "$BLENDER"
    on_path=$(command -v blender) || return 0
    [ "$on_path" = "${BLENDER:-}" ] || look_at_own PATH "$on_path"
}

# look_at_own WHERE PROGRAM
look_at_own() {
    if use_own_blender "$2"; then
        fits=true
        own_says="builds its module when it is used: headers and libraries are there"
        [ -z "$module" ] || own_says="takes the self-contained module ${module#"$modules_folder/"}"
        [ -n "$uses" ] || uses=$1 uses_name="$blender" uses_python=$python
        taken="${taken-} $module "
    else
        fits=false own_says=$reason module=
        [ "$1" != BLENDER= ] || remedy=$reason
    fi
    add_blender "$1" "$2" "$version" "$python_version" "$fits" "$module" "$own_says"
}

# look_at_suite SUITE: reads its files only.
look_at_suite() {
    root=$cache/$1/root
    version= python_version= module= fits=false
    suite_says="not set up"
    if [ -x "$root/usr/bin/blender" ]; then
        fits=true
        version=$(sed -n '/^Package: blender$/,/^$/s/^Version: //p' "$root/var/lib/dpkg/status" | sed 's/^[0-9]*://; s/[+-].*//')
        python_version=$(readlink "$root/usr/bin/python3" | sed 's/.*python//')
        suite_says="set up; its module is built when it is used"
        for file in "$cache/$1/work-$(short_hash "$project")"/release/_native.*.so; do
            [ ! -e "$file" ] || module=$file suite_says="set up; its module is built"
        done
        eval "ready_$1=yes"
    fi
    add_blender "$1" "$root/usr/bin/blender" "$version" "$python_version" "$fits" "$module" "Debian $1, $suite_says"
}

# What `fovea draw` would use, or the remedy where it would use none.
choose_as_draw_does() {
    [ -z "$uses" ] && [ -z "${BLENDER:-}" ] || return 0
    if [ -n "${ready_sid:-}" ]; then
        uses=sid uses_name="Debian sid"
    elif [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
        uses=setup uses_name="a Debian sid that it sets up first (some minutes, 2.5 GB)"
    else
        remedy="install Blender 4.2 or later and make its module with 'blender_scripts/fovea standalone'; or, on Debian, run 'blender_scripts/fovea draw' once as root, which sets up a Blender of its own"
        [ -z "${ready_trixie:-}" ] || remedy="add --on trixie: that suite is set up"
    fi
}

look_at_modules() {
    for file in "$modules_folder"/*/_native.*; do
        [ -e "$file" ] || continue
        used=false
        case "${taken-}" in *" $file "*) used=true ;; esac
        name=${file%/*}
        modules="$modules${name##*/}	$file	$used
"
    done
}

# Asks for OpenGL as a render in the background would get it, with the Python of what is used.
look_at_gpu() {
    probe=$project/addon/render/gl_probe.py
    case $uses in
    '' | setup) return 0 ;;
    sid) probed=$(in_suite sid "$cache/sid/work-$(short_hash "$project")" /usr/bin/python3 -I "$probe" --kind 2>/dev/null) || return 0 ;;
    *) probed=$("$uses_python" -I "$probe" --kind 2>/dev/null) || return 0 ;;
    esac
    renderer=${probed#* }
    [ "${probed%% *}" != hardware ] || hardware=true
}

# add_blender WHERE PROGRAM VERSION PYTHON FITS MODULE SENTENCE
add_blender() {
    blenders="$blenders$(printf '%s\t' "$1" "$2" "${3:--}" "${4:--}" "$5" "${6:--}")$7
"
}

# each_line VARIABLE COMMAND: calls a command with the cells of each line.
each_line() {
    printf %s "$1" | while IFS='	' read -r a b c d e f g; do "$2" "$a" "$b" "$c" "$d" "$e" "$f" "$g"; done
}

tell_text() {
    echo "Blenders:"
    each_line "$blenders" tell_blender
    echo "Self-contained modules in $modules_folder:"
    [ -n "$modules" ] || echo "  none; 'blender_scripts/fovea standalone' makes that for this machine"
    each_line "$modules" tell_module
    if [ "$hardware" = true ]; then
        echo "GPU: possible, by $renderer"
    elif [ -n "$renderer" ]; then
        echo "GPU: possible, but in software ($renderer): pictures are drawn by the cpu unless the scene says otherwise"
    else
        echo "GPU: not possible in the background here, or not known yet: pictures are drawn by the cpu"
    fi
    [ -z "$uses" ] || echo "fovea draw uses $uses_name"
    [ -n "$uses" ] || echo "fovea draw cannot draw; remedy: $remedy"
}

tell_blender() {
    told_version=
    [ "$3" = - ] || told_version="Blender $3, "
    [ "$4" = - ] || told_version="${told_version}Python $4, "
    case $1 in
    sid | trixie) printf '  %-8s  %s%s\n' "$1" "$told_version" "$7" ;;
    *) printf '  %-8s  %s: %s%s\n' "$1" "$2" "$told_version" "$7" ;;
    esac
}

tell_module() {
    [ "$3" = true ] && used="taken by a Blender above" || used="no Blender above takes it"
    printf '  %s: for Python %s; %s\n' "$1" "$(printf %s "$1" | sed 's/.*cp\([0-9]\)/\1./')" "$used"
}

tell_json() {
    printf '{"blenders": ['
    each_line "$blenders" json_blender | paste -s -d , - | tr -d '\n'
    printf '],\n "modules": ['
    each_line "$modules" json_module | paste -s -d , - | tr -d '\n'
    [ -n "$renderer" ] && possible=true || possible=false
    printf '],\n "gpu": {"possible": %s, "hardware": %s, "renderer": %s},\n' "$possible" "$hardware" "$(quoted "$renderer")"
    printf ' "draw": {"uses": %s, "remedy": %s}}\n' "$(quoted "$uses")" "$(quoted "$remedy")"
}

json_blender() {
    printf '{"where": %s, "program": %s, "version": %s, "python": %s, "fits": %s, "module": %s, "says": %s}\n' \
        "$(quoted "$1")" "$(quoted "$2")" "$(quoted "$3")" "$(quoted "$4")" "$5" "$(quoted "$6")" "$(quoted "$7")"
}

json_module() {
    printf '{"for": %s, "file": %s, "taken": %s}\n' "$(quoted "$1")" "$(quoted "$2")" "$3"
}

# quoted TEXT: as JSON; what is not known is null.
quoted() {
    case $1 in
    '' | -) printf null ;;
    *) printf '"%s"' "$(printf %s "$1" | tr '\n\t' '  ' | sed 's/[\\"]/\\&/g')" ;;
    esac
}
