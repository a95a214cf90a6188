// HugePages.h - memory for arrays of many megabytes, in pages of two megabytes where the system has
// them: hundreds of page faults fewer for each, which take longer than a pass over the array.
#pragma once
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace fbrdf {

/// `bytes` of any value. Throws std::bad_alloc. Given back by freePages with the same size.
void* allocatePages(size_t bytes);
void freePages(void* pages, size_t bytes);

/// An allocator that leaves numbers without an initial value: resize() touches no memory.
template <class T>
struct HugePages {
    using value_type = T;

    HugePages() = default;
    template <class U>
    HugePages(const HugePages<U>&)
    {
    }
    T* allocate(size_t count) { return static_cast<T*>(allocatePages(count * sizeof(T))); }
    void deallocate(T* pages, size_t count) { freePages(pages, count * sizeof(T)); }
    template <class U>
    void construct(U* at)
    {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Args>
    void construct(U* at, Args&&... args)
    {
        ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
    }
};

template <class T, class U>
bool operator==(const HugePages<T>&, const HugePages<U>&)
{
    return true;
}
template <class T, class U>
bool operator!=(const HugePages<T>&, const HugePages<U>&)
{
    return false;
}

/// The numbers of normal equations.
using SystemNumbers = std::vector<double, HugePages<double>>;

}  // namespace fbrdf
