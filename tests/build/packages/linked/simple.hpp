#pragma once
#include <rtt/Component.hpp>
#include <rtt/RTT.hpp>

/** A component type per source file. */
#define LINKED_COMPONENT(NAME)                                             \
    namespace linked {                                                     \
    struct NAME : RTT::TaskContext {                                       \
        explicit NAME(const std::string& name) : RTT::TaskContext(name) {} \
    };                                                                     \
    }                                                                      \
    ORO_CREATE_COMPONENT(linked::NAME)
