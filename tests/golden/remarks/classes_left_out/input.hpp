#pragma once
#include <memory>
namespace remarks {
struct Sample { double value; };
class Shape {
public:
    virtual ~Shape() = default;
    int corners = 0;
};
struct Square : Shape {};
class Account {
public:
    double balance() const { return balance_; }
    int* page = nullptr;

    enum class Kind { giro, savings };
    struct Entry { double amount; };

private:
    double balance_ = 0;
    std::unique_ptr<Shape> shape_;
};
struct Savings : Account { double interest; };
class Secret : Sample {};
class [[oro::skip]] Meant { int number_; };
}
