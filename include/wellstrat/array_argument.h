// SPDX-License-Identifier: Apache-2.0
//
// An array that a function is given, by a pointer, as an array, or as a container.

#pragma once

#include "wellstrat/platform.h"

#include <cstddef>
#include <type_traits>

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// Says in one line that an array is too small, and ends the program.
[[noreturn]] WELLSTRAT_API void endForSmallArray(const char* function, std::size_t size,
                                                 std::size_t needed);

/// std::declval, whose header is long.
template <class T>
T valueOf();

} // namespace detail

/// The argument of functions that read or write `count` elements of T: a T*, which is not checked,
/// or anything that knows its size: a T[N], a std::vector<T>, whatever has data() and size(). One
/// that is too small ends the program before anything is written, with a line that says so, in
/// every build. Made by the caller's argument, for the time of the call. A temporary container must
/// be one that owns nothing, such as a span.
template <class T>
class ArrayArgument {
    template <class Pointer>
    using IfPointer = std::enable_if_t<std::is_convertible<Pointer, T*>::value>;

    /// data() and size() of a container as it is given, constant where it is a temporary.
    template <class Container>
    using Given = std::conditional_t<std::is_lvalue_reference<Container>::value, Container,
                                     const std::remove_reference_t<Container>&>;
    template <class Container>
    using Element = std::remove_pointer_t<decltype(detail::valueOf<Given<Container>>().data())>;
    template <class Container>
    using Size = decltype(detail::valueOf<Given<Container>>().size());
    /// No derived classes, of which the second does not stand where the second T would.
    template <class Container>
    using IfContainer =
        std::enable_if_t<std::is_convertible<Element<Container> (*)[], T (*)[]>::value &&
                         std::is_integral<Size<Container>>::value &&
                         !std::is_convertible<Container, T*>::value>;

public:
    template <class Pointer, class = IfPointer<Pointer>>
    constexpr ArrayArgument(Pointer pointer) // NOLINT(google-explicit-constructor)
        : data_(pointer), size_(~std::size_t{0}) {}
    constexpr ArrayArgument(std::nullptr_t) // NOLINT(google-explicit-constructor)
        : data_(nullptr), size_(~std::size_t{0}) {}

    template <std::size_t n>
    constexpr ArrayArgument(T (&array)[n]) // NOLINT(google-explicit-constructor)
        : data_(array), size_(n) {}

    template <class Container, class = IfContainer<Container>, class = void>
    constexpr ArrayArgument(Container&& container) // NOLINT(google-explicit-constructor)
        : data_(container.data()), size_(sizeOf<Size<Container>>(container.size())) {}

    /// The first element, if there are at least `count`. `function` is named in the line.
    constexpr T* first(std::size_t count, const char* function) const {
        if (WELLSTRAT_UNLIKELY(size_ < count)) {
            detail::endForSmallArray(function, size_, count);
        }
        return data_;
    }

private:
    /// Some libraries have signed sizes.
    template <class Integer>
    static constexpr std::size_t sizeOf(Integer size) {
        return size > Integer{0} ? static_cast<std::size_t>(size) : 0;
    }

    T* data_;
    std::size_t size_; ///< unknown: the largest number
};

} // namespace stream1
} // namespace wellstrat
