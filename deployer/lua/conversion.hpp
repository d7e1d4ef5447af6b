// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_CONVERSION_HPP
#define OCL_LUA_CONVERSION_HPP

#include "failure.hpp"

#include <rtt/base/DataSourceBase.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <string>

namespace OCL::lua {

/** How values of one type become values of Lua and back, made from the shape of the type. */
class Conversion {
public:
    typedef RTT::base::DataSourceBase Source;

    /** A null type is unknown. */
    explicit Conversion(const RTT::types::TypeInfo* type);

    const RTT::types::TypeInfo* type() const { return type_; }
    std::string typeName() const;
    bool isVoid() const { return form_ == Form::Void; }
    /** Its values become values of Lua itself, not Variables. */
    bool isBasic() const { return form_ != Form::Other && form_ != Form::Named; }

    /** False if the value is a sequence, or an array, that has fewer elements. */
    bool hasElement(Source& of, std::size_t index) const;

    /** Pushes the value at this address, of a basic type. */
    void push(lua_State* lua, const void* value) const;
    /** Assigns a value of Lua that is no Variable. Tables fill structs by their names, and sequences from index 1.
        Throws Failure. */
    void assign(lua_State* lua, int index, Source& target) const;

private:
    typedef RTT::types::Shape::Number Number;
    enum class Form { Other, Void, Bool, Char, Number, Text, Status, Named };

    void assignNumber(lua_State* lua, int index, Source& target) const;
    void assignText(lua_State* lua, int index, Source& target) const;
    void assignName(lua_State* lua, int index, Source& target) const;
    void assignStatus(lua_State* lua, int index, Source& target) const;
    [[noreturn]] void refuse(lua_State* lua, int index) const;

    const RTT::types::TypeInfo* const type_;
    Form form_ = Form::Other;
    RTT::types::Shape shape_;
};

/** Assigns the value at `index` to `target`: a Variable, whose type is converted if needed, a table, or a simple value.
    Throws Failure. */
void assign(lua_State* lua, int index, RTT::base::DataSourceBase& target);

}  // namespace OCL::lua

#endif
