// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The signatures that need no type of std_srvs.
#include <rtt/OperationCaller.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/service_form.hpp>

#include <cstring>
#include <stdexcept>

namespace rtt_roscomm {

namespace {

using RTT::OperationCaller;
using RTT::internal::AssignableDataSource;
using RTT::internal::DataSource;
using RTT::internal::OperationSignature;
using RTT::internal::ValueDataSource;
typedef RTT::base::DataSourceBase::shared_ptr Source;
typedef RTT::OperationInterfacePart::Args Args;

enum class Result { None, Bool, Text };

/** A request has a bool or nothing, a response a bool and a text or nothing. */
struct Row {
    const char* service;
    Result result;
    bool takesFlag, givesMessage;
    const std::type_info& caller;

    bool hasStatus() const { return std::strcmp(service, "std_srvs/Empty") != 0; }
};

const Row rows[] = {
    {"std_srvs/Empty", Result::Bool, false, false, typeid(OperationCaller<bool()>)},
    {"std_srvs/Empty", Result::None, false, false, typeid(OperationCaller<void()>)},
    {"std_srvs/SetBool", Result::Bool, true, true, typeid(OperationCaller<bool(bool, std::string&)>)},
    {"std_srvs/SetBool", Result::Bool, true, false, typeid(OperationCaller<bool(bool)>)},
    {"std_srvs/SetBool", Result::Text, true, false, typeid(OperationCaller<std::string(bool)>)},
    {"std_srvs/SetBool", Result::None, true, false, typeid(OperationCaller<void(bool)>)},
    {"std_srvs/Trigger", Result::Bool, false, true, typeid(OperationCaller<bool(std::string&)>)},
    {"std_srvs/Trigger", Result::Bool, false, false, typeid(OperationCaller<bool()>)},
    {"std_srvs/Trigger", Result::Text, false, false, typeid(OperationCaller<std::string()>)},
};

template <class T>
OperationSignature::Value valueOf(const char* type, const char* name = "", bool isOutput = false) {
    OperationSignature::Value value;
    value.id = &typeid(T);
    value.type = RTT::types::Types()->getTypeById(value.id);
    value.typeName = type;
    value.isReference = isOutput;
    value.name = name;
    return value;
}

template <class T>
T valueIn(const Source& source) {
    auto* const typed = DataSource<T>::narrow(source.get());
    return typed ? typed->value() : T();
}
template <class T>
void set(const Source& source, const T& value) {
    if (auto* const variable = AssignableDataSource<T>::narrow(source.get())) variable->set(value);
}

std::size_t lengthAt(const std::uint8_t* from) {
    return from[0] | std::size_t(from[1]) << 8 | std::size_t(from[2]) << 16 | std::size_t(from[3]) << 24;
}

class ShortForm final : public ServiceForm {
public:
    explicit ShortForm(const Row& row) : row_(row) {}

    OperationSignature signature() const override {
        OperationSignature signature;
        signature.result.typeName = "void";
        if (row_.result == Result::Bool) signature.result = valueOf<bool>("bool");
        if (row_.result == Result::Text) signature.result = valueOf<std::string>("string");
        if (row_.takesFlag) signature.arguments.push_back(valueOf<bool>("bool", "data"));
        if (row_.givesMessage) signature.arguments.push_back(valueOf<std::string>("string", "message", true));
        return signature;
    }
    Args variables() const override {
        Args made;
        if (row_.takesFlag) made.emplace_back(new ValueDataSource<bool>());
        if (row_.givesMessage) made.emplace_back(new ValueDataSource<std::string>());
        return made;
    }

    void decodeRequest(const std::uint8_t* from, std::size_t size, const CallValues& into) const override {
        if (size != flagSize()) throw std::runtime_error("the request has another number of bytes than the service");
        if (row_.takesFlag) set(into.arguments[0], from[0] != 0);
        if (row_.givesMessage) set(into.arguments.back(), std::string());
    }
    std::size_t responseSize(const CallValues& values) const override {
        if (row_.hasStatus()) return 5 + message(values).size();
        if (row_.result == Result::Bool && !valueIn<bool>(values.result)) throw std::runtime_error("it returned false");
        return 0;
    }
    void encodeResponse(const CallValues& values, std::uint8_t* to, std::size_t room) const override {
        if (!row_.hasStatus()) return;
        const std::string text = message(values);
        if (room != 5 + text.size()) throw std::runtime_error("its message was changed while it was encoded");
        to[0] = row_.result != Result::Bool || valueIn<bool>(values.result);
        for (unsigned i = 0; i != 4; ++i) to[1 + i] = static_cast<std::uint8_t>(text.size() >> (8 * i));
        if (!text.empty()) std::memcpy(to + 5, text.data(), text.size());
    }

    std::size_t requestSize(const CallValues&) const override { return flagSize(); }
    void encodeRequest(const CallValues& values, std::uint8_t* to, std::size_t) const override {
        if (row_.takesFlag) to[0] = valueIn<bool>(values.arguments[0]);
    }
    void decodeResponse(const std::uint8_t* from, std::size_t size, const CallValues& into) const override {
        bool success = true;
        std::string text;
        if (size != (row_.hasStatus() ? 5 + (size < 5 ? 0 : lengthAt(from + 1)) : 0))
            throw std::runtime_error("the response has another number of bytes than the service");
        if (row_.hasStatus()) {
            success = from[0] != 0;
            text.assign(reinterpret_cast<const char*>(from) + 5, size - 5);
        }
        if (row_.givesMessage) {
            set(into.arguments.back(), text);
            into.arguments.back()->updated();
        }
        set(into.result, success);
        set(into.result, text);
    }
    void fail(const CallValues& values) const override {
        set(values.result, false);
        set(values.result, std::string());
    }

private:
    std::size_t flagSize() const { return row_.takesFlag ? 1 : 0; }
    std::string message(const CallValues& values) const {
        if (row_.givesMessage) return valueIn<std::string>(values.arguments.back());
        return row_.result == Result::Text ? valueIn<std::string>(values.result) : std::string();
    }
    const Row& row_;
};

}  // namespace

std::vector<Form> shortForms(const std::string& service) {
    std::vector<Form> forms;
    for (const Row& row : rows)
        if (service == row.service) forms.push_back(std::make_shared<ShortForm>(row));
    return forms;
}

Form shortFormOfCaller(const std::string& service, const std::type_info& caller) {
    for (const Row& row : rows)
        if (service == row.service && caller == row.caller) return std::make_shared<ShortForm>(row);
    return nullptr;
}

}  // namespace rtt_roscomm
