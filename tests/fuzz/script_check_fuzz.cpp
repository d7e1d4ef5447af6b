// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Any bytes are checked as a script for a component: what is wrong is told, and the component stays as it was.
#include "fuzzing.hpp"

#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/scripting/check.hpp>

#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

using namespace RTT;

namespace {

double add(int a, double b) { return a + b; }
bool rename(const std::string& name) { return name.empty(); }

/** Its names are those of the corpus. */
struct Component : TaskContext {
    explicit Component(const std::string& name) : TaskContext(name) {
        addProperty("x", x);
        addProperty("s", s);
        addProperty("v", v);
        addPort("in", in);
        addPort("out", out);
        addOperation("f", &add);
        addOperation("g", &rename, ClientThread);
        addEventOperation(moved);
        addAttribute("i", i);
        provides("sub")->addOperation("f", &add);
    }
    double x = 1;
    int i = 0;
    std::string s;
    std::vector<double> v{1, 2, 3};
    InputPort<double> in;
    OutputPort<double> out;
    Operation<void(int)> moved{"ev"};
};

std::size_t sizeOf(Component& component) {
    return component.provides()->getProviderNames().size() + component.provides()->getNames().size() +
           component.attributes()->getAttributeNames().size();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    loadTypekit(RTT_TYPEKIT_FILE);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Component& component = *new Component("a");
    static Component& peer = *new Component("b");
    static const bool peers = component.addPeer(&peer);
    require(peers, "there is a peer");
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t before = sizeOf(component);
    std::ostringstream messages;
    const bool right = scripting::checkScriptText(text, "input", component, messages);
    require(right == (messages.str().find(": error: [") == std::string::npos), "it is right or errors are told",
            messages.str());
    require(sizeOf(component) == before, "the component is as before");
    return 0;
}
