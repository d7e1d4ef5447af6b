// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_TYPE_TRANSPORTER_HPP
#define ORO_CORBA_TYPE_TRANSPORTER_HPP

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/transports/corba/CorbaLib.hpp>
#include <rtt/transports/corba/ServiceC.h>
#include <rtt/transports/corba/corba.h>
#include <rtt/types/TypeTransporter.hpp>

#include <string>

namespace RTT {
class DataFlowInterface;
namespace corba {

class CRemoteChannelElement_i;

/** Converts values of one type to and from CORBA::Any. Any thread may use it. */
class RTT_API CorbaTypeTransporter : public types::TypeTransporter {
public:
    /** The value of the last evaluation of `source`. The caller owns the result; null if it cannot be converted. */
    virtual CORBA::Any_ptr createAny(base::DataSourceBase::shared_ptr source) const = 0;
    virtual bool updateAny(base::DataSourceBase::shared_ptr source, CORBA::Any& any) const = 0;
    /** A new variable; null if the value is of another type. */
    virtual base::DataSourceBase::shared_ptr createDataSource(const CORBA::Any* any) const = 0;
    /** False, with the target unchanged, if the value is of another type. */
    virtual bool updateFromAny(const CORBA::Any* any, base::DataSourceBase::shared_ptr target) const = 0;

    // The library does not call the following three: it has one channel and one remote value for all types. They call
    // the other process and block. What fails is logged.
    /** A new end of a channel; null if there is none for the type. */
    virtual CRemoteChannelElement_i* createChannelElement_i(DataFlowInterface* sender, PortableServer::POA_ptr poa,
                                                            const ConnPolicy& policy) const;
    /** A source whose value is that property of the other process: every reading fetches it, every change stores it.
        Null if there is no such property, or if it is of another type. */
    virtual base::DataSourceBase::shared_ptr createPropertyDataSource(CService_ptr service, const std::string& name);
    /** The same for an attribute, whose value can only be changed if `assignable`. */
    virtual base::DataSourceBase::shared_ptr createAttributeDataSource(CService_ptr service, const std::string& name,
                                                                       bool assignable);

    /** Null: CORBA has no streams. */
    base::ChannelElementBase::shared_ptr createStream(base::PortInterface* port, const ConnPolicy& policy,
                                                      bool is_sender) const override;
};

}  // namespace corba
}  // namespace RTT

#endif
