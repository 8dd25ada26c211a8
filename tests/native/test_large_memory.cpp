// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>

#include <fovea/base/pages.h>
#include <fovea/base/release_memory.h>
#include <fovea/base/types.h>

namespace fovea {
namespace {

using namespace base;

constexpr std::size_t many = 3 * large_memory / sizeof(Index);

TEST(LargeMemory, ArraysKeepTheirValuesAsTheyGrowOutOfTheHeap) {
    Array<Index> values;
    for (Index i = 0; i < many; ++i) values.push_back(i);
    for (Index i = 0; i < many; ++i) ASSERT_EQ(values[i], i);
    values.resize(10);
    values.shrink_to_fit();
    EXPECT_EQ(values, (Array<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(LargeMemory, LargeArraysAreIndependentOfEachOther) {
    Array<Index> first(many, 1), second(many, 2);
    const Array<Index> copy = first;
    first.assign(many, 3);
    EXPECT_EQ(std::ranges::count(copy, 1u), std::ptrdiff_t(many));
    EXPECT_EQ(std::ranges::count(second, 2u), std::ptrdiff_t(many));
    EXPECT_EQ(std::ranges::count(first, 3u), std::ptrdiff_t(many));
}

TEST(LargeMemory, FreedMemoryIsKeptForTheNextArrayUpToABound) {
    if (keeps_large_memory == 0) GTEST_SKIP() << "sanitizers take all memory from the heap";
    const Index* freed = nullptr;
    {
        const Array<Index> values(many, 7);
        freed = values.data();
    }
    const Array<Index> next(many, 8);
    EXPECT_EQ(next.data(), freed);
    for (int k = 0; k < 3; ++k) {
        const Array<char> huge(keeps_large_memory / 2 + 1);
        const Array<char> other(keeps_large_memory / 2 + 1);
    }
    EXPECT_LE(large_memory_kept(), keeps_large_memory);
    EXPECT_GT(large_memory_kept(), keeps_large_memory / 2);
    {
        const Array<char> more_than_is_kept(keeps_large_memory + 1);
    }
    EXPECT_LE(large_memory_kept(), keeps_large_memory);
}

TEST(LargeMemory, ArraysOfManyMegabytesAreMadeOfWhatOthersOfAnySizeLeave) {
    if (keeps_large_memory == 0) GTEST_SKIP() << "sanitizers take all memory from the heap";
    if (!has_pages) GTEST_SKIP() << "this system gives no pages";
    release_large_memory();
    {
        const Array<char> large(24 * page_bytes);
    }
    EXPECT_EQ(large_memory_kept(), 24 * page_bytes);
    const Array<char> first(9 * page_bytes + 5, 1), second(13 * page_bytes, 2);
    EXPECT_EQ(std::ranges::count(first, 1), std::ptrdiff_t(first.size()));
    EXPECT_EQ(std::ranges::count(second, 2), std::ptrdiff_t(second.size()));
    EXPECT_EQ(large_memory_kept(), page_bytes);
}

TEST(LargeMemory, ArraysThatAreRoundedUpToPagesAreKeptAsSuch) {
    if (keeps_large_memory == 0) GTEST_SKIP() << "sanitizers take all memory from the heap";
    if (!has_pages) GTEST_SKIP() << "this system gives no pages";
    release_large_memory();
    {
        const Array<char> values(2 * page_bytes - page_bytes / 8, 1);
        EXPECT_EQ(std::ranges::count(values, 1), std::ptrdiff_t(values.size()));
    }
    EXPECT_EQ(large_memory_kept(), 2 * page_bytes);
}

TEST(LargeMemory, PagesMakeRoomForSmallerBlocksThatWereFreedAfterThem) {
    if (keeps_large_memory == 0) GTEST_SKIP() << "sanitizers take all memory from the heap";
    release_large_memory();
    const Index* freed = nullptr;
    {
        const Array<Index> values(many, 7);
        freed = values.data();
        const Array<char> huge(keeps_large_memory - 2 * page_bytes), other(4 * page_bytes);
    }
    EXPECT_LE(large_memory_kept(), keeps_large_memory);
    const Array<Index> next(many, 8);
    EXPECT_EQ(next.data(), freed);
}

TEST(LargeMemory, KeptMemoryIsReleasedWhenAskedFor) {
    if (keeps_large_memory == 0) GTEST_SKIP() << "sanitizers take all memory from the heap";
    {
        const Array<Index> values(many, 7);
    }
    EXPECT_GT(large_memory_kept(), 0u);
    release_large_memory();
    EXPECT_EQ(large_memory_kept(), 0u);
}

TEST(LargeMemory, AnArrayTooLargeForAnyMemoryThrows) {
    if (keeps_large_memory == 0) GTEST_SKIP() << "the sanitizer of addresses ends the program instead";
    EXPECT_THROW(Array<vec4>(std::size_t(1) << 58), std::exception);
    EXPECT_THROW(allocate_large(~std::size_t(0)), std::bad_alloc);
}

}  // namespace
}  // namespace fovea
