// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "category_name.hpp"

#include <ocl/Category.hpp>

namespace OCL::logging {

std::string writerOf(RTT::base::ChannelElementBase& channel) {
    const RTT::base::ChannelElementBase::shared_ptr end = channel.getInputEndPoint();
    const RTT::base::PortInterface* const port = end ? end->getPort() : nullptr;
    if (const auto* const own = dynamic_cast<const Category::Port*>(port)) return own->category;
    return port ? port->getName() : std::string("unknown");
}

}  // namespace OCL::logging
