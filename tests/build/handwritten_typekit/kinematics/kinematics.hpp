// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Frames, joints and chains, as kinematics libraries have them.
#ifndef KINEMATICS_HPP
#define KINEMATICS_HPP

#include <boost/array.hpp>
#include <iostream>
#include <string>
#include <vector>

namespace kinematics {

class Vec {
public:
    double data[3];
    Vec() { data[0] = data[1] = data[2] = 0; }
    Vec(double x, double y, double z) { data[0] = x, data[1] = y, data[2] = z; }
    double& operator()(int i) { return data[i]; }
    double operator()(int i) const { return data[i]; }
    double x() const { return data[0]; }
    double y() const { return data[1]; }
    double z() const { return data[2]; }
};
inline Vec operator+(const Vec& a, const Vec& b) { return Vec(a.x() + b.x(), a.y() + b.y(), a.z() + b.z()); }
inline Vec operator*(const Vec& a, double f) { return Vec(a.x() * f, a.y() * f, a.z() * f); }
inline bool operator==(const Vec& a, const Vec& b) { return a.x() == b.x() && a.y() == b.y() && a.z() == b.z(); }
inline std::ostream& operator<<(std::ostream& os, const Vec& v) {
    return os << '[' << v.x() << ',' << v.y() << ',' << v.z() << ']';
}
inline std::istream& operator>>(std::istream& is, Vec& v) {
    char mark;
    return is >> mark >> v.data[0] >> mark >> v.data[1] >> mark >> v.data[2] >> mark;
}

class Rot {
public:
    double data[9];
    Rot() { *this = Rot(1, 0, 0, 0, 1, 0, 0, 0, 1); }
    Rot(double xx, double yx, double zx, double xy, double yy, double zy, double xz, double yz, double zz) {
        data[0] = xx, data[1] = yx, data[2] = zx;
        data[3] = xy, data[4] = yy, data[5] = zy;
        data[6] = xz, data[7] = yz, data[8] = zz;
    }
    double operator()(int i, int j) const { return data[i * 3 + j]; }
    Rot Inverse() const { return Rot(data[0], data[3], data[6], data[1], data[4], data[7], data[2], data[5], data[8]); }
};
inline Vec operator*(const Rot& r, const Vec& v) {
    Vec result;
    for (int i = 0; i < 3; ++i) result(i) = r(i, 0) * v.x() + r(i, 1) * v.y() + r(i, 2) * v.z();
    return result;
}

struct Frame {
    Vec p;
    Rot M;
    Frame() {}
    Frame(const Rot& m, const Vec& v) : p(v), M(m) {}
};
inline Vec operator*(const Frame& f, const Vec& v) { return f.M * v + f.p; }

enum JointType { Fixed, RotZ, TransZ };

struct Named {
    std::string name;
    int id;
    Named() : id(0) {}
};

struct Segment : public Named {
    Frame tip;
    JointType joint;
    boost::array<double, 2> limits;
    double inertia[3][3];
    std::vector<std::string> tags;
    Segment() : joint(Fixed) {
        limits.assign(0);
        for (int i = 0; i < 9; ++i) inertia[i / 3][i % 3] = 0;
    }
};

typedef std::vector<Segment> Chain;

}  // namespace kinematics

#endif
