// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_READ_VALUE_HPP
#define RTT_ROSPARAM_DETAIL_READ_VALUE_HPP

#include "failure.hpp"
#include "shapes.hpp"

#include <rtt/base/PropertyBase.hpp>
#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <string_view>

namespace RTT {
class PropertyBag;
}

namespace rtt_rosparam {

/** Makes parameters of values. */
class Reader {
public:
    typedef XmlRpc::XmlRpcValue Value;

    /** `name` is that of the parameter, for messages. */
    explicit Reader(std::string name) : path_(std::move(name)) {}

    /** The present value of a property. Throws Failure. */
    Value read(const RTT::base::PropertyBase& property);
    /** The value at this address. Throws Failure. */
    Value read(const char* type, const void* from);

private:
    typedef RTT::types::Shape Shape;

    template <class Part>
    Value within(const std::string& part, Part readPart);
    Value readNumber(const char* type, Shape::Number number, const void* from);
    template <class Number>
    Value whole(const char* type, Number number);
    Value readText(const char* type, std::string_view text);
    Value readEnumerator(const char* type, const Shape& shape, const void* from);
    Value readStruct(const Shape& shape, const void* from);
    Value readField(const Shape::Field& field, const void* from);
    Value readPart(const char* type, const RTT::types::SequenceOps& ops, const void* from, std::size_t index);
    Value readSequence(const RTT::types::SequenceOps& ops, const void* from);
    Value readVariant(const char* type, const Shape& shape, const void* from);
    Value readShown(const char* type, const Shape& shape, const void* from);
    Value readBag(const RTT::PropertyBag& bag);
    Value readDecomposed(const char* type, const Shape& shape, const void* from);
    [[noreturn]] void refuse(const char* type, const std::string& why) const;

    Shapes shapes_;
    std::string path_;
    unsigned depth_ = 0;
};

/** False if an item of that name cannot be a parameter. */
bool isParameterName(const std::string& name);

}  // namespace rtt_rosparam

#endif
