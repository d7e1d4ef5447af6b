#include <my-pkg/my-pkg-support.hpp>

namespace my_pkg {

double limited(double value, double lowest, double highest) {
    if (value < lowest) return lowest;
    return value > highest ? highest : value;
}

}  // namespace my_pkg
