// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_REPORTING_SOURCE_HPP
#define ORO_OCL_REPORTING_SOURCE_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/internal/engine/engine_gate.hpp>
#include <rtt/internal/flow/port_sources.hpp>

#include <memory>
#include <string>

namespace OCL::reporting {

/** A port, property or attribute that is reported, and its last value. */
class Source {
public:
    typedef RTT::base::DataSourceBase::shared_ptr Value;

    /** An output of a peer, which is connected to `port`. */
    Source(const std::string& component, std::string path, std::unique_ptr<RTT::base::InputPortInterface> port,
           Value sample);
    typedef boost::intrusive_ptr<const RTT::internal::EngineGate> Gate;
    /** A value of a peer, which has that gate. Once the peer is gone, the last value stays. */
    Source(const std::string& component, std::string path, Value original, Gate peer, Value sample);

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

    /** The description of the port or property. */
    const std::string& description() const { return description_; }
    void describe(const std::string& text) { description_ = text; }

    /** Must be called before read(). If a port never had a sample, its value gets the size that the writer set by
        setDataSample(); a report that starts again begins with the last sample that was read. */
    void prepare();
    /** Copies the present value; true if it is a new sample of a port. Real-time safe if copying the value is. Called
        by one thread at a time. */
    bool read();
    /** Drops samples that were not read yet. */
    void clear();

private:
    const std::string component_, path_, name_;
    std::string description_;
    const std::unique_ptr<RTT::base::InputPortInterface> port_;
    const std::unique_ptr<RTT::internal::PortLink> link_;  // reads without looking the type up each time
    const Value original_;
    const Gate peer_;
    const Value sample_;
    void* const address_;     // the address of the sample
    bool hasSample_ = false;  // sample_ is from the port; clear() leaves it so
};

}  // namespace OCL::reporting

#endif
