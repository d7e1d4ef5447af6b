#pragma once
namespace bad {
template <class T> struct Holder { T* held; };
using IntHolder = Holder<int>;
template struct Holder<double>;
template <class T> struct Many { T *a, *b, *c, *d, *e, *f, *g, *h, *i, *j; };
typedef Many<int> ManyInts;
template <class T> struct Forward;
using Never = Forward<int>;
}
