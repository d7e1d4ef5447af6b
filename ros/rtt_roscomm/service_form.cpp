// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_roscomm/service_form.hpp>

#include <rtt/internal/DataSources.hpp>
#include <rtt/types/Types.hpp>

#include <boost/core/demangle.hpp>

#include <stdexcept>
#include <utility>

namespace rtt_roscomm {

namespace {

using RTT::internal::AssignableDataSource;
using RTT::internal::DataSource;
using RTT::internal::OperationSignature;
typedef RTT::base::DataSourceBase::shared_ptr Source;
typedef RTT::OperationInterfacePart::Args Args;

OperationSignature::Value valueOf(const MessageCodec& codec, bool isConst, const char* name) {
    OperationSignature::Value value;
    value.type = codec.info();
    value.id = &codec.type();
    value.typeName = codec.typeName();
    value.isConst = isConst;
    value.isReference = true;
    value.name = name;
    return value;
}

OperationSignature::Value boolResult() {
    OperationSignature::Value value;
    value.id = &typeid(bool);
    value.type = RTT::types::Types()->getTypeById(value.id);
    value.typeName = "bool";
    return value;
}

void setResult(const Source& result, bool value) {
    if (auto* const variable = AssignableDataSource<bool>::narrow(result.get())) variable->set(value);
}

void refuseFalse(const Source& result) {
    auto* const value = DataSource<bool>::narrow(result.get());
    if (value && !value->value()) throw std::runtime_error("it returned false");
}

class StandardForm final : public ServiceForm {
public:
    StandardForm(Codec request, Codec response) : request_(std::move(request)), response_(std::move(response)) {}

    OperationSignature signature() const override {
        OperationSignature signature;
        signature.result = boolResult();
        signature.arguments = {valueOf(*request_, true, "request"), valueOf(*response_, false, "response")};
        return signature;
    }
    Args variables() const override { return {request_->makeVariable(), response_->makeVariable()}; }

    void decodeRequest(const std::uint8_t* from, std::size_t size, const CallValues& into) const override {
        request_->decode(from, size, into.arguments[0]->getRawPointer());
        response_->clear(into.arguments[1]->getRawPointer());
    }
    std::size_t responseSize(const CallValues& values) const override {
        refuseFalse(values.result);
        return response_->size(values.arguments[1]->getRawConstPointer());
    }
    void encodeResponse(const CallValues& values, std::uint8_t* to, std::size_t room) const override {
        response_->encode(values.arguments[1]->getRawConstPointer(), to, room);
    }

    std::size_t requestSize(const CallValues& values) const override {
        return request_->size(values.arguments[0]->getRawConstPointer());
    }
    void encodeRequest(const CallValues& values, std::uint8_t* to, std::size_t room) const override {
        request_->encode(values.arguments[0]->getRawConstPointer(), to, room);
    }
    void decodeResponse(const std::uint8_t* from, std::size_t size, const CallValues& into) const override {
        response_->decode(from, size, into.arguments[1]->getRawPointer());
        into.arguments[1]->updated();
        setResult(into.result, true);
    }
    void fail(const CallValues& values) const override { setResult(values.result, false); }

private:
    const Codec request_, response_;
};

bool isSame(const OperationSignature::Value& found, const OperationSignature::Value& wanted) {
    if (found.isPointer) return false;
    if (found.id && wanted.id) return *found.id == *wanted.id;
    return found.type ? found.type == wanted.type : found.typeName == wanted.typeName;
}

}  // namespace

ServiceForm::~ServiceForm() = default;
std::string ServiceForm::text() const { return textOf(signature()); }

Form standardForm(Codec request, Codec response) {
    return std::make_shared<StandardForm>(std::move(request), std::move(response));
}

bool fits(const OperationSignature& operation, const ServiceForm& form) {
    const OperationSignature wanted = form.signature();
    if (operation.arguments.size() != wanted.arguments.size()) return false;
    if (wanted.result.isVoid() ? !operation.result.isVoid() : !isSame(operation.result, wanted.result)) return false;
    for (std::size_t i = 0; i != wanted.arguments.size(); ++i) {
        if (!isSame(operation.arguments[i], wanted.arguments[i])) return false;
        // What the operation shall give has to be assigned. What it receives may be: "bool(Request&, Response&)".
        if (wanted.arguments[i].isOutput() && !operation.arguments[i].isOutput()) return false;
    }
    return true;
}

std::string textOf(const OperationSignature& signature) {
    std::string text = signature.result.text() + "(";
    const char* separator = "";
    for (const auto& argument : signature.arguments) {
        text += separator + argument.text();
        separator = ", ";
    }
    return text + ")";
}

}  // namespace rtt_roscomm
