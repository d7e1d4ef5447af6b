// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How the arguments and the result of an operation become the request and the response of a service.
#ifndef RTT_ROSCOMM_SERVICE_FORM_HPP
#define RTT_ROSCOMM_SERVICE_FORM_HPP

#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt_roscomm/service_codec.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

namespace rtt_roscomm {

/** The values of one call. */
struct CallValues {
    RTT::OperationInterfacePart::Args arguments;
    RTT::base::DataSourceBase::shared_ptr result;  ///< null for an operation without result
};

/** One signature of operations for one type of services. A constant that any number of threads may use. The functions on
    values throw std::exception if values or bytes are wrong. */
class ServiceForm {
public:
    virtual ~ServiceForm();
    virtual RTT::internal::OperationSignature signature() const = 0;
    /** Variables for the arguments of a call. */
    virtual RTT::OperationInterfacePart::Args variables() const = 0;

    // What a server does.
    virtual void decodeRequest(const std::uint8_t* from, std::size_t size, const CallValues& into) const = 0;
    /** Throws if the operation refused. */
    virtual std::size_t responseSize(const CallValues& values) const = 0;
    virtual void encodeResponse(const CallValues& values, std::uint8_t* to, std::size_t room) const = 0;

    // What a client does.
    virtual std::size_t requestSize(const CallValues& values) const = 0;
    virtual void encodeRequest(const CallValues& values, std::uint8_t* to, std::size_t room) const = 0;
    virtual void decodeResponse(const std::uint8_t* from, std::size_t size, const CallValues& into) const = 0;
    /** Sets the result of a call that failed. */
    virtual void fail(const CallValues& values) const = 0;

    /** "bool(/a/BRequest const&, /a/BResponse &)" */
    std::string text() const;
};
typedef std::shared_ptr<const ServiceForm> Form;

/** bool(Request&, Response&). */
Form standardForm(Codec request, Codec response);

/** The other signatures for a service of std_srvs, the preferred ones first; none for other services. */
std::vector<Form> shortForms(const std::string& service);
/** That of them which fits a caller of this class; null if there is none. */
Form shortFormOfCaller(const std::string& service, const std::type_info& caller);

/** True if an operation with this signature can be called in that form. */
bool fits(const RTT::internal::OperationSignature& operation, const ServiceForm& form);
/** "double(int)" */
std::string textOf(const RTT::internal::OperationSignature& signature);

}  // namespace rtt_roscomm

#endif
