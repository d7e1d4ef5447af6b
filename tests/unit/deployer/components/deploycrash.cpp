// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A component that crashes where its property says.
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

#include <cstdlib>

namespace deploycrash {

class Crashing : public RTT::TaskContext {
public:
    explicit Crashing(const std::string& name) : RTT::TaskContext(name, PreOperational) {
        addProperty("where", where_);
        addOperation("crash", &Crashing::crash, this, RTT::OwnThread);
    }

protected:
    bool configureHook() override {
        if (where_ == "configure") crash();
        return where_ != "deep configure" || dive(0) == 0;
    }
    void updateHook() override {
        if (where_ == "update") crash();
        if (where_ == "abort") std::abort();
        if (where_ == "deep update") (void)dive(0);
    }

private:
    void crash() {
        volatile int* nowhere = nullptr;
        *nowhere = 1;
    }

    /** Calls itself until the stack is used up. */
    int dive(int depth) {
        volatile char room[512];
        room[depth % 512] = 1;
        return where_.empty() ? room[0] : dive(depth + 1) + room[depth % 512];
    }

    std::string where_;
};

}  // namespace deploycrash

ORO_CREATE_COMPONENT(deploycrash::Crashing)
