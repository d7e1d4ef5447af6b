// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_SERVICE_PART_HPP
#define ORO_CORBA_DETAIL_SERVICE_PART_HPP

#include <rtt/transports/corba/detail/served_component.hpp>

#include <utility>

namespace RTT {
namespace corba {
namespace detail {

/** What the servants of a service's parts have in common; a virtual base, so that the servant of the whole has one. */
class ServicePart {
protected:
    ServicePart(Served served, Service::shared_ptr service)
        : served_(std::move(served)), service_(std::move(service)) {}
    ~ServicePart() = default;

    const Served served_;
    const Service::shared_ptr service_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
