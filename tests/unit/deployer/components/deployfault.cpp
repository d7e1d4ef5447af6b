// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that throws where its property says, and has much to save.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <iostream>
#include <stdexcept>
#include <vector>

namespace deployfault {

class Throwing : public RTT::TaskContext {
public:
    explicit Throwing(const std::string& name) : RTT::TaskContext(name, PreOperational), many_(2000, 1.5) {
        addProperty("where", where_);
        addProperty("many", many_);
    }
    ~Throwing() override {
        stop();
        std::cout << getName() + ": deleted\n" << std::flush;
        throwIf("destructor");  // which ends the process, for destructors must not throw
    }

protected:
    bool configureHook() override { return throwIf("configure"); }
    bool startHook() override { return throwIf("start"); }
    void updateHook() override { throwIf("update"); }
    void stopHook() override { throwIf("stop"); }
    void cleanupHook() override { throwIf("cleanup"); }
    void exceptionHook() override { std::cout << getName() + ": exception\n" << std::flush; }

private:
    bool throwIf(const char* here) const {
        if (where_ == here) throw std::runtime_error(std::string("thrown in ") + here);
        return true;
    }

    std::string where_;
    std::vector<double> many_;
};

}  // namespace deployfault

ORO_CREATE_COMPONENT(deployfault::Throwing)
