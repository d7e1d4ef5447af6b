#pragma once
namespace needy {
struct Point {
    double x = 0, y = 0;
};
}
