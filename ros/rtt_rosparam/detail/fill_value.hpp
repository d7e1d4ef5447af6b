// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_FILL_VALUE_HPP
#define RTT_ROSPARAM_DETAIL_FILL_VALUE_HPP

#include "failure.hpp"
#include "shapes.hpp"

#include <rtt/base/PropertyBase.hpp>
#include <xmlrpcpp/XmlRpcValue.h>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
class PropertyBag;
}

namespace rtt_rosparam {

/** Sets values from parameters. All or nothing: a property that is prepared changes only in commit(). */
class Filler {
public:
    /** `name` is that of the parameter, for messages. */
    explicit Filler(std::string name) : path_(std::move(name)) {}

    /** Prepares the new value of a property. Throws Failure. */
    void prepare(RTT::base::PropertyBase& property, const XmlRpc::XmlRpcValue& from);
    /** Assigns the values that were prepared. */
    void commit();

    /** Sets the value at this address, at once. It is some valid value if Failure is thrown. */
    void fill(const char* type, const XmlRpc::XmlRpcValue& from, void* to);

private:
    typedef RTT::types::Shape Shape;
    typedef XmlRpc::XmlRpcValue Value;
    struct Pending {
        RTT::base::PropertyBase* property;
        std::unique_ptr<RTT::base::PropertyBase> value;
    };

    template <class Part>
    void within(const std::string& part, Part fillPart);
    template <class Number>
    void fillReal(const char* type, const Value& from, void* to);
    template <class Number>
    void fillWhole(const char* type, const Value& from, void* to);
    void fillNumber(const char* type, Shape::Number number, const Value& from, void* to);
    void fillEnumerator(const char* type, const Shape& shape, const Value& from, void* to);
    void fillStruct(const char* type, const Shape& shape, const Value& from, void* to);
    void fillField(const Shape::Field& field, const Value& from, void* to);
    void fillSequence(const char* type, const RTT::types::SequenceOps& ops, const Value& from, void* to);
    void fillElement(const RTT::types::SequenceOps& ops, const Value& from, void* to, std::size_t index);
    void fillPart(const char* type, const RTT::types::SequenceOps& ops, const Value& from, void* to, std::size_t index);
    void fillVariant(const char* type, const Shape& shape, const Value& from, void* to);
    void fillShown(const char* type, const Shape& shape, const Value& from, void* to);
    void prepareBag(const char* type, RTT::PropertyBag& bag, const Value& from);
    void fillBag(const char* type, RTT::PropertyBag& bag, const Value& from);
    void fillDecomposed(const char* type, const Shape& shape, const Value& from, void* to);
    [[noreturn]] void refuse(const char* type, const Value& from, const std::string& why = "") const;

    Shapes shapes_;
    std::string path_;
    std::string property_;  // for messages: its name and type
    std::vector<Pending> pending_;
    unsigned depth_ = 0;
};

}  // namespace rtt_rosparam

#endif
