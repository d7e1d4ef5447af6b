#pragma once

namespace survey {

struct Point {
    double x = 0;
    double y = 0;
};

}  // namespace survey
