#ifndef OROCOS_MY_PKG_SUPPORT_HPP
#define OROCOS_MY_PKG_SUPPORT_HPP

namespace my_pkg {

/// `value`, or the nearer of the two limits if it lies outside of them.
double limited(double value, double lowest, double highest);

}  // namespace my_pkg

#endif
