// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component with a property that holds classes of a library.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>
#include <t09_adapters/typekit/Types.hpp>

#include <iostream>

class Robot : public RTT::TaskContext {
public:
    explicit Robot(const std::string& name) : TaskContext(name) {
        addProperty("arm", arm).doc("Where it is, and where it goes.");
        addOperation("show", &Robot::show, this);
    }

private:
    void show() {
        std::cout << "C++ sees the base at " << arm.base[0] << " " << arm.base[1] << "\n";
        for (int i = 0; i != arm.path.length(); ++i)
            std::cout << "C++ sees a point at " << arm.path.at(i)[0] << " " << arm.path.at(i)[1] << "\n";
    }

    arm::Arm arm;
};

ORO_CREATE_COMPONENT(Robot)
