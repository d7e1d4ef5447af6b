-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
-- Variables with parts: structs, sequences, arrays, enumerations, tables.
local check = require("check")
local V = rtt.Variable.new

local tank = V("/sample/Tank")
check.no(tank:isbasic())
check.yes(tank:tolua() == tank or tank:tolua():getTypeName() == "/sample/Tank")
check.equal({ "id", "label", "position", "levels", "path", "weights", "pair", "mode", "small", "flags" },
   tank:getMemberNames())
tank.id = 4
tank.label = "north"
check.equal(4, tank.id)
check.equal("north", tank.label)
tank.position.x = 1.5
check.equal(1.5, tank.position.x)
check.equal(1.5, tank:getMember("position"):getMember("x"))
local raw = tank:getMemberRaw("id")
check.equal("Variable", getmetatable(raw).__name)
raw:assign(5)
check.equal(5, tank.id)
check.fails("no member 'colour'", function() return tank.colour end)
check.fails("no member 'colour'", function() tank.colour = 1 end)
check.fails("no member 'colour'", tank.getMember, tank, "colour")
check.fails("cannot make a", function() tank.id = "five" end)
tank.small = 255
check.fails("cannot hold 256", function() tank.small = 256 end)
check.equal(255, tank.small)

-- A Variable of the type of the member.
local point = V("/sample/Point")
point:assign({ x = 3, y = 4 })
tank.position = point
check.equal(4, tank.position.y)
point.y = 9
check.equal(4, tank.position.y)
check.fails("cannot be assigned", function() tank.position = V("string") end)

-- Sequences count from 0.
check.yes(tank.levels:resize(3))
tank.levels[0], tank.levels[2] = 0.5, 2.5
check.equal(0.5, tank.levels[0])
check.equal(0, tank.levels[1])
check.equal(2.5, tank.levels[2])
check.equal(3, tank.levels:getMember("size"))
check.fails("no member '3'", function() return tank.levels[3] end)
check.fails("no member '-1'", function() return tank.levels[-1] end)
tank.path:resize(1)
tank.path[0].y = 8
check.equal(8, tank.path[0].y)
tank.flags:resize(2)
tank.flags[1] = true
check.equal(true, tank.flags[1])
check.equal(false, tank.flags[0])

-- Arrays have a size that stays.
tank.weights[2] = 0.25
check.equal(0.25, tank.weights[2])
check.no(tank.weights:resize(4))
tank.pair = { 7, 8 }
check.equal(8, tank.pair[1])
check.fails("no room", function() tank.pair = { 1, 2, 3 } end)

-- Enumerations by name and number.
tank.mode = "Filling"
check.equal("Filling", tank.mode:toString())
tank.mode = 7
check.equal("Draining", tank.mode:toString())
check.fails("no enumerator 'Boiling'", function() tank.mode = "Boiling" end)
check.fails("no enumerator of that number", function() tank.mode = 99 end)
check.fails("cannot make a", function() tank.mode = true end)
check.equal("Idle", V("/sample/Mode", "Idle"):toString())

-- Tables, with tables in them.
local other = V("/sample/Tank")
other:assign({ id = 1, position = { x = 1, y = 2 }, levels = { 1, 2, 3, 4 }, path = { { x = 5 }, { y = 6 } },
   mode = "Draining", flags = { true, false } })
check.equal(2, other.position.y)
check.equal(4, other.levels[3])
check.equal(6, other.path[1].y)
check.equal(true, other.flags[0])
check.fails("member 'position': ", other.assign, other, { position = { z = 1 } })
check.fails("'z'", other.assign, other, { position = { z = 1 } })
check.fails("member 'levels': ", other.assign, other, { levels = { "a" } })
check.fails("", other.assign, other, { [true] = 1 })

-- A whole value is a copy.
local copy = V("/sample/Tank")
copy:assign(other)
other.id = 77
check.equal(1, copy.id)

local texts = V("strings")
texts:assign({ "a", "b" })
check.equal("b", texts[1])
texts[1] = "c"
check.equal("c", texts[1])
texts:resize(0)
check.equal(0, texts:getMember("size"))
check.fails("number", texts.resize, texts, "x")
check.no(texts:resize(-1))
check.done()
