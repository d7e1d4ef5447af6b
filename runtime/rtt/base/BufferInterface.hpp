// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A queue of samples of T.
#ifndef ORO_BUFFER_INTERFACE_HPP
#define ORO_BUFFER_INTERFACE_HPP

#include <rtt/FlowStatus.hpp>
#include <rtt/base/BufferBase.hpp>

#include <vector>

namespace RTT {
namespace base {

template <class T>
class BufferInterface : public BufferBase {
public:
    typedef boost::shared_ptr<BufferInterface<T>> shared_ptr;
    typedef T value_t;
    typedef T& reference_t;
    typedef const T& param_t;
    typedef BufferBase::size_type size_type;

    /** False if the buffer is full and not circular. */
    virtual bool Push(param_t item) = 0;
    /** Pushes in order until one does not fit; returns the number of samples taken. */
    virtual size_type Push(const std::vector<value_t>& items) = 0;
    /** NewData and the oldest sample; NoData, with `item` untouched, if empty. */
    virtual FlowStatus Pop(reference_t item) = 0;
    /** Replaces `items` by all samples; returns their number. Allocates. */
    virtual size_type Pop(std::vector<value_t>& items) = 0;
    /** Takes the oldest sample out but leaves it in its place until Release(). Null if empty. */
    virtual value_t* PopWithoutRelease() = 0;
    virtual void Release(value_t* item) = 0;
    /** Sizes the elements for samples like this one; with `reset` also empties the buffer. Not real-time safe. */
    virtual bool data_sample(param_t sample, bool reset = true) = 0;
    virtual value_t data_sample() const = 0;
};

}  // namespace base
}  // namespace RTT

#endif
