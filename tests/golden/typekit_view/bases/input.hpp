#pragma once
// Cases 42, 43, 53, 72, 74 and 80 of the type matrix.
namespace bases {
struct First { int a; double other; };
struct Second { int a; };
struct Both : First, Second { int own; };
struct Hides : Second { double a; };
struct Third { int b; };
struct Distinct : Second, Third {};
template <class T>
struct Counted { int id; };
struct Derived : Counted<Derived> { int own; };
struct Old { int x; [[deprecated("use x")]] int y; };
struct Outer {
    struct { int inner; };
    int plain;
};
}
