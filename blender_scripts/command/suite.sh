# SPDX-License-Identifier: GPL-3.0-or-later
# A Debian suite as a folder in the cache: CACHE/SUITE/root. Created once by debootstrap (signatures verified with the
# archive's keyring) from the mirror that the machine's apt uses; later calls and other clones recognize it by stamps.

host_settings=/etc/apt/apt.conf.d/90host # in a suite, while packages are installed

# set_up_suite SUITE [PACKAGE...]: sets a suite up with the packages of packages.txt, or adds the given packages to it.
# Returns at once if nothing is to be done, and resumes an interrupted call.
set_up_suite() {
    suite=$1
    shift
    packages_are=${*:-Blender, compiler and libraries}
    [ $# -gt 0 ] || set -- $(package_names)
    suite_folder=$cache/$suite
    root=$suite_folder/root
    stamp=$suite_folder/installed/$(printf '%s\n' "$@" | sha256sum | cut -c 1-16)
    # Earlier versions stored what now is seen only while packages are installed.
    [ ! -s "$root$host_settings" ] || truncate -s 0 "$root$host_settings" || true
    [ ! -e "$stamp" ] || return 0
    [ "$(id -u)" = 0 ] || {
        say "setting up Debian $suite needs root: run this once as root, or give a fitting Blender by BLENDER="
        return 1
    }
    mkdir -p "$suite_folder/installed"
    exec 9>"$suite_folder/lock"
    flock -n 9 || {
        say "another call is setting up Debian $suite; waiting for it"
        flock 9
    }
    set_up_status=0
    [ -e "$stamp" ] || make_suite "$@" || set_up_status=$?
    exec 9>&-
    [ "$set_up_status" -eq 0 ] || say "Debian $suite could not be set up; the next call goes on from here"
    return "$set_up_status"
}

# make_suite PACKAGE...
make_suite() {
    find_host_tools || return
    if [ ! -d "$root" ]; then
        say "setting up Debian $suite in $suite_folder (once: some minutes, 2.5 GB)"
        find_mirror || return
        find_keyring || return
        step "$cache/log/$suite-base.log" "$suite: base system" make_base || return
    fi
    step "$cache/log/$suite-packages.log" "$suite: $packages_are" install_packages "$@" || return
    sync
    touch "$stamp"
    say "Debian $suite is ready"
}

package_names() {
    sed 's/#.*//' "$here/packages.txt" | tr -s ' \n' '\n' | sed '/^$/d'
}

# Both suites may be set up at once: one of them installs, the other waits.
find_host_tools() {
    exec 8>"$cache/host-lock"
    flock 8
    missing=
    command -v debootstrap >/dev/null || missing="$missing debootstrap"
    command -v bwrap >/dev/null || missing="$missing bubblewrap"
    [ -n "$(keyring)" ] || missing="$missing debian-archive-keyring"
    host_status=0
    [ -z "$missing" ] ||
        step "$cache/log/host-tools.log" "this machine: installing$missing" install_on_host $missing 8>&- ||
        host_status=$?
    exec 8>&-
    return "$host_status"
}

# New machines have no package lists yet.
install_on_host() {
    install_now "$@" || { apt-get update && install_now "$@"; }
}

# Waits while another program of this machine, such as its own updates, installs.
install_now() {
    DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 install -y --no-install-recommends "$@"
}

keyring() {
    for file in /usr/share/keyrings/debian-archive-keyring.gpg /usr/share/keyrings/debian-archive-keyring.pgp; do
        [ ! -e "$file" ] || { echo "$file" && return; }
    done
}

find_keyring() {
    archive_keyring=$(keyring)
    [ -n "$archive_keyring" ] || { say "the Debian archive's keyring was not found" && return 1; }
}

# Finds the mirror from which this machine installs Debian packages.
find_mirror() {
    mirror=$(mirror_of_host)
    [ -n "$mirror" ] || {
        step "$cache/log/host-lists.log" "this machine: package lists" apt-get update || return
        mirror=$(mirror_of_host)
    }
    [ -n "$mirror" ] || { say "this machine's apt names no Debian archive to install from" && return 1; }
}

mirror_of_host() {
    apt-get indextargets --format '$(LABEL) $(REPO_URI)' | sed -n 's/^Debian //p' | head -n 1
}

# Runs debootstrap as a child of bubblewrap, so that its mounts and processes end with their namespaces.
# The folder is mounted at /mnt, because debootstrap does not support spaces in paths.
make_base() {
    rm -rf "$root.partial"
    mkdir -p "$suite_folder/archives"
    bwrap --dev-bind / / --proc /proc --dev-bind "$suite_folder" /mnt --unshare-pid --die-with-parent \
        debootstrap --variant=minbase --keyring="$archive_keyring" --cache-dir=/mnt/archives \
        "$suite" /mnt/root.partial "$mirror" || { why_debootstrap_failed; return 1; }
    # dpkg without fsync after every file: three times as fast, and a suite lost in a power failure is created again.
    echo force-unsafe-io >"$root.partial/etc/dpkg/dpkg.cfg.d/unsafe-io"
    ln -sfn /proc/self/mounts "$root.partial/etc/mtab"
    mv "$root.partial" "$root"
    rm -rf "$suite_folder/archives"
}

why_debootstrap_failed() {
    [ ! -e "$root.partial/debootstrap/debootstrap.log" ] || tail -n 10 "$root.partial/debootstrap/debootstrap.log"
}

install_packages() {
    in_root apt-get update &&
        in_root dpkg --configure -a &&
        in_root apt-get -y --fix-broken install &&
        in_root apt-get -y --no-install-recommends install "$@" &&
        in_root apt-get clean
}

# Prints this machine's settings for reaching the archive: proxies, how often and how long it is tried, and whether its
# age is checked, as that of a frozen mirror cannot be. Checks of who signed it or serves it stay on, whatever this
# machine has.
reaching_settings() {
    apt-config dump | grep -E '^Acquire::(https?::(Proxy(::[^ ]+)?|Timeout)|Retries|Check-(Date|Valid-Until)) "' || true
}

# in_root COMMAND...: runs a command as root of the suite, with its system writable. The settings, which may have
# passwords, are seen by the command alone, and stored nowhere in the suite.
in_root() {
    reaching_settings | bwrap --bind "$root" / --ro-bind-data 0 "$host_settings" --dev /dev --proc /proc --tmpfs /tmp --tmpfs /run --unshare-pid --die-with-parent --clearenv \
        --setenv PATH /usr/sbin:/usr/bin:/sbin:/bin --setenv LC_ALL C.UTF-8 --setenv DEBIAN_FRONTEND noninteractive \
        --ro-bind-try /etc/resolv.conf /etc/resolv.conf --ro-bind-try /etc/hosts /etc/hosts --chdir / "$@"
}
