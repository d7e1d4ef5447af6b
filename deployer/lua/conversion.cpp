// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "conversion.hpp"

#include "assign_table.hpp"

#include <rtt/FlowStatus.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/SequenceOps.hpp>
#include <rtt/types/StructTable.hpp>
#include <rtt/types/TypeInfoRepository.hpp>
#include <rtt/types/TypeOps.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace OCL::lua {

using RTT::base::DataSourceBase;
using RTT::types::Shape;

namespace {

bool isA(const RTT::types::TypeInfo& type, const std::type_info& id) {
    const std::type_info* const own = type.getTypeId();
    return own && std::strcmp(own->name(), id.name()) == 0;
}

template <class T>
lua_Number read(const void* value) {
    T number;
    std::memcpy(&number, value, sizeof number);
    return static_cast<lua_Number>(number);
}

lua_Number readNumber(Shape::Number kind, const void* value) {
    switch (kind) {
        case Shape::Number::Int8: return read<std::int8_t>(value);
        case Shape::Number::UInt8: return read<std::uint8_t>(value);
        case Shape::Number::Int16: return read<std::int16_t>(value);
        case Shape::Number::UInt16: return read<std::uint16_t>(value);
        case Shape::Number::Int32: return read<std::int32_t>(value);
        case Shape::Number::UInt32: return read<std::uint32_t>(value);
        case Shape::Number::Int64: return read<std::int64_t>(value);
        case Shape::Number::UInt64: return read<std::uint64_t>(value);
        case Shape::Number::Float32: return read<float>(value);
        case Shape::Number::Float64: return read<double>(value);
        case Shape::Number::Bool:
        case Shape::Number::Char: break;
    }
    return 0;
}

/** False if the type does not have this number. */
template <class T>
bool write(DataSourceBase& target, lua_Number number) {
    T converted;
    if constexpr (std::is_floating_point_v<T>) {
        converted = static_cast<T>(number);
    } else {
        const lua_Number whole = std::trunc(number);
        // The largest value of 64 bits itself is no double, so the limit is the first one beyond.
        if (!(whole >= static_cast<lua_Number>(std::numeric_limits<T>::min()) &&
              whole < std::ldexp(1.0, std::numeric_limits<T>::digits)))
            return false;
        converted = static_cast<T>(whole);
    }
    return target.assignValue(&converted);
}

bool writeNumber(Shape::Number kind, DataSourceBase& target, lua_Number number) {
    switch (kind) {
        case Shape::Number::Int8: return write<std::int8_t>(target, number);
        case Shape::Number::UInt8: return write<std::uint8_t>(target, number);
        case Shape::Number::Int16: return write<std::int16_t>(target, number);
        case Shape::Number::UInt16: return write<std::uint16_t>(target, number);
        case Shape::Number::Int32: return write<std::int32_t>(target, number);
        case Shape::Number::UInt32: return write<std::uint32_t>(target, number);
        case Shape::Number::Int64: return write<std::int64_t>(target, number);
        case Shape::Number::UInt64: return write<std::uint64_t>(target, number);
        case Shape::Number::Float32: return write<float>(target, number);
        case Shape::Number::Float64: return write<double>(target, number);
        case Shape::Number::Bool:
        case Shape::Number::Char: break;
    }
    return false;
}

template <class Status>
std::string nameOf(Status status) {
    std::ostringstream text;
    text << status;
    return text.str();
}

/** False if the type is another one, or has no value of that name. */
template <class Status>
bool writeStatus(const RTT::types::TypeInfo& type, DataSourceBase& target, const std::string& name,
                 std::initializer_list<Status> all) {
    if (!isA(type, typeid(Status))) return false;
    for (const Status one : all)
        if (nameOf(one) == name) return target.assignValue(&one);
    return false;
}

template <class Status>
bool pushStatus(lua_State* lua, const RTT::types::TypeInfo& type, const void* value) {
    if (!isA(type, typeid(Status))) return false;
    lua_pushstring(lua, nameOf(*static_cast<const Status*>(value)).c_str());
    return true;
}

}  // namespace

Conversion::Conversion(const RTT::types::TypeInfo* type) : type_(type) {
    if (!type) return;
    shape_ = type->shape();
    if (type == RTT::internal::DataSource<void>::GetTypeInfo())
        form_ = Form::Void;
    else if (isA(*type, typeid(RTT::FlowStatus)) || isA(*type, typeid(RTT::SendStatus)) ||
             isA(*type, typeid(RTT::WriteStatus)))
        form_ = Form::Status;
    else if (shape_.kind == Shape::Kind::Number)
        form_ = shape_.number == Number::Bool ? Form::Bool : shape_.number == Number::Char ? Form::Char : Form::Number;
    else if (isA(*type, typeid(std::string)))
        form_ = Form::Text;
    else if (shape_.kind == Shape::Kind::Enumeration || shape_.kind == Shape::Kind::Text)
        form_ = Form::Named;
}

std::string Conversion::typeName() const { return type_ ? type_->getTypeName() : "unknown_t"; }

bool Conversion::hasElement(Source& of, std::size_t index) const {
    if (shape_.kind != Shape::Kind::Sequence || !shape_.elements) return true;
    const void* const container = of.evaluate() ? of.getRawConstPointer() : nullptr;
    return container && index < shape_.elements->size(container);
}

