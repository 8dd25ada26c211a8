// SPDX-License-Identifier: GPL-3.0-or-later
// Draws inputs until its time is over, or those of a file. What ends it says so: a sanitizer's report, a rule that is
// broken, or too much time for one input; the input that it happened to is the last one in its state file.
//
//     fovea_fuzz run KIND FIRST STEP SECONDS STATE     inputs FIRST, FIRST + STEP, ...
//     fovea_fuzz repeat FILE                           a line for each input; what follows # is a remark
//     fovea_fuzz tell FILE                             what they consist of
#include <chrono>
#include <csignal>
#include <ctime>
#include <fstream>
#include <iostream>
#include <set>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

#include <fovea/base/sanitizers.h>
#include <fovea/base/threads.h>

#include "fuzz.h"
#include "rules.h"

#ifdef FOVEA_ADDRESS_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

namespace {

using namespace fovea::fuzz;

#ifdef FOVEA_ADDRESS_SANITIZER
constexpr int most_seconds = 30;  // of the processor, for one input: what takes one second takes about ten here
#else
constexpr int most_seconds = 10;
#endif
constexpr double slow_seconds = 1.0;
constexpr int most_waiting = 120;  // seconds for one input that waits for what never comes

void too_long(int signal) {
    const char* sentence = signal == SIGALRM ? "\nHANGS: it waits\n" : "\nHANGS: it takes too long\n";
    [[maybe_unused]] const auto written = write(2, sentence, std::char_traits<char>::length(sentence));
#ifdef FOVEA_ADDRESS_SANITIZER
    __sanitizer_print_stack_trace();
#endif
    _exit(3);
}

void limit_time() {
    const itimerval limit{{0, 0}, {most_seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    alarm(most_waiting);
}

/// Whether no rule was broken.
bool holds(const Input& input, std::string& message) {
    limit_time();
    const auto begin = std::clock();
    try {
        message = run(input);
        const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
        if (seconds > slow_seconds)
            std::cout << "SLOW: " << input.text() << ": " << seconds << " s" << '\n' << std::flush;
        return true;
    } catch (const std::exception& problem) {
        std::cout << "BROKEN: " << input.text() << ": " << typeid(problem).name() << ": " << problem.what() << '\n'
                  << std::flush;
        return false;
    }
}

int run_many(const Input& first, std::uint64_t step, double seconds, const char* state) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    std::set<std::string> told;
    std::ofstream now(state);
    std::uint64_t count = 0;
    for (Input input = first; Clock::now() < end; input.seed += step, ++count) {
        now.seekp(0);
        now << input.text() << " " << count << "          " << '\n' << std::flush;
        std::string message;
        if (!holds(input, message)) return 1;
        if (!message.empty() && told.insert(kind_of_sentence(message)).second)
            std::cout << "REFUSED: " << input.text() << ": " << message << '\n' << std::flush;
    }
    std::cout << "DRAWN: " << count << '\n' << std::flush;
    return 0;
}

std::vector<Input> inputs_of(const char* file) {
    std::ifstream lines(file);
    std::vector<Input> inputs;
    for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find('#'));
        if (!line.empty()) inputs.push_back(Input::read(line));
    }
    return inputs;
}

int repeat(const char* file) {
    bool all = true;
    for (const Input& input : inputs_of(file)) {
        std::cout << input.text() << '\n' << std::flush;
        std::string message;
        if (holds(input, message))
            std::cout << (message.empty() ? "drawn" : "refused: " + message) << '\n' << std::flush;
        else
            all = false;
    }
    return all ? 0 : 1;
}

int tell(const char* file) {
    for (const Input& input : inputs_of(file))
        std::cout << input.text() << ": " << description(input) << '\n' << std::flush;
    return 0;
}

}  // namespace

int main(int count, char** words) {
    std::signal(SIGPROF, too_long);
    std::signal(SIGALRM, too_long);
    fovea::base::limit_threads(1);
    const std::string command = count > 1 ? words[1] : "";
    if (command == "run" && count == 7)
        return run_many(Input::read(words[2] + std::string(" ") + words[3]), std::stoull(words[4]), std::stod(words[5]),
                        words[6]);
    if (command == "repeat" && count == 3) return repeat(words[2]);
    if (command == "tell" && count == 3) return tell(words[2]);
    std::cerr << "fovea_fuzz: run KIND FIRST STEP SECONDS STATE, repeat FILE, or tell FILE\n";
    return 2;
}
