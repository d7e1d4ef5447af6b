// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/AnyDataSource.hpp>

#include <rtt/transports/corba/detail/any_values.hpp>

namespace RTT::corba {

AnyDataSource::AnyDataSource(CORBA::Any_ptr any) : ConstantDataSource(CORBA::Any_var(any)) {}
AnyDataSource::~AnyDataSource() = default;

bool AnyDataSource::assignTo(const base::DataSourceBase::shared_ptr& target) const {
    return detail::assign(rvalue().in(), target);
}

AnyDataSource* AnyDataSource::clone() const { return new AnyDataSource(new CORBA::Any(rvalue().in())); }

}  // namespace RTT::corba
