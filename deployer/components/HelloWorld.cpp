// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/HelloWorld.hpp>

#include <ocl/Component.hpp>
#include <rtt/Activity.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/Logger.hpp>

#include <iostream>
#include <sstream>

namespace OCL {
namespace {

const char* const kConstant = "Hello Constant";

RTT::Activity* tenPerSecond(const std::string& name) {
    RTT::Activity::Options options;
    options.name = name;
    options.priority = 0;
    options.period = 0.1;
    return new RTT::Activity(options);
}

}  // namespace

HelloWorld::HelloWorld(std::string name)
    : RTT::TaskContext(name, PreOperational),
      buffer_("the_buffer_port", RTT::ConnPolicy::buffer(13, RTT::ConnPolicy::LOCK_FREE, true)) {
    setActivity(tenPerSecond(name));
    addProperty("the_property", property_).doc("A friendly property.");
    addAttribute("flag", flag_);
    addAttribute("the_attribute", attribute_);
    addConstant("the_constant", std::string(kConstant));
    addPort(results_).doc("\"Hello World!\", in each cycle.");
    addPort(buffer_).doc("What comes in here goes to the log, at level Debug.");
    addOperation("the_method", &HelloWorld::theMethod, this).doc("Says hello, in the thread of the caller.");
    addOperation("the_command", &HelloWorld::theCommand, this, RTT::OwnThread)
        .doc("Says hello to somebody, in the thread of this component.")
        .arg("the_arg", "Whom; for \"World\" the answer is true");
}

HelloWorld::~HelloWorld() { stopForGood(); }

std::string HelloWorld::theMethod() { return "Hello World"; }

bool HelloWorld::theCommand(const std::string& arg) {
    std::cout << "Saying Hello '" << arg << "' in own thread." << std::endl;
    return arg == "World";
}

void HelloWorld::updateHook() {
    if (flag_) {
        // Written in one piece, so that output of other threads does not come in between.
        std::ostringstream text;
        text << "flag: " << flag_ << "\nthe_property: " << property_ << "\nthe_attribute: " << attribute_
             << "\nthe_constant: " << kConstant << "\nSetting 'flag' back to false.\n";
        std::cout << text.str() << std::flush;
        flag_ = false;
    }
    results_.write("Hello World!");
    std::string received;
    while (buffer_.read(received) == RTT::NewData) RTT::log(RTT::Debug) << "Received " << received << RTT::endlog();
}

}  // namespace OCL

ORO_CREATE_COMPONENT(OCL::HelloWorld)
