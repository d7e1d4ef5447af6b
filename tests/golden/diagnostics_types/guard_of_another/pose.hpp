#ifndef POSE_HPP
#define POSE_HPP
struct Pose { double x; };
#endif
