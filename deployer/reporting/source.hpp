// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_SOURCE_HPP
#define ORO_OCL_REPORTING_SOURCE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/PortSources.hpp>

#include <memory>
#include <string>

namespace OCL::reporting {

/** A port, or a property or attribute, that is reported, and the value that was read from it last. */
class Source {
public:
    typedef RTT::base::DataSourceBase::shared_ptr Value;

    /** What comes in through `port`. */
    Source(std::string name, std::unique_ptr<RTT::base::InputPortInterface> port, Value sample);
    /** A value of another component, which must live as long as it is read. */
    Source(std::string name, Value original, Value sample);

    /** "Component.port" */
    const std::string& name() const { return name_; }
    /** Null for values. */
    RTT::base::InputPortInterface* port() const { return port_.get(); }
    const Value& sample() const { return sample_; }

    /** The first read(). If a port has no sample yet, its value gets the size that the writer announced by setDataSample(). */
    void prepare();
    /** Takes the present value over; true if it is a sample of a port that was not read before. Real-time safe if copying
        the value is. For one thread at a time. */
    bool read();
    /** Forgets samples that were not read yet. */
    void clear();

private:
    const std::string name_;
    const std::unique_ptr<RTT::base::InputPortInterface> port_;
    const std::unique_ptr<RTT::internal::PortLink> link_;  // reads without looking the type up each time
    const Value original_;
    const Value sample_;
    void* const address_;  // of the sample
};

}  // namespace OCL::reporting

#endif
