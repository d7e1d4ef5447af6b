#pragma once
namespace demo {
struct Stamped { long time = 0; };
template <class Derived> struct Counted { int count = 0; };
struct Named { char name[8]; };
struct Sample : Stamped, Named {
    double value = 0;
};
struct Curious : Counted<Curious> { int own = 0; };
class Open : public Sample {
public:
    Open() : extra(1) {}
    double sum() const { return value + extra; }
    int extra;
};
}
