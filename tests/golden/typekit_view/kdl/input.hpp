#pragma once
#include <kdl/frames.hpp>
#include <kdl/jacobian.hpp>
#include <kdl/jntarray.hpp>
#include <vector>

namespace demo {

typedef KDL::Twist Twist;

struct Arm {
    KDL::Frame tool;
    KDL::Wrench load;
    std::vector<KDL::Vector> path;
    KDL::JntArray joints;
    KDL::Jacobian jacobian;
    std::vector<KDL::Frame> links;
};

}  // namespace demo
