// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops over index ranges, and sorting (oneTBB). Results never depend on the number of threads: bodies write
// only to their own elements, sums and appended output are collected per fixed block and joined in block order, and
// sort orders are total.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_group.h>
#include <utility>
#include <vector>

#include <fovea/base/cancel.h>
#include <fovea/base/fork_join.h>
#include <fovea/base/threads.h>
#include <fovea/base/types.h>

namespace fovea::base {

/// Calls call(body, begin, end) for ranges that make up [0, count), of at least half of `grain`. Compiled once for all
/// loops. It is done as a whole or throws what a call has thrown, even within a task beside which another one throws:
/// there oneTBB would end it early, as if it were done.
void for_ranges(std::size_t count, std::size_t grain, const void* body,
                void (*call)(const void* body, std::size_t begin, std::size_t end));

/// Calls body(i) for every i in [0, count), in blocks of at least half of `grain`. Before each it polls the Cancel of
/// the calling thread's scope, as all loops here do.
template <typename Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    const auto block = [](const void* of, std::size_t begin, std::size_t end) {
        Cancelling::poll();
        for (std::size_t i = begin; i != end; ++i) (*static_cast<const Body*>(of))(i);
    };
    // oneTBB's task for a single block would cost more than most of them.
    if (count <= grain)
        block(&body, 0, count);
    else
        for_ranges(count, grain, &body, block);
}

/// The same, with blocks for bodies of a few operations.
template <typename Body>
void parallel_for(std::size_t count, const Body& body) {
    parallel_for(count, 4096, body);
}

/// make(i) for every i in [0, count); with room for one more, as counts_to_offsets adds.
template <typename T, typename Make>
Array<T> parallel_map(std::size_t count, const Make& make) {
    Array<T> made;
    made.reserve(count + 1);
    made.resize(count);
    parallel_for(count, [&](std::size_t i) { made[i] = make(i); });
    return made;
}

/// `count` times a value: std::vector would fill large ones in one thread, which waits for memory page by page.
template <typename T>
Array<T> parallel_filled(std::size_t count, const T& value) {
    return parallel_map<T>(count, [&](std::size_t) { return value; });
}

/// A copy, in parallel for the same reason.
template <typename T>
Array<T> parallel_copy(const Array<T>& values) {
    return parallel_map<T>(values.size(), [&](std::size_t i) { return values[i]; });
}

/// Calls body(block, begin, end) for consecutive blocks of exactly `size` indices (the last may be shorter). The blocks
/// do not depend on the number of threads, so per-block results joined in block order are deterministic.
template <typename Body>
void parallel_blocks(std::size_t count, std::size_t size, const Body& body) {
    const std::size_t blocks = (count + size - 1) / size;
    parallel_for(blocks, 1, [&](std::size_t b) { body(b, b * size, std::min(count, (b + 1) * size)); });
}

/// Per block of parallel_blocks, the Part that fill(part, begin, end) fills, in block order.
template <typename Part, typename Fill>
std::vector<Part> parallel_parts(std::size_t count, std::size_t size, const Fill& fill) {
    std::vector<Part> parts((count + size - 1) / size);
    parallel_blocks(count, size,
                    [&](std::size_t b, std::size_t begin, std::size_t end) { fill(parts[b], begin, end); });
    return parts;
}

/// Exclusive prefix sum in place: counts become offsets; the array grows by one entry, the total.
template <typename Counts>
void counts_to_offsets(Counts& counts) {
    typename Counts::value_type sum = 0;
    for (auto& c : counts) {
        const auto n = c;
        c = sum;
        sum += n;
    }
    counts.push_back(sum);
}

/// Concatenates, in block order, what body(begin, end, out) appends to `out` for each block.
template <typename T, typename Body>
Array<T> parallel_collect(std::size_t count, std::size_t size, const Body& body) {
    const auto fill = [&](Array<T>& part, std::size_t begin, std::size_t end) { body(begin, end, part); };
    auto parts = parallel_parts<Array<T>>(count, size, fill);
    if (parts.size() == 1) return std::move(parts[0]);
    Array<std::size_t> starts = parallel_map<std::size_t>(parts.size(), [&](std::size_t b) { return parts[b].size(); });
    counts_to_offsets(starts);
    Array<T> all(starts.back());
    const std::size_t copied_at_once = parts.size() * 4096 / (all.size() + 1) + 1;  // parts
    parallel_for(parts.size(), copied_at_once, [&](std::size_t b) {
        std::ranges::move(parts[b], all.begin() + starts[b]);
        Array<T>().swap(parts[b]);
    });
    return all;
}

/// The numbers i of [0, count) for which is(i), ascending.
template <typename Is>
Array<Index> parallel_where(std::size_t count, const Is& is) {
    return parallel_collect<Index>(count, 1 << 14, [&](std::size_t begin, std::size_t end, Array<Index>& found) {
        for (auto i = static_cast<Index>(begin); i < end; ++i)
            if (is(i)) found.push_back(i);
    });
}

