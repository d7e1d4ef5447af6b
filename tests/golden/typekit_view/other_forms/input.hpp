#pragma once
#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <vector>
// Cases 06, 15, 31, 37 and 62 of the type matrix: fields that attributes or their types show as something else.
namespace other_forms {
struct Point { double x = 0, y = 0; };
union [[oro::bytes]] Word { int whole; float part; };
struct Room {
    [[oro::capacity(20)]] std::string name;  ///< what it is called
    std::vector<double> samples;             ///< @capacity 100
};
struct Texts {
    [[oro::text]] char label[8] = "";
    std::array<char, 4> code{};  ///< @text
};
struct Raw {
    int kind = 0;
    Word word{};
};
struct Pointers {
    [[oro::by_value]] std::shared_ptr<Point> shared;
    std::shared_ptr<const Point> fixed;  ///< where it began @by_value
    std::shared_ptr<double> number;      ///< @by_value
};
struct Owner {
    Owner() = default;
    Owner(const Owner& other) : own(other.own ? new Point(*other.own) : nullptr) {}
    Owner& operator=(const Owner& other) {
        own.reset(other.own ? new Point(*other.own) : nullptr);
        return *this;
    }
    [[oro::by_value]] std::unique_ptr<Point> own;
};
struct Counter {
    Counter() = default;
    Counter(const Counter& other) : count(other.count.load()), on(other.on.load()) {}
    Counter& operator=(const Counter& other) {
        count = other.count.load();
        on = other.on.load();
        return *this;
    }
    std::atomic<int> count{0};
    std::atomic<bool> on{false};
};
}
