// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Data sources that read an input port, or give the last value written to an output port.
#ifndef ORO_INTERNAL_PORT_SOURCES_HPP
#define ORO_INTERNAL_PORT_SOURCES_HPP

#include <rtt/base/ChannelElementBase.hpp>
#include <rtt/base/PortInterface.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/values/placed_data_source.hpp>

#include <cstdint>

namespace RTT {
namespace internal {

/** A port, for users that may outlive it. Only one thread at a time may use a link. */
class RTT_API PortLink {
public:
    explicit PortLink(const base::PortInterface& port);
    PortLink(const PortLink&);
    ~PortLink();
    PortLink& operator=(const PortLink&) = delete;

    // As real-time safe as the functions of the port. `sample` points to a value of the port's type.
    /** Of an input port; NoData if it is gone. */
    FlowStatus read(void* sample) const;
    /** Of an output port; NotConnected if it is gone. */
    WriteStatus write(const void* sample) const;
    /** The last value written to an output port; false if there is none, or the port is gone. */
    bool last(void* sample) const;
    /** As last(), if that is not the value that `seen` names, which names this one afterwards; 0 names none. */
    bool newest(void* sample, std::uint64_t& seen) const;
    /** Of an output port; false if it is gone. */
    bool keepsLast() const;
    /** As read() for an input port, as last() for an output port; false if there is no value. */
    bool fetch(void* sample) const;

private:
    const boost::intrusive_ptr<base::ChannelElementBase> endpoint_;
    const bool input_;
};

/** The value that was read, or last written. Keeps its value when the port is gone, or has none. */
class RTT_API PortPlace final : public ValuePlace {
public:
    /** `value` is a new variable of the port's type, and `reset` restores its first value. With `orDefault` evaluate()
        uses that and is true if the port has no value; otherwise it is false then. */
    PortPlace(const PortLink& link, base::DataSourceBase* value, void (*reset)(void*), bool orDefault);

    bool evaluate() const override;
    void* value() const override;
    void* get() const override;
    void* forChange() override;
    void* raw() override;
    void assign(const void* value) override;
    void updated() override;
    bool isAssignable() const override;
    bool isFixed() const override;
    bool isPart() const override;
    ValuePlace* clone() const override;
    ValuePlace* copy(std::map<const base::DataSourceBase*, base::DataSourceBase*>& alreadyCloned) const override;

private:
    const PortLink link_;
    void* const at_;
    void (*const reset_)(void*);
    const bool or_default_;
};

template <typename T>
[[gnu::cold, gnu::noinline]] base::DataSourceBase* makePortSource(const PortLink& link, bool orDefault) {
    return new PlacedDataSource<T>(new PortPlace(link, ValueDataSource<T>::make(), &types::resetValueAt<T>, orDefault));
}

}  // namespace internal
}  // namespace RTT

#endif
