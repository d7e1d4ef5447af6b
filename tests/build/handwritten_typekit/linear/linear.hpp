// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Vectors and matrices of a size known at run time, as linear algebra libraries have them.
#ifndef LINEAR_HPP
#define LINEAR_HPP

#include <ostream>
#include <vector>

namespace linear {

class Vector {
public:
    Vector() {}
    explicit Vector(int rows) : data_(rows, 0.0) {}
    int rows() const { return static_cast<int>(data_.size()); }
    void resize(int rows) { data_.resize(rows, 0.0); }
    double& operator()(int i) { return data_[i]; }
    double operator()(int i) const { return data_[i]; }
    void setConstant(double value) { data_.assign(data_.size(), value); }

private:
    std::vector<double> data_;
};

class Matrix {
public:
    Matrix() : cols_(0) {}
    Matrix(int rows, int cols) : cols_(cols), data_(rows * cols, 0.0) {}
    int rows() const { return cols_ ? static_cast<int>(data_.size()) / cols_ : 0; }
    int cols() const { return cols_; }
    void resize(int rows, int cols) { *this = Matrix(rows, cols); }
    double& operator()(int i, int j) { return data_[i * cols_ + j]; }
    double operator()(int i, int j) const { return data_[i * cols_ + j]; }

private:
    int cols_;
    std::vector<double> data_;
};

inline Vector operator+(const Vector& a, const Vector& b) {
    Vector sum(a.rows());
    for (int i = 0; i < a.rows(); ++i) sum(i) = a(i) + b(i);
    return sum;
}
inline Vector operator*(const Vector& a, double factor) {
    Vector result(a);
    for (int i = 0; i < a.rows(); ++i) result(i) *= factor;
    return result;
}
inline Vector operator*(double factor, const Vector& a) { return a * factor; }
inline Vector operator/(const Vector& a, double divisor) { return a * (1 / divisor); }
inline Vector operator-(const Vector& a) { return a * -1.0; }
inline double dot(const Vector& a, const Vector& b) {
    double sum = 0;
    for (int i = 0; i < a.rows(); ++i) sum += a(i) * b(i);
    return sum;
}
inline Vector operator*(const Matrix& m, const Vector& v) {
    Vector result(m.rows());
    for (int i = 0; i < m.rows(); ++i)
        for (int j = 0; j < m.cols(); ++j) result(i) += m(i, j) * v(j);
    return result;
}
inline std::ostream& operator<<(std::ostream& os, const Vector& v) {
    for (int i = 0; i < v.rows(); ++i) os << (i ? " " : "") << v(i);
    return os;
}
inline std::istream& operator>>(std::istream& is, Vector&) { return is; }
inline std::ostream& operator<<(std::ostream& os, const Matrix& m) {
    for (int i = 0; i < m.rows(); ++i)
        for (int j = 0; j < m.cols(); ++j) os << (j ? " " : i ? "; " : "") << m(i, j);
    return os;
}
inline std::istream& operator>>(std::istream& is, Matrix&) { return is; }

}  // namespace linear

#endif
