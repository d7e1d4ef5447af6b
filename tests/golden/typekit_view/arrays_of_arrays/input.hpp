#pragma once
#include <array>
#include <cstddef>
#include <new>
#include <string>
#include <vector>
// Cases 15, 16, 18 to 22 of the type matrix.
namespace arrays_of_arrays {
template <class T>
struct Heap {
    using value_type = T;
    Heap() = default;
    template <class U>
    Heap(const Heap<U>&) {}
    T* allocate(std::size_t n) { return static_cast<T*>(::operator new(n * sizeof(T))); }
    void deallocate(T* p, std::size_t) { ::operator delete(p); }
    bool operator==(const Heap&) const { return true; }
    bool operator!=(const Heap&) const { return false; }
};
enum class Mode : unsigned char { Idle, Run };
struct Cell { double value; std::string note; };
struct Grid {
    double cells[3][4];
    short cube[2][3][4];
    std::array<std::array<double, 3>, 3> matrix;
    std::array<double, 2> rows[3];
    std::vector<std::array<int, 2>> pairs;
    std::vector<bool> bits;
    std::vector<Mode> modes;
    std::vector<int, Heap<int>> own;
    std::array<Cell, 2> fixed;
    Cell board[2][2];
    char text[32];
};
}
