#pragma once
#include <cstddef>
#include <iostream>
namespace demo {
inline namespace v2 { struct Tagged { int x; }; }
class Outer {
public:
    struct Inner { int a; };
    static constexpr int kSize = 3;
    static int counter;
    Outer() = default;
    explicit Outer(int size) : size_(size) {}
    bool operator==(const Outer& other) const { return size_ == other.size_; }
    Inner inner;
    int size_ = kSize;
private:
    struct Secret { int* p; };
};
typedef Outer First;
using Second = Outer;
struct Empty {};
struct Holder { Empty empty; struct { int inside; }; alignas(32) float wide[8]; };
inline void local() { struct Local { int* p; }; }
struct Forward;
void use(Forward*);
}
struct Global { std::size_t size; };
