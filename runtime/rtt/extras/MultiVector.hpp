// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_MULTI_VECTOR_HPP
#define ORO_EXTRAS_MULTI_VECTOR_HPP

#include <cstddef>
#include <ostream>

namespace RTT {
namespace extras {

/** `S` numbers that are added, subtracted, multiplied and divided one by one. */
template <unsigned int S, class D = double>
class MultiVector {
public:
    typedef D value_type;
    typedef D* iterator;
    typedef const D* const_iterator;
    enum { size = S };

    /** All numbers have the same value. */
    explicit MultiVector(const D& value = D()) { *this = value; }
    /** Copies `S` values. */
    explicit MultiVector(const D* values) {
        for (D& element : data_) element = *values++;
    }
    MultiVector& operator=(const D& value) {
        for (D& element : data_) element = value;
        return *this;
    }

    D& operator[](std::size_t index) { return data_[index]; }
    const D& operator[](std::size_t index) const { return data_[index]; }
    iterator begin() { return data_; }
    iterator end() { return data_ + S; }
    const_iterator begin() const { return data_; }
    const_iterator end() const { return data_ + S; }

    MultiVector& operator+=(const MultiVector& other) {
        for (unsigned int i = 0; i < S; ++i) data_[i] += other.data_[i];
        return *this;
    }
    MultiVector& operator-=(const MultiVector& other) {
        for (unsigned int i = 0; i < S; ++i) data_[i] -= other.data_[i];
        return *this;
    }
    MultiVector& operator*=(const MultiVector& other) {
        for (unsigned int i = 0; i < S; ++i) data_[i] *= other.data_[i];
        return *this;
    }
    MultiVector& operator/=(const MultiVector& other) {
        for (unsigned int i = 0; i < S; ++i) data_[i] /= other.data_[i];
        return *this;
    }
    MultiVector& operator*=(const D& factor) { return *this *= MultiVector(factor); }
    MultiVector& operator/=(const D& divisor) { return *this /= MultiVector(divisor); }

    friend MultiVector operator+(MultiVector a, const MultiVector& b) { return a += b; }
    friend MultiVector operator-(MultiVector a, const MultiVector& b) { return a -= b; }
    friend MultiVector operator*(MultiVector a, const MultiVector& b) { return a *= b; }
    friend MultiVector operator/(MultiVector a, const MultiVector& b) { return a /= b; }
    friend MultiVector operator*(MultiVector a, const D& factor) { return a *= factor; }
    friend MultiVector operator*(const D& factor, MultiVector a) { return a *= factor; }
    friend MultiVector operator/(MultiVector a, const D& divisor) { return a /= divisor; }
    MultiVector operator-() const { return MultiVector() - *this; }

    friend bool operator==(const MultiVector& a, const MultiVector& b) {
        for (unsigned int i = 0; i < S; ++i)
            if (!(a.data_[i] == b.data_[i])) return false;
        return true;
    }
    friend bool operator!=(const MultiVector& a, const MultiVector& b) { return !(a == b); }
    friend std::ostream& operator<<(std::ostream& stream, const MultiVector& vector) {
        stream << "[";
        for (unsigned int i = 0; i < S; ++i) stream << (i ? ", " : " ") << vector.data_[i];
        return stream << " ]";
    }

private:
    static_assert(S > 0, "a MultiVector has elements");
    D data_[S];
};

}  // namespace extras
}  // namespace RTT

#endif
