// A library with private storage, as it may not be changed.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace library {

class Angle {
public:
    double degrees() const { return turns_ * 360; }
    void setDegrees(double degrees) { turns_ = degrees / 360; }
    const std::string& label() const { return label_; }
    std::string& label() { return label_; }

private:
    double turns_ = 0;
    std::string label_;
};

class Pose {
public:
    Angle heading;
    double operator[](int i) const { return at_[i]; }
    double& operator[](int i) { return at_[i]; }
    bool isValid() const { return (flags_ & 1) != 0; }
    void setValid(bool valid) { flags_ = valid ? flags_ | 1u : flags_ & ~1u; }

private:
    double at_[2] = {};
    unsigned flags_ = 0;
};

/// Elements have addresses; a resized ring forgets them.
template <class T, int N = 0>
class Ring {
public:
    int length() const { return static_cast<int>(all_.size()); }
    void reset(int length) { all_ = std::vector<T>(static_cast<std::size_t>(length)); }
    const T& get(int i) const { return all_[static_cast<std::size_t>(i)]; }
    T& get(int i) { return all_[static_cast<std::size_t>(i)]; }

private:
    std::vector<T> all_ = std::vector<T>(N);
};

/// Elements are bits, reached through a proxy.
class Mask {
public:
    class Bit {
    public:
        Bit(unsigned& bits, unsigned i) : bits_(bits), i_(i) {}
        Bit& operator=(bool on) {
            bits_ = on ? bits_ | 1u << i_ : bits_ & ~(1u << i_);
            return *this;
        }

    private:
        unsigned& bits_;
        unsigned i_;
    };
    bool operator[](unsigned i) const { return (bits_ >> i & 1u) != 0; }
    Bit operator[](unsigned i) { return {bits_, i}; }

private:
    unsigned bits_ = 0;
};

template <int Rows>
class Grid {
public:
    std::size_t width() const { return cells_.size() / Rows; }
    void setWidth(std::size_t width) { cells_.assign(width * Rows, 0); }
    float cell(std::size_t row, std::size_t column) const { return cells_[column * Rows + row]; }
    void setCell(std::size_t row, std::size_t column, float value) { cells_[column * Rows + row] = value; }

private:
    std::vector<float> cells_;
};

class alignas(32) Square {
public:
    short& operator()(int row, int column) { return cells_[row][column]; }
    short operator()(int row, int column) const { return cells_[row][column]; }

private:
    short cells_[2][2] = {};
};

}  // namespace library
