#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory_resource>
#include <vector>
// Cases 02, 03, 05, 22 and 29 of the type matrix.
namespace remarks {
struct Numbers {
    long double precise;
    wchar_t letter;
    std::size_t size;
    long count;
    std::int64_t fine;
    std::vector<std::size_t> sizes;
    std::map<int, wchar_t> letters[2];
    std::chrono::steady_clock::time_point since;
    std::chrono::system_clock::time_point when;
    std::chrono::nanoseconds wait;
    std::pmr::vector<int> pooled;
};
}
