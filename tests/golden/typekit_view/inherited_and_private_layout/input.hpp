#pragma once
#include <vector>
namespace inherited_and_private_layout {
struct Stamped { long time = 0; };
class Sample : public Stamped {
public:
    Sample() {}
    void clear() { values.clear(); }
    std::vector<double> values;
    struct { int first, second; };
};
}