/// The values v for which is(v), in order; `size`: of blocks.
template <typename T, typename Is>
Array<T> parallel_filter(const Array<T>& values, std::size_t size, const Is& is) {
    return parallel_collect<T>(values.size(), size, [&](std::size_t begin, std::size_t end, Array<T>& found) {
        std::copy_if(values.begin() + begin, values.begin() + end, std::back_inserter(found), is);
    });
}

/// Number of the elements i of `count` for which is(i).
template <typename Is>
std::size_t parallel_count(std::size_t count, const Is& is) {
    std::size_t all = 0;
    for (const std::size_t part :
         parallel_parts<std::size_t>(count, 1 << 14, [&](std::size_t& sum, std::size_t begin, std::size_t end) {
             for (std::size_t i = begin; i < end; ++i) sum += is(i) ? 1 : 0;
         }))
        all += part;
    return all;
}

/// Calls first() and second(), possibly concurrently.
template <typename First, typename Second>
void parallel_invoke(const First& first, const Second& second) {
    const ForkJoin call;
    const Cancel* const cancel = Cancelling::current();
    const auto run = [&](const auto& body) FOVEA_TBB_HANDS_OVER {
        const ForkJoin::Body here(call);
        const Cancelling scope(cancel);
        body();
    };
    tbb::task_group_context alone(tbb::task_group_context::isolated);  // as for_ranges
    tbb::parallel_invoke([&]() FOVEA_TBB_HANDS_OVER { run(first); }, [&]() FOVEA_TBB_HANDS_OVER { run(second); },
                         alone);
}

/// Sorts by a total order, so that the result is unique.
template <typename Iterator, typename Less = std::less<>>
void parallel_sort(Iterator begin, Iterator end, const Less& less = {}) {
    Cancelling::poll();
#ifdef FOVEA_THREAD_SANITIZER
    std::sort(begin, end, less);  // TSan does not see the synchronization inside oneTBB's sort
#else
    constexpr auto few = 500;  // as for oneTBB
    if (end - begin < few) return std::sort(begin, end, less);
    // Within a loop of its own, so that it is done as a whole, too.
    const auto sort = [&] { tbb::parallel_sort(begin, end, less); };
    for_ranges(1, 1, &sort,
               [](const void* of, std::size_t, std::size_t) { (*static_cast<const decltype(sort)*>(of))(); });
#endif
}

/// The values at the positions i for which kept(i) is true, in order.
template <typename T, typename Kept>
Array<T> values_where(const Array<T>& values, const Kept& kept) {
    Array<T> found;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (kept(i)) found.push_back(values[i]);
    return found;
}

/// Lists of counts[k] indices each, copied from the iterator first(k).
template <typename First>
Lists<Index> lists_from(Array<Index> counts, const First& first) {
    Lists<Index> lists;
    lists.offsets = std::move(counts);
    counts_to_offsets(lists.offsets);
    lists.values.resize(lists.offsets.back());
    parallel_for(lists.count(),
                 [&](std::size_t k) { std::copy_n(first(Index(k)), lists.size(Index(k)), lists[Index(k)].begin()); });
    return lists;
}

/// Builds `count` lists of values. each(give) must call give(list, value) for every value; lists keep that order.
/// `each` must make the same calls whenever it runs: once to count, once to fill.
template <typename T, typename Each>
Lists<T> lists_of(std::size_t count, const Each& each) {
    Lists<T> lists;
    Array<Index>& offsets = lists.offsets;
    offsets.reserve(count + 1);
    offsets.assign(count, 0);
    each([&](std::size_t list, const T&) { ++offsets[list]; });
    counts_to_offsets(offsets);
    lists.values.resize(offsets.back());
    each([&](std::size_t list, const T& value) { lists.values[offsets[list]++] = value; });
    // Where a list ends by now, the next one begins.
    std::copy_backward(offsets.begin(), offsets.begin() + count, offsets.end());
    offsets[0] = 0;
    return lists;
}

/// The same in parallel: each thread makes all calls, and takes those for a range of the lists. For calls that cost
/// little beside the memory of the lists.
template <typename T, typename Each>
Lists<T> lists_of_ranges(std::size_t count, const Each& each) {
    const std::size_t ranges = std::clamp<std::size_t>(count / 4096, 1, std::size_t(std::min(threads_at_hand(), 8)));
    return lists_of<T>(count, [&](const auto& give) {
        parallel_for(ranges, 1, [&](std::size_t k) {
            const std::size_t begin = k * count / ranges, end = (k + 1) * count / ranges;
            each([&](std::size_t list, const T& value) {
                if (begin <= list && list < end) give(list, value);
            });
        });
    });
}

}  // namespace fovea::base
