// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Data sources that read an input port, or give the last value written to an output port.
#ifndef ORO_INTERNAL_PORT_SOURCES_HPP
#define ORO_INTERNAL_PORT_SOURCES_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/DataSource.hpp>

#include <map>

namespace RTT {
namespace internal {

/** A port, for those who may outlive it. Belongs to one thread at a time. */
class RTT_API PortLink {
public:
    explicit PortLink(const base::PortInterface& port);
    PortLink(const PortLink&);
    ~PortLink();
    PortLink& operator=(const PortLink&) = delete;

    // As real-time safe as the functions of the port. `sample` is of its type.
    /** Of an input port; NoData if it is gone. */
    FlowStatus read(void* sample) const;
    /** Of an output port; NotConnected if it is gone. */
    WriteStatus write(const void* sample) const;
    /** The last value written to an output port; false if there is none, or the port is gone. */
    bool last(void* sample) const;
    /** What an input port reads, or the last value of an output port. */
    bool fetch(void* sample) const;

private:
    const boost::intrusive_ptr<base::ChannelElementBase> endpoint_;
    const bool input_;
};

/** The value that was read, or last written. When the port is gone, or has none, the one before stays. */
template <typename T>
class PortSource final : public DataSource<T> {
public:
    typedef typename DataSource<T>::result_t result_t;
    typedef typename DataSource<T>::const_reference_t const_reference_t;

    /** With `orDefault` a default value stands for one that there is not, and evaluate() is always true. */
    explicit PortSource(const PortLink& link, bool orDefault = false) : link_(link), or_default_(orDefault), value_() {}

    [[gnu::cold, gnu::noinline]] static PortSource<T>* make(const base::PortInterface& port) {
        return new PortSource<T>(PortLink(port));
    }

    /** False if the port has no value, or is gone. */
    bool evaluate() const override {
        if (link_.fetch(&value_)) return true;
        if (or_default_) types::resetValue(value_);
        return or_default_;
    }
    result_t get() const override {
        this->evaluate();
        return PortSource::value();
    }
    result_t value() const override { return types::copyOf<T>(value_); }
    const_reference_t rvalue() const override { return value_; }

    [[gnu::cold]] PortSource* clone() const override { return new PortSource(link_, or_default_); }
    [[gnu::cold]] PortSource* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>&) const override {
        return const_cast<PortSource*>(this);
    }

private:
    const PortLink link_;
    const bool or_default_;
    mutable T value_;
};

}  // namespace internal
}  // namespace RTT

#endif
