# SPDX-License-Identifier: GPL-3.0-or-later
# The user's own Blender: queries its version and Python; takes the self-contained module that fits, or checks the
# prerequisites for building one.

modules_folder=$cache/standalone/modules # PLATFORM-PYTHON/_native.*, as `fovea standalone` leaves them

# use_own_blender PATH: sets target_name, blender, python, python_include and module (a self-contained module of this
# checkout's sources that loads there, or "": one is built), or `reason` and returns 1.
use_own_blender() {
    blender=$1
    version= python_version= module=
    [ -x "$blender" ] && [ ! -d "$blender" ] || { reason="$blender is no program" && return 1; }
    version=$("$blender" --version 2>/dev/null </dev/null | sed -n 's/^Blender \([0-9][0-9.]*\).*/\1/p' | head -n 1)
    is_new_enough "$version" || {
        reason="$blender is ${version:+Blender }${version:-no Blender}, and Fovea needs Blender 4.2 or later"
        return 1
    }
    ask_blender || { reason="$blender (Blender $version) does not say which Python it runs" && return 1; }
    [ -x "$python" ] || {
        reason="$blender (Blender $version) runs the Python $python, which is no program of this machine: name a Blender that is not packed in a sandbox of its own"
        return 1
    }
    [ -n "$module" ] || missing=$(missing_parts)
    [ -n "$module" ] || [ -z "$missing" ] || { reason=$(why_no_module) && return 1; }
    target_name=own-$version-$(short_hash "$(readlink -f "$blender") $version")
}

is_new_enough() {
    major=${1%%.*}
    minor=${1#*.}
    minor=${minor%%.*}
    [ -n "$1" ] && { [ "$major" -gt 4 ] || { [ "$major" -eq 4 ] && [ "$minor" -ge 2 ]; }; }
}

# Asks a Blender for its Python, and for the self-contained module that it can load. Its HOME is a folder for this alone.
ask_blender() {
    asked_home=$(mktemp -d) || return
    answer=$(HOME=$asked_home "$blender" -b --factory-startup -P "$here/ask_blender.py" -- "$modules_folder" 2>/dev/null </dev/null |
        sed -n 's/^fovea //p') || true
    rm -rf "$asked_home"
    python_version=$(told python)
    python=$(told program)
    module=$(told module)
    python_include=
    for folder in "$(told include)" "/usr/include/python$python_version" "/usr/local/include/python$python_version"; do
        [ -n "$python_include" ] || [ ! -e "$folder/Python.h" ] || python_include=$folder
    done
    [ -n "$python_version" ]
}

# told WORD: what the Blender said of it.
told() {
    printf '%s\n' "$answer" | sed -n "s/^$1 //p" | head -n 1
}

# One sentence: why no self-contained module is used, what is missing to build one, and both remedies.
why_no_module() {
    tried=$(told tried)
    refused=$(told refused)
    if [ -n "$tried" ]; then
        printf '%s' "$tried cannot be used in $blender (Blender $version, Python $python_version: ${refused:-it ends Blender})"
    else
        printf '%s' "there is no self-contained module for $blender (Blender $version, Python $python_version) in $modules_folder/$(told platform)"
    fi
    remedy=$(remedy_of "$(told platform)")
    printf '%s\n' ", and none can be built, missing: $missing; $remedy, or install what is missing"
}

# remedy_of PLATFORM: how its self-contained module is made; official Blenders have one of two Pythons.
remedy_of() {
    case $1 in
    *-cp311 | *-cp313) echo "make it with 'blender_scripts/fovea standalone $1'" ;;
    *) echo "take an official Blender, as self-contained modules are for Python 3.11 and 3.13" ;;
    esac
}

# Prints the missing prerequisites for building a module for that Blender, with their Debian packages.
missing_parts() {
    {
        [ -n "$python_include" ] || echo "the headers of Python $python_version (python$python_version-dev)"
        command -v cmake >/dev/null || echo "CMake (cmake)"
        command -v ninja >/dev/null || echo "Ninja (ninja-build)"
        if command -v g++ >/dev/null; then
            while read -r header name; do
                has_header "$header" || echo "$name"
            done <<END
pybind11/pybind11.h pybind11 (pybind11-dev)
embree4/rtcore.h Embree 4 (libembree-dev)
oneapi/tbb/version.h oneTBB (libtbb-dev)
glm/glm.hpp GLM (libglm-dev)
xxhash.h xxHash (libxxhash-dev)
png.h libpng (libpng-dev)
OpenMesh/Core/System/config.h OpenMesh (libopenmesh-dev)
opensubdiv/version.h OpenSubdiv (libosd-dev)
END
        else
            echo "a C++20 compiler (g++)"
        fi
    } | paste -s -d , - | sed 's/,/, /g'
}

has_header() {
    printf '#if !__has_include(<%s>)\n#error\n#endif\n' "$1" | g++ -std=c++20 -E -x c++ - >/dev/null 2>&1
}
