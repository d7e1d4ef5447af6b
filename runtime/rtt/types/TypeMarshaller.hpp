// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_MARSHALLER_HPP
#define ORO_TYPE_MARSHALLER_HPP

#include <rtt/base/DataSourceBase.hpp>
#include "TypeTransporter.hpp"
#include <utility>

namespace RTT {
namespace types {

/** A transporter that turns samples into blocks of bytes and back. */
class RTT_API TypeMarshaller : public TypeTransporter {
public:
    /** Storage that a stream needs between calls; null if it needs none. */
    virtual void* createCookie() const;
    virtual void deleteCookie(void* cookie) const;

    /** Writes the sample to `blob` (of `size` bytes) or returns its own memory: start and length. (null, 0) on
        failure. */
    virtual std::pair<void const*, int> fillBlob(base::DataSourceBase::shared_ptr source, void* blob, int size,
                                                 void* cookie) const = 0;
    /** Reads a sample from `size` bytes; false if they are not a valid sample. */
    virtual bool updateFromBlob(const void* blob, int size, base::DataSourceBase::shared_ptr target,
                                void* cookie) const = 0;
    /** The number of bytes of such a sample. */
    virtual unsigned int getSampleSize(base::DataSourceBase::shared_ptr sample, void* cookie) const = 0;
};

}  // namespace types
}  // namespace RTT

#endif