void Conversion::push(lua_State* lua, const void* value) const {
    if (!value && form_ != Form::Void) throw Failure("a value of type " + typeName() + " cannot be read");
    switch (form_) {
        case Form::Bool: return lua_pushboolean(lua, *static_cast<const bool*>(value));
        case Form::Char: {
            const char letter = *static_cast<const char*>(value);
            return lua_pushlstring(lua, &letter, letter ? 1 : 0);
        }
        case Form::Number: return lua_pushnumber(lua, readNumber(shape_.number, value));
        case Form::Text: {
            const std::string& text = *static_cast<const std::string*>(value);
            return lua_pushlstring(lua, text.data(), text.size());
        }
        case Form::Status:
            if (pushStatus<RTT::FlowStatus>(lua, *type_, value) || pushStatus<RTT::SendStatus>(lua, *type_, value) ||
                pushStatus<RTT::WriteStatus>(lua, *type_, value))
                return;
            break;
        case Form::Void:
        case Form::Named:
        case Form::Other: break;
    }
    lua_pushnil(lua);
}

void Conversion::refuse(lua_State* lua, int index) const {
    throw Failure(std::string("cannot make a ") + typeName() + " of a " + luaL_typename(lua, index));
}

void Conversion::assign(lua_State* lua, int index, Source& target) const {
    if (!target.isAssignable()) throw Failure("this " + typeName() + " cannot be changed");
    switch (form_) {
        case Form::Bool: {
            const int given = lua_type(lua, index);
            if (given != LUA_TBOOLEAN && given != LUA_TNUMBER) refuse(lua, index);
            const bool value = given == LUA_TBOOLEAN ? lua_toboolean(lua, index) != 0 : lua_tonumber(lua, index) != 0;
            if (target.assignValue(&value)) return target.updated();
            break;
        }
        case Form::Char: {
            std::size_t size = 0;
            const char* const text = lua_type(lua, index) == LUA_TSTRING ? lua_tolstring(lua, index, &size) : nullptr;
            if (!text) refuse(lua, index);
            if (size > 1) throw Failure("cannot make a char of a text of " + std::to_string(size) + " letters");
            const char letter = size ? text[0] : '\0';
            if (target.assignValue(&letter)) return target.updated();
            break;
        }
        case Form::Number: return assignNumber(lua, index, target);
        case Form::Text: return assignText(lua, index, target);
        case Form::Named: return assignName(lua, index, target);
        case Form::Status: return assignStatus(lua, index, target);
        case Form::Other:
            if (lua_istable(lua, index)) return assignTable(lua, index, target, shape_);
            break;
        case Form::Void: break;
    }
    refuse(lua, index);
}

void Conversion::assignNumber(lua_State* lua, int index, Source& target) const {
    if (lua_type(lua, index) != LUA_TNUMBER) refuse(lua, index);
    const lua_Number number = lua_tonumber(lua, index);
    if (!writeNumber(shape_.number, target, number)) {
        lua_pushvalue(lua, index);
        const std::string text = lua_tostring(lua, -1);
        throw Failure("type " + typeName() + " cannot hold " + text);
    }
    target.updated();
}

void Conversion::assignText(lua_State* lua, int index, Source& target) const {
    if (lua_type(lua, index) != LUA_TSTRING) refuse(lua, index);
    std::size_t size = 0;
    const char* const letters = lua_tolstring(lua, index, &size);
    if (void* const place = target.getRawPointer()) {
        static_cast<std::string*>(place)->assign(letters, size);
    } else {
        const std::string text(letters, size);
        if (!target.assignValue(&text)) throw Failure("this text cannot be changed");
    }
    target.updated();
}

void Conversion::assignStatus(lua_State* lua, int index, Source& target) const {
    if (lua_type(lua, index) != LUA_TSTRING) refuse(lua, index);
    const std::string name = lua_tostring(lua, index);
    if (writeStatus<RTT::FlowStatus>(*type_, target, name, {RTT::NoData, RTT::OldData, RTT::NewData}) ||
        writeStatus<RTT::SendStatus>(*type_, target, name,
                                     {RTT::CollectFailure, RTT::SendFailure, RTT::SendNotReady, RTT::SendSuccess}) ||
        writeStatus<RTT::WriteStatus>(*type_, target, name, {RTT::WriteSuccess, RTT::WriteFailure, RTT::NotConnected}))
        return target.updated();
    throw Failure("type " + typeName() + " has no value '" + name + "'");
}

/** An enumerator by name or number, or a text of another type than string. */
void Conversion::assignName(lua_State* lua, int index, Source& target) const {
    void* const place = target.getRawPointer();
    if (!place) throw Failure("this " + typeName() + " cannot be changed");
    const int given = lua_type(lua, index);
    if (shape_.kind == Shape::Kind::Text) {
        if (given != LUA_TSTRING) refuse(lua, index);
        std::size_t size = 0;
        const char* const letters = lua_tolstring(lua, index, &size);
        shape_.text->set(place, letters, size);
        return target.updated();
    }
    if (given == LUA_TNUMBER) {
        const lua_Number number = lua_tonumber(lua, index);
        for (const Shape::Enumerator& one : shape_.enumerators) {
            if (static_cast<lua_Number>(one.value) != number) continue;
            shape_.numbers->set(place, one.value);
            return target.updated();
        }
        throw Failure("type " + typeName() + " has no enumerator of that number");
    }
    if (given != LUA_TSTRING) refuse(lua, index);
    const std::string name = lua_tostring(lua, index);
    std::string known;
    for (const Shape::Enumerator& one : shape_.enumerators) {
        if (one.name == name) {
            shape_.numbers->set(place, one.value);
            return target.updated();
        }
        known += (known.empty() ? "" : ", ") + one.name;
    }
    throw Failure("type " + typeName() + " has no enumerator '" + name + "', but " + known);
}

}  // namespace OCL::lua
