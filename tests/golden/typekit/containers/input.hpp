#pragma once
#include <bitset>
#include <chrono>
#include <complex>
#include <deque>
#include <forward_list>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <valarray>
#include <variant>
#include <vector>
// Cases 23 to 30, 73 and 89 of the type matrix.
namespace containers {
struct Point { double x, y; };
struct Sequences {
    std::deque<int> deque;
    std::list<Point> list;
    std::forward_list<int> forward;
    std::valarray<double> values;
};
struct Keyed {
    std::map<std::string, double> map;
    std::map<int, Point> points;
    std::unordered_map<int, double> hashed;
    std::multimap<int, int> multi;
    std::set<int> set;
    std::unordered_set<std::string> names;
};
struct Choices {
    std::optional<double> maybe;
    std::optional<Point> place;
    std::variant<int, std::string, Point> any;
    std::variant<std::monostate, double> orNothing;
    std::vector<std::optional<std::variant<int, double>>> deep;
};
struct Parts {
    std::pair<int, Point> pair;
    std::tuple<int, std::string, double> tuple;
    std::complex<double> number;
    std::bitset<12> flags;
};
struct Times {
    std::chrono::nanoseconds wait;  ///< How long it takes. @range 0..1000
    std::chrono::duration<float> seconds;
    std::chrono::system_clock::time_point when;
    std::vector<std::chrono::milliseconds> all;
};
}
