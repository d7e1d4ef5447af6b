#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <complex>
#include <vector>

namespace demo {

typedef Eigen::VectorXf Weights;

struct Filter {
    char before;
    Eigen::Vector4d state;
    Eigen::VectorXd gains;
    Eigen::MatrixXd covariance;
    Eigen::Matrix3d rotation;
    Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian;
    Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> pairs;
    Eigen::RowVector2f row;
    Eigen::Array3d array;
    Eigen::Quaterniond attitude;
    Eigen::AngleAxisd turn;
    Eigen::Isometry3d pose;
    std::vector<Eigen::Vector3d> path;
    Eigen::Vector2cd poles;
};

}  // namespace demo
