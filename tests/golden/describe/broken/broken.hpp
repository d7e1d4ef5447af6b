#pragma once
#include <rtt/TaskContext.hpp>

#include <no/such_header.hpp>

class Broken : public RTT::TaskContext {
public:
    explicit Broken(const std::string& name) : TaskContext(name) { addProperty("value", valu_); }

private:
    int value_ = 0;
};
