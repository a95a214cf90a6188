#include "solve/HugePages.h"

#include <cstdlib>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace fbrdf {
namespace {

constexpr size_t kHugePage = size_t{2} << 20;
constexpr size_t kWorthwhile = 2 * kHugePage;  // half a huge page is lost on average

}  // namespace

void* allocatePages(size_t bytes)
{
    if (bytes < kWorthwhile) return ::operator new(bytes);
    const size_t whole = (bytes + kHugePage - 1) / kHugePage * kHugePage;
    void* pages = std::aligned_alloc(kHugePage, whole);
    if (!pages) throw std::bad_alloc();
#ifdef __linux__
    madvise(pages, whole, MADV_HUGEPAGE);  // advice: without it the pages are small
#endif
    return pages;
}

void freePages(void* pages, size_t bytes)
{
    if (bytes < kWorthwhile)
        ::operator delete(pages);
    else
        std::free(pages);
}

}  // namespace fbrdf
