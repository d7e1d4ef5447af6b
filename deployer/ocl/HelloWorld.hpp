// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_HELLO_WORLD_HPP
#define ORO_OCL_HELLO_WORLD_HPP

#include <ocl/OCL.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/rtt-config.h>

#include <string>

namespace OCL {

/** A component with one of everything that an interface may have, to try things. It has ten cycles a second. */
class OCL_API HelloWorld : public RTT::TaskContext {
public:
    explicit HelloWorld(std::string name);
    ~HelloWorld() override;

protected:
    void updateHook() override;

private:
    std::string theMethod();
    bool theCommand(const std::string& arg);

    std::string property_ = "Hello Property";
    bool flag_ = false;
    std::string attribute_ = "Hello Attribute";
    RTT::OutputPort<std::string> results_{"the_results", true};
    RTT::InputPort<std::string> buffer_;
};

}  // namespace OCL

#endif
