// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_OSTREAM_APPENDER_HPP
#define ORO_OCL_OSTREAM_APPENDER_HPP

#include <ocl/Appender.hpp>

namespace OCL {
namespace logging {

/** Writes events to standard output. */
class OCL_API OstreamAppender : public Appender {
public:
    explicit OstreamAppender(std::string name);
    ~OstreamAppender() override;

protected:
    bool configureHook() override;
    void updateHook() override;

    RTT::Property<int> maxEventsPerCycle_prop;
};

}  // namespace logging
}  // namespace OCL

#endif
