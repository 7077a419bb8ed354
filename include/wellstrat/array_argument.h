// SPDX-License-Identifier: Apache-2.0
//
// An array that a function is given, by a pointer, as an array, or as a container.

#pragma once

#include "wellstrat/platform.h"

#include <cstddef>
#include <type_traits>
#include <utility>

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// Says in one line that an array is too small, and ends the program.
[[noreturn]] WELLSTRAT_API void endForSmallArray(const char* function, std::size_t size,
                                                 std::size_t needed);

} // namespace detail

/// The argument of functions that read or write `count` elements of T: a T*, which is not checked,
/// or anything that knows its size: a T[N], a std::vector<T>, whatever has data() and size(). One
/// that is too small ends the program before anything is written, with a line that says so, in
/// every build. Made by the caller's argument, for the time of the call.
template <class T>
class ArrayArgument {
    template <class Pointer>
    using IfPointer = std::enable_if_t<std::is_convertible<Pointer, T*>::value &&
                                       !std::is_array<std::remove_reference_t<Pointer>>::value>;
    template <class Container>
    using IfContainer = std::enable_if_t<
        std::is_convertible<decltype(std::declval<Container&>().data()), T*>::value &&
        std::is_convertible<decltype(std::declval<Container&>().size()), std::size_t>::value>;

public:
    template <class Pointer, class = IfPointer<Pointer>>
    constexpr ArrayArgument(Pointer&& pointer) // NOLINT(google-explicit-constructor)
        : data_(pointer), size_(~std::size_t{0}) {}

    template <std::size_t n>
    constexpr ArrayArgument(T (&array)[n]) // NOLINT(google-explicit-constructor)
        : data_(array), size_(n) {}

    template <class Container, class = IfContainer<Container>, class = void>
    constexpr ArrayArgument(Container&& container) // NOLINT(google-explicit-constructor)
        : data_(container.data()), size_(container.size()) {}

    /// The first element, if there are at least `count`. `function` is named in the line.
    constexpr T* first(std::size_t count, const char* function) const {
        if (WELLSTRAT_UNLIKELY(size_ < count)) {
            detail::endForSmallArray(function, size_, count);
        }
        return data_;
    }

private:
    T* data_;
    std::size_t size_; ///< unknown: the largest number
};

} // namespace stream1
} // namespace wellstrat
