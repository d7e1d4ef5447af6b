#pragma once
#include <boost/array.hpp>
#include <vector>
namespace boost_array {
struct Estimate {
    boost::array<double, 6> mean = {};
    boost::array<boost::array<double, 2>, 2> covariance = {};
    std::vector<boost::array<int, 3>> triangles;
};
}
