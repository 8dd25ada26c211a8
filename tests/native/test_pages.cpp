// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <vector>

#include <fovea/base/pages.h>

namespace fovea {
namespace {

using namespace base;

/// Some pages in a row, which are never touched.
struct Row {
    explicit Row(std::size_t pages) : start(static_cast<std::byte*>(map_pages(pages * page_bytes))) {}
    std::byte* page(std::size_t number) const { return start + number * page_bytes; }
    std::byte* start;
};

TEST(Pages, StartAtPagesOfTheirSizeAndCanBeWritten) {
    if (!has_pages) GTEST_SKIP() << "no pages here";
    void* const start = map_pages(3 * page_bytes);
    ASSERT_TRUE(start);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(start) % page_bytes, 0u);
    std::memset(start, 7, 3 * page_bytes);
    unmap_pages(start, page_bytes);
    EXPECT_EQ(static_cast<const char*>(start)[3 * page_bytes - 1], 7);
    unmap_pages(static_cast<std::byte*>(start) + page_bytes, 2 * page_bytes);
}

TEST(Pages, ThatAreFreeServeOneRangeAfterAnotherAndJoinAgain) {
    if (!has_pages) GTEST_SKIP() << "no pages here";
    const Row row(6);
    FreePages free;
    free.give(row.page(0), 6 * page_bytes, 1);
    EXPECT_EQ(free.take(2 * page_bytes), row.page(0));
    EXPECT_EQ(free.take(page_bytes), row.page(2));
    EXPECT_EQ(free.take(3 * page_bytes), row.page(3));
    EXPECT_EQ(free.take(page_bytes), nullptr);
    free.give(row.page(2), page_bytes, 2);
    free.give(row.page(0), 2 * page_bytes, 3);
    EXPECT_EQ(free.take(4 * page_bytes), nullptr);
    free.give(row.page(3), 3 * page_bytes, 4);
    EXPECT_EQ(free.take(6 * page_bytes), row.page(0));
    unmap_pages(row.start, 6 * page_bytes);
}

TEST(Pages, AreOfTheSmallestRangeThatIsLargeEnough) {
    if (!has_pages) GTEST_SKIP() << "no pages here";
    const Row row(8);
    FreePages free;
    free.give(row.page(0), 3 * page_bytes, 1);
    free.give(row.page(4), page_bytes, 2);
    free.give(row.page(6), 2 * page_bytes, 3);
    EXPECT_EQ(free.take(2 * page_bytes), row.page(6));
    EXPECT_EQ(free.take(page_bytes), row.page(4));
    EXPECT_EQ(free.take(2 * page_bytes), row.page(0));
    unmap_pages(row.start, 8 * page_bytes);
}

TEST(Pages, OfTheRangeThatWasGivenFirstAreUnmappedFirst) {
    if (!has_pages) GTEST_SKIP() << "no pages here";
    const Row row(7);
    FreePages free;
    EXPECT_EQ(free.oldest(), UINT64_MAX);
    free.give(row.page(0), 2 * page_bytes, 1);
    free.give(row.page(3), 2 * page_bytes, 2);
    free.give(row.page(2), page_bytes, 3);  // joins both
    free.give(row.page(6), page_bytes, 4);
    EXPECT_EQ(free.oldest(), 1u);
    EXPECT_EQ(free.unmap_oldest(2 * page_bytes), 2 * page_bytes);
    EXPECT_EQ(free.take(3 * page_bytes), row.page(0));
    free.give(row.page(0), 3 * page_bytes, 5);
    EXPECT_EQ(free.unmap_oldest(8 * page_bytes), page_bytes);
    EXPECT_EQ(free.oldest(), 5u);
    EXPECT_EQ(free.unmap_oldest(8 * page_bytes), 3 * page_bytes);
    EXPECT_EQ(free.oldest(), UINT64_MAX);
    unmap_pages(row.page(5), page_bytes);
}

}  // namespace
}  // namespace fovea
