// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Tells an application that the deployer ends.
#include "shutdown.hpp"

#include <rtt/Logger.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/Property.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/engine/other_order.hpp>

#include <boost/function.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

namespace OCL::deploy {

using RTT::endlog;
using RTT::log;

namespace {

const char kPeer[] = "shutdownPeer";
const char kWait[] = "shutdownWait_ms";
const char kTotal[] = "shutdownTotalWait_ms";

/** The value of the user's property, or `usual` without the property; also, with a warning, if its value is invalid. */
template <class T, class IsGood>
T valueOr(const RTT::PropertyBag& properties, const char* name, const T& usual, const char* expected, IsGood isGood) {
    const RTT::base::PropertyBase* const property = properties.find(name);
    if (!property) return usual;
    const auto* const typed = dynamic_cast<const RTT::Property<T>*>(property);
    if (typed && isGood(typed->rvalue())) return typed->rvalue();
    log(RTT::Warning) << "property '" << name << "' of the deployer has type " << property->getType() << " and value "
                      << property->getDataSource() << ", expected " << expected << "; " << usual << " is used"
                      << endlog();
    return usual;
}

/** Begins the shutdown of an application, by its operation or its program. Returns a function that tells whether that
    is still running; an empty one if the application has neither, or it did not start. */
boost::function<bool()> beginShutdown(RTT::TaskContext& application, RTT::ExecutionEngine* caller) {
    const std::string name = "shutdownDeployment";
    if (application.provides()->hasOperation(name)) {
        RTT::OperationCaller<void()> shutdown(application.provides()->findOperation(name), caller);
        if (!shutdown.ready()) return {};
        RTT::SendHandle<void()> handle = shutdown.send();
        return [handle]() mutable { return handle.collectIfDone() == RTT::SendNotReady; };
    }
    const RTT::Service::shared_ptr program = application.provides()->getService(name);
    if (!program) return {};
    RTT::OperationCaller<bool()> start(program->getOperation("start"), caller);
    RTT::OperationCaller<bool()> running(program->getOperation("isRunning"), caller);
    if (!start.ready() || !running.ready() || !start()) return {};
    return [running]() mutable { return running(); };
}

}  // namespace

std::vector<std::string> shutdownProperties() { return {kPeer, kWait, kTotal}; }

void shutDownApplication(RTT::TaskContext& deployer) {
    const RTT::PropertyBag& properties = *deployer.properties();
    const char* const number = "an int above 0";
    const auto isPositive = [](int value) { return value > 0; };
    const std::string peer =
        valueOr<std::string>(properties, kPeer, "Application", "a string", [](const auto&) { return true; });
    const int total = valueOr(properties, kTotal, 2000, number, isPositive);
    int wait = valueOr(properties, kWait, std::min(50, total), number, isPositive);
    if (wait > total) {
        log(RTT::Warning) << kWait << " is longer than " << kTotal << ": it looks once, at the end" << endlog();
        wait = total;
    }
    RTT::TaskContext* const application = deployer.getPeer(peer);
    if (!application) {
        if (properties.find(kPeer))
            log(RTT::Warning) << "there is no component '" << peer << "', which " << kPeer << " names" << endlog();
        return;
    }
    const boost::function<bool()> goesOn = beginShutdown(*application, deployer.engine());
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(total);
    while (goesOn && goesOn()) {
        if (std::chrono::steady_clock::now() >= end) {
            log(RTT::Error) << "component '" << peer << "' did not end its shutdown within " << total << " ms"
                            << endlog();
            return;
        }
        if (RTT::internal::OtherOrder::executedHere()) continue;
        std::this_thread::sleep_until(
            std::min(end, std::chrono::steady_clock::now() + std::chrono::milliseconds(wait)));
    }
}

}  // namespace OCL::deploy
