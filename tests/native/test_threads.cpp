// SPDX-License-Identifier: GPL-3.0-or-later
// What several threads share: how many there may be, what is kept, what is stopped from outside, and whole pictures of
// one scene at once, as a viewport and a render draw them.
#include <atomic>
#include <gtest/gtest.h>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include <fovea/base/cache.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/base/threads.h>
#include <fovea/draw/frame.h>
#include <fovea/style/json.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

/// A sphere and a box, with nothing derived from them yet.
std::shared_ptr<const Scene> shapes() {
    return std::make_shared<Scene>(
        Scene({place(meshes::sphere(24)), place(meshes::box(vec3(-0.8f), vec3(0.8f)), dmat4(1.0), 2)}));
}

Job job_of(std::shared_ptr<const Scene> scene) {
    const char* curves =
        R"({"schema": 1, "elision": {"enabled": true}, "line_sets": [{"least_length": 0, "pen": {"width": 2},
        "kinds": {"contour": {}, "intersection": {}, "suggestive_contour": {}, "ridge": {}, "isophote": {}}}]})";
    return {.scene = std::move(scene),
            .view = perspective({3, -8, 4}, {0, 0, 0}, 50, 120, 90),
            .style = style::read_style(curves),
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>()};
}

Array<vec4> drawn(std::shared_ptr<const Scene> scene) {
    Frame frame(job_of(std::move(scene)));
    frame.picture();
    return std::move(frame.passes.combined);
}

/// Calls body(i) in `count` threads at once.
template <typename Body>
void at_once(int count, const Body& body) {
    std::atomic<int> waiting{count};
    std::vector<std::thread> threads;
    for (int i = 0; i < count; ++i)
        threads.emplace_back([&, i] {
            for (--waiting; waiting > 0;) std::this_thread::yield();
            body(i);
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace

TEST(Threads, NoMoreWorkAtOnceThanAllowed) {
    const int all = thread_limit();
    limit_threads(1);
    EXPECT_EQ(thread_limit(), 1);
    std::atomic<int> now{0}, most{0};
    parallel_blocks(64, 1, [&](auto, std::size_t, std::size_t) {
        const int here = ++now;
        int before = most;
        while (before < here && !most.compare_exchange_weak(before, here)) {
        }
        std::this_thread::yield();
        --now;
    });
    EXPECT_EQ(most, 1);
    limit_threads(3);
    EXPECT_EQ(thread_limit(), 3);
    limit_threads(0);
    EXPECT_EQ(thread_limit(), all);
    EXPECT_THROW(limit_threads(-1), std::invalid_argument);
}

TEST(Threads, FillListsByRangesInTheOrderOfTheCalls) {
    constexpr std::size_t lists = 50'000, calls = 300'000;
    const auto each = [&](const auto& give) {
        for (std::size_t i = 0; i < calls; ++i) give(hash_numbers(i) % lists, int(i));
    };
    const Lists<int> expected = lists_of<int>(lists, each);
    for (const int most : {1, 3, 0}) {
        limit_threads(most);
        const Lists<int> found = lists_of_ranges<int>(lists, each);
        EXPECT_EQ(found.offsets, expected.offsets);
        EXPECT_EQ(found.values, expected.values);
    }
    EXPECT_EQ(lists_of_ranges<int>(0, [](const auto&) {}).count(), 0u);
}

TEST(Threads, HashManyBytesToTheSameNumberHoweverManyTheyAre) {
    Array<char> bytes(2'000'003, 'a');
    const auto hash = [&](std::size_t size) { return hash_many_bytes(bytes.data(), size); };
    const std::uint64_t whole = hash(bytes.size());
    limit_threads(1);
    EXPECT_EQ(hash(bytes.size()), whole);
    limit_threads(0);
    std::set<std::uint64_t> different{whole, hash(0), hash(1), hash(1 << 18), hash(bytes.size() - 1)};
    for (const std::size_t place : {std::size_t(0), bytes.size() / 2, bytes.size() - 1}) {
        bytes[place] = 'b';
        different.insert(hash(bytes.size()));
        bytes[place] = 'a';
    }
    EXPECT_EQ(different.size(), 8u);
}

TEST(Threads, ThatAskACacheAtOnceGetTheSameQuantityWhichIsMadeOnce) {
    Cache cache;
    std::atomic<int> made{0};
    const auto squares = [&] {
        ++made;
        std::vector<int> values(10000);
        parallel_for(values.size(), 16, [&](std::size_t i) { values[i] = int(i * i % 97); });
        return values;
    };
    std::vector<std::shared_ptr<const std::vector<int>>> found(4);
    at_once(4, [&](int i) { found[i] = cache.get<std::vector<int>>(7, squares); });
    EXPECT_EQ(made, 1);
    EXPECT_EQ(found[0]->back(), 9999 * 9999 % 97);
    for (const auto& each : found) EXPECT_EQ(each, found[0]);
}

TEST(Threads, ThatDrawOneSceneAtOnceMakeThePictureOfOneAlone) {
    const Array<vec4> alone = drawn(shapes());
    const auto scene = shapes();
    std::vector<Array<vec4>> pictures(3);
    at_once(3, [&](int i) { pictures[i] = drawn(scene); });
    for (const Array<vec4>& picture : pictures) EXPECT_EQ(picture, alone);
}

TEST(Threads, ALoopEndsWhenAnotherThreadCancelsIt) {
    Cancel cancel;
    std::atomic<bool> begun{false};
    std::thread other([&] {
        while (!begun) std::this_thread::yield();
        cancel.requested = true;
    });
    const auto until_cancelled = [&](std::size_t) {
        for (begun = true;; std::this_thread::yield()) cancel.poll();
    };
    EXPECT_THROW(parallel_for(64, 1, until_cancelled), Cancelled);
    other.join();
}

TEST(Threads, APictureEndsWhenAnotherThreadCancelsIt) {
    Job job = job_of(shapes());
    const auto cancel = std::make_shared<Cancel>();
    std::atomic<bool> begun{false};
    job.cancel = cancel;
    job.progress = [&](double, const std::string&) {
        for (begun = true; !cancel->requested;) std::this_thread::yield();
    };
    Frame frame(std::move(job));
    std::thread other([&] {
        while (!begun) std::this_thread::yield();
        cancel->requested = true;
    });
    EXPECT_THROW(frame.picture(), Cancelled);
    other.join();
}
