// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The typed interface of a channel element, from which transports derive.
#ifndef ORO_CHANNEL_ELEMENT_HPP
#define ORO_CHANNEL_ELEMENT_HPP

#include <rtt/base/ChannelElementBase.hpp>

namespace RTT {
namespace base {

/** Passes samples of T on. A transport overrides the typed functions that it needs; the others pass the call to its
    neighbours. write() and read() must be real-time safe to be used by real-time components. */
template <typename T>
class ChannelElement : public ChannelElementBase {
public:
    typedef boost::intrusive_ptr<ChannelElement<T>> shared_ptr;
    typedef T value_t;
    typedef const T& param_t;
    typedef T& reference_t;

    /** The neighbours, if they carry samples of T; null otherwise. */
    [[gnu::cold]] shared_ptr getInput() const;
    [[gnu::cold]] shared_ptr getOutput() const;

    /** Takes one sample. NotConnected makes the output port drop this channel. */
    virtual WriteStatus write(param_t sample);
    /** Gives one sample. Leaves `sample` untouched on NoData, and on OldData unless copy_old_data. */
    virtual FlowStatus read(reference_t sample, bool copy_old_data = true);
    /** Passes a sample that shows the size of later ones and is never delivered as data. Without `reset` stored samples
        stay. Overriding one of the two forms is enough. */
    [[gnu::cold]] virtual WriteStatus data_sample(param_t sample, bool reset);
    [[gnu::cold]] virtual WriteStatus data_sample(param_t sample);
    /** The last sample given to data_sample(), or a default one. */
    [[gnu::cold]] virtual value_t data_sample();

    WriteStatus writeErased(const void* sample) override { return write(*static_cast<const T*>(sample)); }
    FlowStatus readErased(void* sample, bool copyOld) override { return read(*static_cast<T*>(sample), copyOld); }
    [[gnu::cold]] WriteStatus sampleErased(const void* sample, bool reset) override {
        return data_sample(*static_cast<const T*>(sample), reset);
    }
};

template <typename T>
typename ChannelElement<T>::shared_ptr ChannelElement<T>::getInput() const {
    return boost::dynamic_pointer_cast<ChannelElement<T>>(ChannelElementBase::getInput());
}

template <typename T>
typename ChannelElement<T>::shared_ptr ChannelElement<T>::getOutput() const {
    return boost::dynamic_pointer_cast<ChannelElement<T>>(ChannelElementBase::getOutput());
}

// The base's untyped versions pass to the neighbour; the next typed element restores the type of the sample.

template <typename T>
WriteStatus ChannelElement<T>::write(param_t sample) {
    return ChannelElementBase::writeErased(&sample);
}

template <typename T>
FlowStatus ChannelElement<T>::read(reference_t sample, bool copy_old_data) {
    return ChannelElementBase::readErased(&sample, copy_old_data);
}

// Each form calls the other one, unless that one called it.

template <typename T>
WriteStatus ChannelElement<T>::data_sample(param_t sample, bool reset) {
    const SampleCall call(*this, reset);
    return data_sample(sample);
}

template <typename T>
WriteStatus ChannelElement<T>::data_sample(param_t sample) {
    const SampleCall* const caller = SampleCall::of(*this);
    return caller ? ChannelElementBase::sampleErased(&sample, caller->reset()) : data_sample(sample, true);
}

template <typename T>
T ChannelElement<T>::data_sample() {
    T sample = T();
    this->getSampleErased(&sample);
    return sample;
}

}  // namespace base
}  // namespace RTT

#endif
