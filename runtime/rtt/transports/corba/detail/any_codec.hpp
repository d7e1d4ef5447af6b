// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_ANY_CODEC_HPP
#define ORO_CORBA_DETAIL_ANY_CODEC_HPP

#include <omniORB4/CORBA.h>

#include <rtt/encoding/Plan.hpp>

#include <memory>
#include <string>

namespace RTT {
namespace types {
class TypeInfo;
}
namespace corba {
namespace detail {

/** Puts values of a type into a CORBA::Any and takes them out. A constant that any number of threads may use. */
class AnyCodec {
public:
    /** Null, with the reason in `why`, if the type, or a part of it, has no shape. Allocates. */
    static std::shared_ptr<const AnyCodec> make(const types::TypeInfo& type, CORBA::ORB_ptr orb, std::string& why);

    /** Borrowed. */
    CORBA::TypeCode_ptr typeCode() const { return typeCode_.in(); }
    /** Every value is a number of at most eight bytes, so that get() changes nothing if it fails. */
    bool isNumber() const { return isNumber_; }
    /** False, with the Any unchanged, if the value cannot be encoded. Allocates. */
    bool put(const void* value, CORBA::Any& any) const;
    /** False, with the reason in `why`, if the Any has another type, or bytes that are no value of it; the value is
        then some valid value. */
    bool get(const CORBA::Any& any, void* value, std::string& why) const;

private:
    AnyCodec(std::shared_ptr<const encoding::Plan> plan, CORBA::TypeCode_var typeCode);

    const std::shared_ptr<const encoding::Plan> plan_;
    const CORBA::TypeCode_var typeCode_;
    const std::size_t fixedSize_;  // of all values, or 0
    const bool isNumber_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
