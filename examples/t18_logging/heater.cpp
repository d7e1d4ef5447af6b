// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Logs to a category in its own thread, which may be a real-time one.
#include <ocl/Category.hpp>
#include <rtt/Component.hpp>
#include <rtt/Logger.hpp>
#include <rtt/TaskContext.hpp>

#include <string>

namespace oven {

class Heater : public RTT::TaskContext {
public:
    explicit Heater(const std::string& name)
        : RTT::TaskContext(name),
          category_(dynamic_cast<OCL::logging::Category*>(&log4cpp::Category::getInstance("oven.heater"))) {
        addOperation("heat", &Heater::heat, this, RTT::OwnThread)
            .doc("Turns the heating on until the oven has a temperature.")
            .arg("celsius", "in degrees");
    }

private:
    bool configureHook() override {
        if (category_) return true;
        RTT::log(RTT::Error) << "'oven.heater' is no category of OCL" << RTT::endlog();
        return false;
    }

    void heat(int celsius) {
        category_->debug("the heating is on");
        if (celsius > 250) category_->getRTStream(log4cpp::Priority::WARN) << celsius << " degrees are more than usual";
        category_->getRTStream(log4cpp::Priority::INFO) << "the oven has " << celsius << " degrees";
    }

    OCL::logging::Category* const category_;
};

}  // namespace oven

ORO_CREATE_COMPONENT(oven::Heater)
