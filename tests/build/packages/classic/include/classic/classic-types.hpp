#ifndef CLASSIC_TYPES_HPP
#define CLASSIC_TYPES_HPP
#include <string>
#include <vector>
namespace classic {
struct Point { double x, y; };
struct Track {
    std::string name;
    std::vector<Point> points;
    double weights[3];
};
}
#endif
