#pragma once
#include <memory>
#include <string>
#include <vector>

namespace library {

class Vector {
public:
    double x() const { return x_; }
    double y() { return y_; }
    double& y(int i) { return i == 0 ? x_ : y_; }
    std::string name() const { return "v"; }
    const double& z() const { return x_; }
    double data[3];
    double* pointer() const { return nullptr; }
    std::shared_ptr<int> owner;
    void nothing() const {}
    explicit operator bool() const { return true; }
    void setX(std::vector<int> value);

private:
    double x_ = 0, y_ = 0;
};

template <class T, int N>
class Ring {
public:
    double size() const;
    T operator[](int index) const;
    void resize(T, int);
};

class Mover {
public:
    Mover(const Mover&) = delete;
    int x;
};

class Sound {
public:
    int& value() { return value_; }
    int value() const { return value_; }

private:
    int value_ = 0;
};

enum class Kind { a };

}  // namespace library
