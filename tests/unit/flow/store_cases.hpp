// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the contract of a storage is run on: lock policies and types of samples that between them reach every
// implementation (see sample_store.hpp).
#ifndef OROFORGE_TESTS_FLOW_STORE_CASES_HPP
#define OROFORGE_TESTS_FLOW_STORE_CASES_HPP

#include <rtt/internal/flow/sample_store.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace flow_test {

/** Plain, not a whole number of words. */
struct Bytes13 {
    char text[13];
    bool operator==(const Bytes13& o) const { return std::equal(text, text + 13, o.text); }
};
/** Plain, but too large to be copied word by word. */
struct Big {
    double numbers[100];
    bool operator==(const Big& o) const { return std::equal(numbers, numbers + 100, o.numbers); }
};
/** Wants more alignment than operator new gives. */
struct alignas(128) Aligned {
    int number = 0;
    std::string text;
    bool operator==(const Aligned& o) const { return number == o.number && text == o.text; }
};

inline double value(double*, int i) { return i + 0.5; }
inline char value(char*, int i) { return static_cast<char>('a' + i % 26); }
inline std::string value(std::string*, int i) {
    return "a string too long to be stored in place, number " + std::to_string(i);
}
inline std::vector<double> value(std::vector<double>*, int i) { return std::vector<double>(100, i); }
inline Bytes13 value(Bytes13*, int i) {
    Bytes13 b = {};
    for (int n = 0; n < 13; ++n) b.text[n] = static_cast<char>('A' + i + n);
    return b;
}
inline Big value(Big*, int i) {
    Big b;
    for (double& n : b.numbers) n = ++i;
    return b;
}
inline Aligned value(Aligned*, int i) {
    Aligned a;
    a.number = i;
    a.text = value(static_cast<std::string*>(nullptr), i);
    return a;
}

template <RTT::internal::StoreSpec::Lock L, class T>
struct Case {
    static constexpr RTT::internal::StoreSpec::Lock lock = L;
    typedef T Type;
    static T sample(int i) { return value(static_cast<T*>(nullptr), i); }
};

typedef RTT::internal::StoreSpec Spec;
typedef testing::Types<Case<Spec::LockFree, double>, Case<Spec::LockFree, char>, Case<Spec::LockFree, Bytes13>,
                       Case<Spec::LockFree, std::string>, Case<Spec::LockFree, std::vector<double>>,
                       Case<Spec::LockFree, Big>, Case<Spec::LockFree, Aligned>, Case<Spec::Locked, double>,
                       Case<Spec::Locked, std::string>, Case<Spec::Locked, Aligned>, Case<Spec::Unsync, double>,
                       Case<Spec::Unsync, std::string>, Case<Spec::Unsync, Big>>
    StoreCases;

}  // namespace flow_test

#endif
