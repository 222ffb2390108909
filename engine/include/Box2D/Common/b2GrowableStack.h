// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <cstring>
#include <type_traits>

/// @file
/// A stack for tree traversal.

/// A stack of plain values. The first N are stored inside the object, more on the heap. Tree
/// traversal uses it to avoid recursion and allocation.
template <typename T, int32 N>
class b2GrowableStack
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    b2GrowableStack() = default;
    ~b2GrowableStack()
    {
        if (m_stack != m_array)
        {
            b2Free(m_stack);
        }
    }
    b2GrowableStack(const b2GrowableStack&) = delete;
    b2GrowableStack& operator=(const b2GrowableStack&) = delete;

    /// Pushes an element; grows the storage if needed.
    void Push(const T& element)
    {
        if (m_count == m_capacity)
        {
            Grow();
        }
        m_stack[m_count++] = element;
    }

    /// Pushes an element if the condition holds, without a branch, for unpredictable conditions.
    void PushIf(bool condition, const T& element)
    {
        if (m_count == m_capacity)
        {
            Grow();
        }
        m_stack[m_count] = element;
        m_count += condition ? 1 : 0;
    }

    /// Removes and returns the top element; the stack must not be empty.
    T Pop()
    {
        b2Assert(m_count > 0);
        return m_stack[--m_count];
    }

    int32 GetCount() const { return m_count; } ///< number of elements

private:
    void Grow()
    {
        T* larger = static_cast<T*>(b2Alloc(2 * m_capacity * static_cast<int32>(sizeof(T))));
        std::memcpy(larger, m_stack, static_cast<std::size_t>(m_count) * sizeof(T));
        if (m_stack != m_array)
        {
            b2Free(m_stack);
        }
        m_stack = larger;
        m_capacity *= 2;
    }

    T m_array[N];
    T* m_stack = m_array;
    int32 m_count = 0;
    int32 m_capacity = N;
};
