// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The first of two files of a library with two component types: the macro of the library stands in one of them only.
#include <rtt/TaskContext.hpp>

#include <ocl/Component.hpp>

namespace Robot13 {

class Controller : public RTT::TaskContext {
public:
    explicit Controller(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace Robot13

// once:
#ifdef OLD_NAME_OF_THE_MACRO
ORO_CREATE_COMPONENT_TYPE()
#else
ORO_CREATE_COMPONENT_LIBRARY()
#endif
ORO_LIST_COMPONENT_TYPE(Robot13::Controller)
