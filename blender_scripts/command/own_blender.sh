# SPDX-License-Identifier: GPL-3.0-or-later
# The user's own Blender: queries its version and Python, and checks the prerequisites for building the module.

# use_own_blender PATH: sets target_name, blender, python and python_include, or `reason` and returns 1.
use_own_blender() {
    blender=$1
    [ -x "$blender" ] && [ ! -d "$blender" ] || { reason="$blender is no program" && return 1; }
    version=$("$blender" --version 2>/dev/null | sed -n 's/^Blender \([0-9][0-9.]*\).*/\1/p' | head -n 1)
    is_new_enough "$version" || {
        reason="$blender is ${version:+Blender }${version:-no Blender}, and Fovea needs Blender 4.2 or later"
        return 1
    }
    ask_for_python || { reason="$blender (Blender $version) does not say which Python it runs" && return 1; }
    missing=$(missing_parts)
    [ -z "$missing" ] || {
        reason="Fovea's module cannot be built for $blender (Blender $version, Python $python_version), missing: $missing"
        return 1
    }
    target_name=own-$version-$(short_hash "$(readlink -f "$blender") $version")
}

is_new_enough() {
    major=${1%%.*}
    minor=${1#*.}
    minor=${minor%%.*}
    [ -n "$1" ] && { [ "$major" -gt 4 ] || { [ "$major" -eq 4 ] && [ "$minor" -ge 2 ]; }; }
}

ask_for_python() {
    question='import sys, sysconfig
print("python", *sys.version_info[:2], sys.executable, sysconfig.get_path("include"), sep="|")'
    answer=$(HOME=$cache "$blender" -b --factory-startup --python-expr "$question" 2>/dev/null | grep '^python|') || return
    python_version=$(echo "$answer" | cut -d '|' -f 2,3 | tr '|' .)
    python=$(echo "$answer" | cut -d '|' -f 4)
    python_include=
    for folder in "$(echo "$answer" | cut -d '|' -f 5)" "/usr/include/python$python_version" \
        "/usr/local/include/python$python_version"; do
        [ -n "$python_include" ] || [ ! -e "$folder/Python.h" ] || python_include=$folder
    done
}

# Prints the missing prerequisites for building a module for that Blender, with their Debian packages.
missing_parts() {
    {
        [ -x "$python" ] || echo "Blender's Python program"
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
