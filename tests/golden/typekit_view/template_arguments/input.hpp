#pragma once
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>
namespace template_arguments {
enum class Axis { x, y, z };
enum Precision { low, high };
template <Axis A, Precision P = high> struct Along {
    enum class Kind { rest, move };
    double value = 0;
    Kind kind = Kind::move;
    std::vector<Kind> kinds;
};
// As message generators write them: a template over an allocator, which an alias gives its usual name.
template <class Allocator> struct Text_ {
    using Type = Text_<Allocator>;
    std::basic_string<char, std::char_traits<char>,
                      typename std::allocator_traits<Allocator>::template rebind_alloc<char>>
        data;
};
template <class Allocator> struct Named_ {
    Text_<Allocator> name;
    std::vector<Text_<Allocator>, typename std::allocator_traits<Allocator>::template rebind_alloc<Text_<Allocator>>> more;
};
typedef Text_<std::allocator<void>> Text;
typedef Named_<std::allocator<void>> Named;
struct Holder {
    Along<Axis::y> y;
    Along<Axis::z, low> z;
    Along<Axis::x>::Kind kind = Along<Axis::x>::Kind::move;
    Named named;
    std::vector<Text> texts;
    std::map<std::string, int, std::less<>> anyKey;
    std::set<int, std::less<void>> anyOrder;
    std::map<std::string, int, std::less<std::string>> usual;
};
}
