// A copy.
#ifndef POSE_HPP
#define POSE_HPP
struct Twist { double v; };
#endif
