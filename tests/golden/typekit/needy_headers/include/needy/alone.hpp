#pragma once
namespace needy {
struct Alone {
    double pose = 0;
    int Tool = 0;
};
}
