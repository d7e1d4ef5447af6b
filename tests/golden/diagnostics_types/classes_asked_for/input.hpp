#pragma once
#include "library/rtt.hpp"
#include <vector>
namespace bad {
class Filter { double state_; };
struct Bank {
    Filter first;
    std::vector<Filter> others;
};
class Component : public RTT::TaskContext {
    RTT::OutputPort<std::vector<Filter>> filters;
    RTT::Property<double> gain;
    RTT::Property<Filter> preset;
    Filter inner;
};
struct Raw { int* pointer; };
struct RawFirst { Raw raw; };
}
