// SPDX-License-Identifier: Apache-2.0
// Memory for one thing after the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace ddt {

/// Memory that is taken piece by piece, and given back all at once to be taken for something else.
/// Of one thread's use.
class Arena {
public:
    /// So many bytes, on a cache line of their own, until clear(). What stands there is open.
    void* take(size_t bytes) {
        bytes = (bytes + line - 1) / line * line;
        m_taken += bytes;
        if (bytes <= m_size - m_used) {
            m_used += bytes;
            return on_line(m_block.get()) + (m_used - bytes);
        }
        m_more.push_back(block_of(bytes));
        return on_line(m_more.back().get());
    }

    /// Nothing that was taken is in use any more. What the block had no room for it has room for
    /// from now on.
    void clear() {
        const size_t needed = m_more.empty() ? 0 : m_taken;
        m_more.clear();
        m_used = m_taken = 0;
        reserve(needed);
    }

    /// Have room for so many bytes in one block; while nothing is taken.
    void reserve(size_t bytes) {
        if (apart || bytes <= m_size)
            return;
        m_block.reset();
        m_size = 0;
        m_block = block_of(bytes);
        m_size = bytes;
    }

    /// Those that it has.
    size_t bytes() const { return m_size; }

    /// Pieces are rounded up to this many bytes.
    static constexpr size_t line = 64;
    /// Where it is watched who writes past the end of what, pieces do not follow one another, and
    /// there is no block.
#ifdef DDT_ADDRESS_SANITIZER
    static constexpr bool apart = true;
#else
    static constexpr bool apart = false;
#endif

private:
    using Block = std::unique_ptr<char[]>;

    static Block block_of(size_t bytes) {
        return Block(new char[bytes + line - 1]);
    }
    static char* on_line(char* p) {
        return p + (line - reinterpret_cast<uintptr_t>(p) % line) % line;
    }

    Block m_block;
    size_t m_size = 0, m_used = 0; ///< of the block
    size_t m_taken = 0;            ///< since clear()
    std::vector<Block> m_more;     ///< for what it has no room for
};

/// An allocator of an arena, or, without one, of the heap, whose vectors leave new numbers as they
/// are. Before Arena::clear() the vector is to be given up, or left to be assigned to.
template <class T>
struct ArenaAllocator {
    using value_type = T;
    using propagate_on_container_copy_assignment = std::true_type;
    using propagate_on_container_move_assignment = std::true_type;
    using propagate_on_container_swap = std::true_type;

    Arena* arena = nullptr;

    ArenaAllocator(Arena* arena_ = nullptr) : arena(arena_) {}
    template <class U>
    ArenaAllocator(const ArenaAllocator<U>& other) : arena(other.arena) {}

    T* allocate(size_t n) {
        static_assert(std::is_trivial_v<T> && alignof(T) <= Arena::line, "numbers");
        return static_cast<T*>(arena ? arena->take(n * sizeof(T)) : ::operator new(n * sizeof(T)));
    }
    void deallocate(T* p, size_t) {
        if (!arena)
            ::operator delete(p);
    }
    template <class U>
    void construct(U* p) {
        ::new (static_cast<void*>(p)) U;
    }
    friend bool operator==(ArenaAllocator a, ArenaAllocator b) { return a.arena == b.arena; }
    friend bool operator!=(ArenaAllocator a, ArenaAllocator b) { return a.arena != b.arena; }
};

template <class T>
using ArenaVector = std::vector<T, ArenaAllocator<T>>;

/// Add n numbers to the end.
template <class T>
void append(ArenaVector<T>& to, const T* numbers, size_t n) {
    const size_t before = to.size();
    to.resize(before + n);
    std::copy_n(numbers, n, to.data() + before);
}

} // namespace ddt
