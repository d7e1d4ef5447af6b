-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
package.preload["mine"] = function(name) module(name, package.seeall); value = name .. "!"; function get() return value end end
local mine = require "mine"
print(mine == package.loaded.mine, mine.get(), require("mine") == mine, _NAME)
print((select(2, pcall(require, "no.such.module")):gsub("\n.*", "")))
print(type(package.path), type(package.cpath), type(package.loaders), package.loaded._G == _G)
print(package.config:sub(1, 1))
