// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The names of the standard library that typegen knows, and nothing behind them: the fuzzer reads it for each input.
#pragma once
// NOLINTBEGIN: these are not our names
namespace std {
using size_t = decltype(sizeof 0);
enum class byte : unsigned char {};
template <class T>
struct allocator {};
template <class T>
struct less {};
template <class T>
struct hash {};
template <class T>
struct equal_to {};
template <class T>
struct char_traits {};
template <class T>
struct default_delete {};
template <class C, class T = char_traits<C>, class A = allocator<C>>
class basic_string {
    C* at;
};
template <class C, class T = char_traits<C>>
class basic_string_view {
    const C* at;
};
using string = basic_string<char>;
using wstring = basic_string<wchar_t>;
using string_view = basic_string_view<char>;
template <class T, class A = allocator<T>>
class vector {
    T* at[3];
};
template <class T, class A = allocator<T>>
class deque {
    T* at[10];
};
template <class T, class A = allocator<T>>
class list {
    T* at[3];
};
template <class T, class A = allocator<T>>
class forward_list {
    T* at;
};
template <class T>
class valarray {
    T* at[2];
};
template <class T, size_t n>
struct array {
    T at[n];
};
template <class K, class C = less<K>, class A = allocator<K>>
class set {
    K* at[6];
};
template <class K, class H = hash<K>, class E = equal_to<K>, class A = allocator<K>>
class unordered_set {
    K* at[6];
};
template <class K, class V, class C = less<K>, class A = allocator<V>>
class map {
    V* at[6];
};
template <class K, class V, class H = hash<K>, class E = equal_to<K>, class A = allocator<V>>
class unordered_map {
    V* at[6];
};
template <class A, class B>
struct pair {
    A first;
    B second;
};
template <class... T>
class tuple {
    int at;
};
template <class... T>
class variant {
    int at;
};
struct monostate {};
template <class T>
class optional {
    T at;
    bool has;
};
template <class T>
class complex {
    T at[2];
};
template <class T>
struct atomic {
    T at;
    atomic(const atomic&) = delete;
    atomic();
};
template <size_t n>
class bitset {
    unsigned long at;
};
template <class T>
class shared_ptr {
    T* at;
};
template <class T, class D = default_delete<T>>
class unique_ptr {
    T* at;
    unique_ptr(const unique_ptr&) = delete;
    unique_ptr();
};
template <class F>
class function {
    F* at;
};
class any {
    void* at;
};
class mutex {
    int at;
    mutex(const mutex&) = delete;
    mutex();
};
template <long n, long d = 1>
struct ratio {
    static constexpr long num = n, den = d;
};
namespace chrono {
template <class R, class P = ratio<1>>
class duration {
    R at;
};
struct system_clock {};
struct steady_clock {};
template <class C, class D = duration<long, ratio<1, 1000000000>>>
class time_point {
    D at;
};
using nanoseconds = duration<long, ratio<1, 1000000000>>;
using milliseconds = duration<long, ratio<1, 1000>>;
}  // namespace chrono
}  // namespace std
// NOLINTEND
