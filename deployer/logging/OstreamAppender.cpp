// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/OstreamAppender.hpp>

#include "fd_lines.hpp"

namespace OCL::logging {

OstreamAppender::OstreamAppender(std::string name)
    : Appender(name),
      maxEventsPerCycle_prop("MaxEventsPerCycle", "How many events a cycle takes at most; 0 for all.", 1) {
    addProperty(maxEventsPerCycle_prop);
}

OstreamAppender::~OstreamAppender() { stopForGood(); }

bool OstreamAppender::configureHook() {
    if (!isMaxEvents(maxEventsPerCycle_prop.get())) return false;
    hold(std::make_unique<OutputLines>(getName()));
    return configureLayout();
}

void OstreamAppender::updateHook() { processEvents(maxEventsPerCycle_prop.get()); }

}  // namespace OCL::logging
