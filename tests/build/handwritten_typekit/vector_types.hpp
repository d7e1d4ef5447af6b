// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// User types of the hand-written typekit: a vector with private storage, as linear algebra libraries have it, and a
// struct with a serialization function.
#ifndef TESTS_BUILD_HANDWRITTEN_VECTOR_TYPES_HPP
#define TESTS_BUILD_HANDWRITTEN_VECTOR_TYPES_HPP

#include <boost/serialization/array.hpp>
#include <boost/serialization/nvp.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace algebra {

class Vector {
public:
    Vector() = default;
    explicit Vector(int size) : data_(static_cast<std::size_t>(size), 0.0) {}
    int size() const { return static_cast<int>(data_.size()); }
    void resize(int size) { data_.resize(static_cast<std::size_t>(size)); }
    double& operator()(int i) { return data_.at(static_cast<std::size_t>(i)); }
    double operator()(int i) const { return data_.at(static_cast<std::size_t>(i)); }

private:
    std::vector<double> data_;
};

inline std::ostream& operator<<(std::ostream& os, const Vector& v) {
    for (int i = 0; i != v.size(); ++i) os << (i ? " " : "") << v(i);
    return os;
}

inline Vector operator+(const Vector& a, const Vector& b) {
    Vector sum(a.size());
    for (int i = 0; i != a.size(); ++i) sum(i) = a(i) + b(i);
    return sum;
}

struct Joint {
    std::string name;
    double position = 0;
    double limits[2] = {-1, 1};
    Vector torque;
};

}  // namespace algebra

namespace boost {
namespace serialization {
template <class Archive>
void serialize(Archive& ar, algebra::Joint& joint, unsigned int) {
    ar& make_nvp("name", joint.name);
    ar& make_nvp("position", joint.position);
    ar& make_nvp("limits", make_array(joint.limits, 2));
    ar& make_nvp("torque", joint.torque);
}
}  // namespace serialization
}  // namespace boost

#endif
