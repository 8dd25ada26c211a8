# SPDX-License-Identifier: GPL-3.0-or-later
# Messages to the user and the progress of long steps, on stderr; results go to stdout.

say() {
    printf 'fovea: %s\n' "$*" >&2
}

fail() {
    say "$@"
    exit 1
}

# step LOG SENTENCE COMMAND...: runs a long command with its output in LOG and a progress message every 15 seconds;
# if the command fails, shows the end of LOG and returns its status.
step() {
    step_log=$1
    step_sentence=$2
    shift 2
    say "$step_sentence"
    : >"$step_log"
    show_progress "$step_log" "$step_sentence" 9>&- &
    step_watcher=$!
    step_status=0
    "$@" >"$step_log" 2>&1 </dev/null || step_status=$?
    kill "$step_watcher" 2>/dev/null || true
    wait "$step_watcher" 2>/dev/null || true
    if [ "$step_status" -ne 0 ]; then
        say "$step_sentence FAILED; the last lines of $step_log:"
        tail -n 15 "$step_log" | sed 's/^/    /' >&2
    fi
    return "$step_status"
}

show_progress() {
    seconds=0
    # The output of sleep is redirected, so that it does not keep this shell's stdout open after the step has ended.
    while sleep 15 >/dev/null 2>&1 && kill -0 $$ 2>/dev/null; do
        seconds=$((seconds + 15))
        last=$(tail -n 1 "$1" | tr -d '\r' | cut -c 1-70)
        say "  $2 $seconds s: $last"
    done
}
