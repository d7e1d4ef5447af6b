// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "bindings.hpp"
#include "box.hpp"
#include "conversion.hpp"
#include "member_access.hpp"
#include "state.hpp"
#include "things.hpp"
#include "values.hpp"

#include <rtt/internal/DataSources.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

namespace OCL::lua {

using RTT::base::DataSourceBase;
typedef DataSourceBase::shared_ptr Source;

namespace {

Variable& self(lua_State* lua) {
    Variable& variable = boxAt<Variable>(lua, 1);
    variable.life.check(Variable::kName);
    return variable;
}

int make(lua_State* lua) {
    const Source made = newValue(textAt(lua, 1));
    if (!lua_isnoneornil(lua, 2)) assign(lua, 2, *made);
    pushBox<Variable>(lua, made, Life());
    return 1;
}

int toLua(lua_State* lua) {
    const Variable& variable = self(lua);
    if (State::of(lua).conversion(variable.source->getTypeInfo()).isBasic())
        pushValue(lua, variable.source, variable.life);
    else
        lua_pushvalue(lua, 1);
    return 1;
}

int isBasic(lua_State* lua) {
    lua_pushboolean(lua, State::of(lua).conversion(self(lua).source->getTypeInfo()).isBasic());
    return 1;
}

int toText(lua_State* lua) {
    const Variable& variable = self(lua);
    (void)variable.source->evaluate();
    pushText(lua, variable.source->toString());
    return 1;
}

int types(lua_State* lua) {
    pushTexts(lua, RTT::types::Types()->getTypes());
    return 1;
}

int typeWithReference(lua_State* lua) {
    pushText(lua, self(lua).source->getType());
    return 1;
}

int typeName(lua_State* lua) {
    pushText(lua, self(lua).source->getTypeName());
    return 1;
}

int typeIdName(lua_State* lua) {
    const std::type_info* const id = self(lua).source->getTypeId();
    pushText(lua, id ? id->name() : "");
    return 1;
}

int memberNames(lua_State* lua) {
    pushTexts(lua, self(lua).source->getMemberNames());
    return 1;
}

int member(lua_State* lua) {
    const Variable& variable = self(lua);
    pushValue(lua, memberAt(lua, 2, variable.source), variable.life);
    return 1;
}

int rawMember(lua_State* lua) {
    const Variable& variable = self(lua);
    pushBox<Variable>(lua, memberAt(lua, 2, variable.source), variable.life);
    return 1;
}

int index(lua_State* lua) {
    if (lua_type(lua, 2) == LUA_TSTRING) {
        lua_pushvalue(lua, 2);
        lua_rawget(lua, lua_upvalueindex(1));
        if (!lua_isnil(lua, -1)) return 1;
        lua_pop(lua, 1);
    }
    return member(lua);
}

int setMember(lua_State* lua) {
    assign(lua, 3, *memberAt(lua, 2, self(lua).source));
    return 0;
}

int resize(lua_State* lua) {
    const Source source = self(lua).source;
    const lua_Number size = luaL_checknumber(lua, 2);
    lua_pushboolean(lua,
                    size >= 0 && size < 2147483648.0 && source->getTypeInfo()->resize(source, static_cast<int>(size)));
    return 1;
}

int assignAll(lua_State* lua) {
    luaL_checkany(lua, 2);
    assign(lua, 2, *self(lua).source);
    return 0;
}

int toPointer(lua_State* lua) {
    lua_pushlightuserdata(lua, self(lua).source->getRawPointer());
    return 1;
}

/** The operand at `index`; what is no Variable becomes one of the type of the other operand. */
Source operandAt(lua_State* lua, int index, int other) {
    if (const Variable* const variable = findBox<Variable>(lua, index)) {
        variable->life.check(Variable::kName);
        return variable->source;
    }
    const Variable& like = boxAt<Variable>(lua, other);
    const Source made = like.source->getTypeInfo()->buildValue();
    if (!made) detail::wrongKind(lua, index, Variable::kName);
    assign(lua, index, *made);
    return made;
}

Source computed(const std::string& op, const Source& result, const Source& a, const Source& b) {
    if (!result)
        throw Failure("there is no operator " + op + " for " + a->getTypeName() +
                      (b ? " and " + b->getTypeName() : std::string()));
    if (!result->evaluate()) throw Failure("operator " + op + " failed");
    return result;
}

void pushResult(lua_State* lua, const Source& result) {
    const RTT::types::TypeInfo* const type = result->getTypeInfo();
    const Source copy = type->buildValue();
    if (!copy || !copy->assignValue(result->getRawConstPointer())) return lua_pushnil(lua);
    pushBox<Variable>(lua, copy, Life());
}

Source binary(lua_State* lua, const char* op, int first) {
    const Source a = operandAt(lua, first, first + 1), b = operandAt(lua, first + 1, first);
    return computed(op, RTT::types::operators()->applyBinary(op, a.get(), b.get()), a, b);
}

int opBinary(lua_State* lua) {
    const std::string op = textAt(lua, 1);
    pushResult(lua, binary(lua, op.c_str(), 2));
    return 1;
}

int minus(lua_State* lua) {
    const Source operand = self(lua).source;
    pushResult(lua, computed("-", RTT::types::operators()->applyUnary("-", operand.get()), operand, nullptr));
    return 1;
}

int arithmetic(lua_State* lua, const char* op) {
    pushResult(lua, binary(lua, op, 1));
    return 1;
}

int compare(lua_State* lua, const char* op) {
    const Source result = binary(lua, op, 1);
    State::of(lua).conversion(result->getTypeInfo()).push(lua, result->getRawConstPointer());
    return 1;
}

int add(lua_State* lua) { return arithmetic(lua, "+"); }
int subtract(lua_State* lua) { return arithmetic(lua, "-"); }
int multiply(lua_State* lua) { return arithmetic(lua, "*"); }
int divide(lua_State* lua) { return arithmetic(lua, "/"); }
int modulo(lua_State* lua) { return arithmetic(lua, "%"); }
int power(lua_State* lua) { return arithmetic(lua, "^"); }
int isEqual(lua_State* lua) { return compare(lua, "=="); }
int isLess(lua_State* lua) { return compare(lua, "<"); }
int isLessOrEqual(lua_State* lua) { return compare(lua, "<="); }

}  // namespace

void bindVariable(lua_State* lua) {
    const luaL_Reg methods[] = {{"new", &guarded<&make>},
                                {"tolua", &guarded<&toLua>},
                                {"isbasic", &guarded<&isBasic>},
                                {"toString", &guarded<&toText>},
                                {"getTypes", &guarded<&types>},
                                {"getType", &guarded<&typeWithReference>},
                                {"getTypeName", &guarded<&typeName>},
                                {"getTypeIdName", &guarded<&typeIdName>},
                                {"getMemberNames", &guarded<&memberNames>},
                                {"getMember", &guarded<&member>},
                                {"getMemberRaw", &guarded<&rawMember>},
                                {"resize", &guarded<&resize>},
                                {"assign", &guarded<&assignAll>},
                                {"tolud", &guarded<&toPointer>},
                                {"opBinary", &guarded<&opBinary>},
                                {"unm", &guarded<&minus>},
                                {"add", &guarded<&add>},
                                {"sub", &guarded<&subtract>},
                                {"mul", &guarded<&multiply>},
                                {"div", &guarded<&divide>},
                                {"mod", &guarded<&modulo>},
                                {"pow", &guarded<&power>},
                                {"eq", &guarded<&isEqual>},
                                {"lt", &guarded<&isLess>},
                                {"le", &guarded<&isLessOrEqual>},
                                {nullptr, nullptr}};
    const luaL_Reg events[] = {{"__index", &guarded<&index>},      {"__newindex", &guarded<&setMember>},
                               {"__tostring", &guarded<&toText>},  {"__unm", &guarded<&minus>},
                               {"__add", &guarded<&add>},          {"__sub", &guarded<&subtract>},
                               {"__mul", &guarded<&multiply>},     {"__div", &guarded<&divide>},
                               {"__mod", &guarded<&modulo>},       {"__pow", &guarded<&power>},
                               {"__eq", &guarded<&isEqual>},       {"__lt", &guarded<&isLess>},
                               {"__le", &guarded<&isLessOrEqual>}, {nullptr, nullptr}};
    registerKind<Variable>(lua, methods, events);
}

}  // namespace OCL::lua
