#pragma once
#include <string>
// Cases 34 and 49 of the type matrix: values that cannot be assigned, or not be made without arguments.
namespace restricted {
struct Fixed {
    const int version = 3;  ///< of the format
    const double scale[2] = {0.5, 2};
    double value = 1;
};
struct Holder { Fixed fixed; int number = 1; };
/// Of some size. @make Sized(kSmallest)
struct Sized {
    explicit Sized(int n) : size(n) {}
    int size;
};
constexpr int kSmallest = 8;
struct Outer { Sized sized{4}; std::string name; };
class [[oro::make("Level::empty()")]] Level {
public:
    static Level empty() { return Level(0); }
    double value;

private:
    explicit Level(double of) : value(of) {}
};
}
