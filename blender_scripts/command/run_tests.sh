# SPDX-License-Identifier: GPL-3.0-or-later
# `fovea test`: on both suites side by side, or on the one target that was chosen.

test_targets() {
    trap 'stop_children; interrupt' INT TERM
    passed=0 failed=0 skipped=0 broken= failures=
    if [ "${1:-}" = --long ]; then
        shift
        test_long "$@"
    elif [ "${1:-}" = windows ]; then
        shift
        test_windows "$@"
    elif [ -n "$on${BLENDER:-}" ]; then
        choose_target "$on" || exit 1
        test_target none "$(getconf _NPROCESSORS_ONLN)" "$@" || status=$?
        add_counts
    else
        test_suites "$@"
    fi
    [ -z "$failures" ] || printf '%s' "$failures"
    [ -z "$broken" ] || say "!!! NOT TESTED, because it could not be set up:$broken (the reason stands above) !!!"
    echo "$passed passed, $failed failed, $skipped skipped"
    [ "$failed" -eq 0 ]
}

farm_packages="slurm-wlm munge nodejs" # of tests/long

# Runs what takes longer than all other tests: on the suite with a fixed compiler and clang-tidy the native tests as they
# are, those that take long with sanitizers, those of threads under the thread sanitizer, runs that are killed in a loop,
# also by Slurm, random inputs and the lint of all C++ files, which count as one test each; on both suites Blender's tests
# with the self-contained module; and what is built for Windows.
test_long() {
    [ $# -eq 0 ] || fail "test --long takes no other words, and not '$1'"
    [ -z "$on" ] || fail "test --long takes no --on: it runs on Debian trixie, and partly on sid"
    use_suite sid || exit 1 # its Python's headers are needed
    make_modules linux-x64-cp313 linux-x64-cp314 || fail "the self-contained modules could not be built"
    for run in "trixie native" "trixie long_sanitize" "sid standalone" "trixie standalone" "trixie threads" "trixie kills"; do
        use_suite "${run% *}" || exit 1
        [ "$run" != "trixie kills" ] || set_up_suite trixie $farm_packages || exit 1
        test_target none "$(getconf _NPROCESSORS_ONLN)" "${run#* }" || status=$?
        add_counts
    done
    test_windows
    (use_suite trixie && set_up_sanitizers && run_command fuzz --minutes 10) && passed=$((passed + 1)) ||
        failed=$((failed + 1))
    (check_on trixie --tidy native tests/native) && passed=$((passed + 1)) || failed=$((failed + 1))
}

# Builds for Windows, and runs it by this machine's Wine.
test_windows() {
    [ -z "$on" ] || fail "test windows takes no --on: it runs what is built for Windows by this machine's Wine"
    target_name=standalone
    rm -f "$(counts_file)"
    run_child python3 -B "$here/standalone/main.py" "$cache" --wine "$@" || status=$?
    add_counts
}

make_modules() {
    run_child python3 -B "$here/standalone/main.py" "$cache" "$@"
}

# Tests both suites in parallel. If the package archive of one is broken, the other is still tested.
test_suites() {
    for suite in $all_suites; do
        (use_suite "$suite") &
        eval "child_$suite=$!"
    done
    ready=
    for suite in $all_suites; do
        wait_for "$suite" && ready="$ready $suite" || broken="$broken $suite"
    done
    [ -n "$ready" ] || fail "neither suite could be set up"
    # Native tests run as they are on the first suite, and under sanitizers on the last, whose sanitizers see more: that
    # comes last there, and takes what the rest leaves of all cores.
    for suite in $ready; do
        without=sanitize parts_at_once=1
        [ "$suite" != "${ready##* }" ] || without=native parts_at_once=2
        [ "$suite" != "${ready# }" ] || without=none
        (use_suite "$suite" && test_target "$without" "$parts_at_once" "$@") &
        eval "child_$suite=$!"
    done
    for suite in $ready; do
        wait_for "$suite" || true
        target_name=$suite
        add_counts
    done
}

wait_for() {
    eval "wait \$child_$1"
}

stop_children() {
    for suite in $all_suites; do
        eval "kill \${child_$suite:-} 2>/dev/null" || true
    done
}

# Installs in the chosen target, if it is the suite whose sanitizers are Clang's, what they need (sanitizers.py).
set_up_sanitizers() {
    [ "$target_name" != trixie ] || set_up_suite trixie clang-19 libclang-rt-19-dev llvm-19
}

# test_target WITHOUT JOBS [PART] WORDS...: tests the chosen target, but for the part WITHOUT (none: all of it), or PART
# alone; the counts are written to a file.
test_target() {
    left_out=$1
    jobs=$2
    shift 2
    rm -f "$(counts_file)"
    set_up_sanitizers || return
    run_command test --without "$left_out" --jobs "$jobs" "$@"
}

counts_file() {
    echo "$(work_folder)/results/counts"
}

# Adds up a target's counts; one without counts (it did not build, or crashed) is a failure.
add_counts() {
    if [ -e "$(counts_file)" ]; then
        read -r more_passed more_failed more_skipped <"$(counts_file)"
    else
        say "$target_name: the tests did not run to their end"
        more_passed=0 more_failed=1 more_skipped=0
    fi
    told="$(work_folder)/results/failures"
    [ ! -e "$told" ] || failures="$failures$(cat "$told")
"
    passed=$((passed + more_passed)) failed=$((failed + more_failed)) skipped=$((skipped + more_skipped))
}
