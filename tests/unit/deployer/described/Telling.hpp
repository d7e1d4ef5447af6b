// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What the user's classes of the package have in common: they tell that they are made.
#ifndef OROFORGE_TESTS_DESCRIBED_TELLING_HPP
#define OROFORGE_TESTS_DESCRIBED_TELLING_HPP

#include <rtt/Port.hpp>

#include <iostream>
#include <string>

namespace described {

template <class Base>
class Telling : public Base {
public:
    explicit Telling(const std::string& name) : Base(name) { std::cout << name + ": created\n" << std::flush; }
    ~Telling() override { this->stop(); }

protected:
    bool startHook() override {
        std::cout << this->getName() + ": started\n" << std::flush;
        return true;
    }
    void updateHook() override {}
};

/** Has a port and a property of which its manifest tells nothing. */
template <class Base>
class More : public Telling<Base> {
public:
    explicit More(const std::string& name) : Telling<Base>(name) {
        this->addPort("extra", extra_);
        this->addProperty("hidden", hidden_);
    }
    ~More() override { this->stop(); }

private:
    RTT::InputPort<int> extra_;
    int hidden_ = 0;
};

}  // namespace described

#endif
