#pragma once
// Case 51 of the type matrix.
namespace bad {
template <const int* P> struct Tagged { int x; };
template <template <class> class T> struct Of { T<int> x; };
template <class... T> struct Many { int x; };
inline const int kTag = 1;
template <class T> struct Box { T value; };
struct Holder {
    Tagged<&kTag> tagged;
    Of<Box> of;
    Many<int, int*> many;
};
}
