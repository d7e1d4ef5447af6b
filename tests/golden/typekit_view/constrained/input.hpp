#pragma once
// Case 79 of the type matrix.
namespace constrained {
template <class T>
concept Small = sizeof(T) <= 8;
template <class T>
    requires Small<T>
struct Box { T value; };
struct Holder {
    Box<int> box;
    bool operator==(const Holder&) const = default;
};
bool operator==(const Box<int>& a, const Box<int>& b);
}
