// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A static library that would have one type, as a library to be loaded; there are two of these, with another TYPE.
#include <rtt/TaskContext.hpp>

#include <ocl/Component.hpp>

namespace linked {

class TYPE : public RTT::TaskContext {
public:
    explicit TYPE(const std::string& name) : RTT::TaskContext(name) {}
};

}  // namespace linked

#define LISTED(type) ORO_CREATE_COMPONENT(type)
LISTED(linked::TYPE)
