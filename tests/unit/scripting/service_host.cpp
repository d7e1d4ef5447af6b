// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "service_host.hpp"

#include <rtt/Logger.hpp>
#include <rtt/extras/SlaveActivity.hpp>
#include <rtt/plugin/PluginLoader.hpp>

#include <regex>
#include <stdexcept>

namespace service_test {

Host::Host(const std::string& name) : RTT::TaskContext(name) {
    setActivity(new RTT::extras::SlaveActivity(0.01));
    addAttribute("count", count);
    addOperation("note", &Host::note, this);
    addOperation("fail", &Host::fail, this);
    addOperation("refuse", [] { return false; });
}

int Host::fail() { throw std::runtime_error("the arm is stuck"); }

void Host::step(int times) {
    for (int i = 0; i != times; ++i) ASSERT_TRUE(update());
}

ServiceTest::ServiceTest() {
    const auto loader = RTT::plugin::PluginLoader::Instance();
    EXPECT_TRUE(loader->loadLibrary(RTT_TYPEKIT_FILE));
    EXPECT_TRUE(loader->loadLibrary(RTT_SCRIPTING_FILE));
    RTT::Logger::Instance()->setLogLevel(RTT::Logger::Warning);
    service = host.getProvider<RTT::scripting::ScriptingService>("scripting");
    EXPECT_TRUE(service);
    logged();
}

std::string ServiceTest::logged() {
    const std::string text = log_.text().substr(seen_);
    seen_ += text.size();
    return std::regex_replace(text, std::regex("(^|\n)[0-9.]+ \\[ *([A-Za-z]+) *\\]\\[[^\\]]*\\] "), "$1$2: ");
}

}  // namespace service_test
