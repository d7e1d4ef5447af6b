// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_ANY_DATA_SOURCE_HPP
#define ORO_CORBA_ANY_DATA_SOURCE_HPP

#include <rtt/internal/DataSources.hpp>
#include <rtt/transports/corba/corba.h>

namespace RTT {
namespace corba {

/** A value of another process as it came, for those who do not know its type. It does not block. */
class RTT_API AnyDataSource : public internal::ConstantDataSource<CORBA::Any_var> {
public:
    /** Owns `any`, which is not null. */
    explicit AnyDataSource(CORBA::Any_ptr any);
    ~AnyDataSource() override;

    /** Assigns the value to a source of its type. False, with the target unchanged, for another type. */
    bool assignTo(const base::DataSourceBase::shared_ptr& target) const;
    AnyDataSource* clone() const override;
};

}  // namespace corba
}  // namespace RTT

#endif
