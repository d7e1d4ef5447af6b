// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_PARAMETER_TYPES_HPP
#define RTT_ROSPARAM_PARAMETER_TYPES_HPP

#include <Eigen/Core>

#include <string>
#include <vector>

/** Calls X(name, C++ type) for each type T of get<T>, set<T> and addRosParamProperty<T>. */
#define RTT_ROSPARAM_TYPES(X)                  \
    X(String, std::string)                     \
    X(Double, double)                          \
    X(Float, float)                            \
    X(Int, int)                                \
    X(Bool, bool)                              \
    X(VectorOfString, std::vector<std::string>) \
    X(VectorOfDouble, std::vector<double>)     \
    X(VectorOfFloat, std::vector<float>)       \
    X(VectorOfInt, std::vector<int>)           \
    X(VectorOfBool, std::vector<bool>)         \
    X(EigenVectorXd, Eigen::VectorXd)          \
    X(EigenVectorXf, Eigen::VectorXf)

/** Calls X(name, policy, …) for each end of the names of operations that says where a parameter is. */
#define RTT_ROSPARAM_POLICIES(X, ...)                            \
    X(Relative, RELATIVE, __VA_ARGS__)                           \
    X(Absolute, ABSOLUTE, __VA_ARGS__)                           \
    X(Private, PRIVATE, __VA_ARGS__)                             \
    X(ComponentPrivate, COMPONENT_PRIVATE, __VA_ARGS__)          \
    X(ComponentRelative, COMPONENT_RELATIVE, __VA_ARGS__)        \
    X(ComponentAbsolute, COMPONENT_ABSOLUTE, __VA_ARGS__)

#endif
