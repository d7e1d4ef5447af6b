-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
print("before")
local function inner(t) return t.missing.field end
local function outer() inner({}) end
outer()
print("never")
