// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CARRAY_HPP
#define ORO_CARRAY_HPP

#include <cstddef>
#include <type_traits>
#include <utility>

namespace RTT {
namespace types {

/**
 * A view on an array that other code owns. A copy of a view refers to the same array. Assignment copies elements, as
 * many as both have; but assignment to an empty view makes it refer to the other array.
 */
template <typename T>
class carray {
public:
    typedef T value_type;

    carray() noexcept : data_(nullptr), count_(0) {}
    carray(value_type* data, std::size_t count) noexcept : data_(count ? data : nullptr), count_(count) {}
    carray(const carray&) noexcept = default;
    template <std::size_t N>
    explicit carray(T (&array)[N]) noexcept : data_(array), count_(N) {}
    /** From a wrapper with address() and count(), as boost::serialization's make_array() gives. */
    template <class W, class = decltype(std::declval<const W&>().address())>
    explicit carray(const W& wrapper) : data_(const_cast<T*>(wrapper.address())), count_(wrapper.count()) {}
    /** A view on the elements of a boost::array or std::array. */
    template <template <class, std::size_t> class Array, std::size_t N>
    explicit carray(Array<T, N>& array) noexcept : data_(N ? &array[0] : nullptr), count_(N) {}

    /** Makes the view refer to another array. */
    void init(value_type* data, std::size_t count) noexcept {
        data_ = count ? data : nullptr;
        count_ = count;
    }
    carray& operator=(const carray& other) {
        if (&other == this) return *this;
        if (!data_) {
            init(other.data_, other.count_);
            return *this;
        }
        for (std::size_t i = 0; i != count_ && i != other.count_; ++i) data_[i] = other.data_[i];
        return *this;
    }

    /** Copies the elements of an array, as many as both have. */
    template <template <class, std::size_t> class Array, std::size_t N>
    carray& operator=(const Array<T, N>& other) {
        for (std::size_t i = 0; i != count_ && i != N; ++i) data_[i] = other[i];
        return *this;
    }

    value_type* address() const noexcept { return data_; }
    std::size_t count() const noexcept { return count_; }
    std::size_t size() const noexcept { return count_; }
    value_type& operator[](std::size_t i) const noexcept { return data_[i]; }

private:
    value_type* data_;
    std::size_t count_;
};

/** A view on `array`. */
template <class T, std::size_t N>
carray<T> make_carray(T (&array)[N]) {
    return carray<T>(array, N);
}

}  // namespace types
}  // namespace RTT

#endif
