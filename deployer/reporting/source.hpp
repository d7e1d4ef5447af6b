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

    /** What a peer sends, which comes in through `port`. */
    Source(const std::string& component, std::string path, std::unique_ptr<RTT::base::InputPortInterface> port,
           Value sample);
    /** A value of a peer, which must live as long as it is read. */
    Source(const std::string& component, std::string path, Value original, Value sample);

    /** "Component.service.port" */
    const std::string& name() const { return name_; }
    const std::string& component() const { return component_; }
    /** "service.port" */
    const std::string& path() const { return path_; }
    /** Null for values. */
    RTT::base::InputPortInterface* port() const { return port_.get(); }
    /** Null for ports. */
    const Value& original() const { return original_; }
    const Value& sample() const { return sample_; }

    /** The first read(). If a port has no sample yet, its value gets the size that the writer announced by setDataSample(). */
    void prepare();
    /** Takes the present value over; true if it is a sample of a port that was not read before. Real-time safe if copying
        the value is. For one thread at a time. */
    bool read();
    /** Forgets samples that were not read yet. */
    void clear();

private:
    const std::string component_, path_, name_;
    const std::unique_ptr<RTT::base::InputPortInterface> port_;
    const std::unique_ptr<RTT::internal::PortLink> link_;  // reads without looking the type up each time
    const Value original_;
    const Value sample_;
    void* const address_;  // of the sample
};

}  // namespace OCL::reporting

#endif
