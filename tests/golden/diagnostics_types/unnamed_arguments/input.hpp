#pragma once
// Case 51 of the type matrix.
namespace bad {
template <const int* P> struct Tagged {
    struct Part { int x; };
    int x;
};
template <template <class> class T> struct Of { T<int> x; };
template <class... T> struct Many { int x; };
inline const int kTag = 1;
template <class T> struct Box { T value; };
enum class Axis { x, y };
template <Axis A> struct On { int x; };
struct Holder {
    Tagged<&kTag> tagged;
    Tagged<&kTag>::Part part;
    Of<Box> of;
    Many<int, int*> many;
    On<Axis(7)> seventh;
};
using Alias = Tagged<&kTag>;
template struct Many<int*>;
}
