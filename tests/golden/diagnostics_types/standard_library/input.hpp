#pragma once
#include <atomic>
#include <chrono>
#include <complex>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
namespace bad {
struct All {
    std::unique_ptr<int> unique;
    std::shared_ptr<int> shared;
    std::map<std::string, double> map;
    std::set<int> set;
    std::deque<int> deque;
    std::optional<double> optional;
    std::variant<int, double> variant;
    std::pair<int, int> pair;
    std::tuple<int> tuple;
    std::complex<double> complex;
    std::chrono::nanoseconds time;
    std::function<void()> function;
    std::atomic<int> atomic;
    std::mutex mutex;
    std::string_view view;
    std::wstring wide;
    std::byte byte;
};
}
