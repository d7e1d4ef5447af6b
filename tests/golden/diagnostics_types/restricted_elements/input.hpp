#pragma once
#include <atomic>
#include <optional>
#include <vector>
// Cases 34, 49 and 62 of the type matrix.
namespace bad {
struct Fixed { const int version = 3; double value = 0; };
struct [[oro::make("Sized(0)")]] Sized { explicit Sized(int n) : size(n) {} int size; };
struct Holder {
    Fixed plain;
    std::vector<Fixed> list;
    Fixed array[2];
    std::optional<Sized> maybe;
};
struct Deleted { Deleted& operator=(const Deleted&) = delete; const int k = 0; };
struct Counter { std::atomic<int> count; };
struct Locked { std::vector<std::atomic<int>> counts; };
}
