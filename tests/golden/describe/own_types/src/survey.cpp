#include "survey.hpp"

namespace survey {

namespace {
struct Trace {
    int line = 0;
};
Trace lastTrace() { return {}; }
}  // namespace

Survey::Survey(const std::string& name) : RTT::TaskContext(name) {
    addPort("points", points_);
    addPort("mean", mean_);
    addProperty("settings", settings_);
    addOperation("check", &Survey::check, this);
    addOperation("trace", &lastTrace);
}

bool Survey::check(const Rated<int>&, Quality*) { return true; }

}  // namespace survey
