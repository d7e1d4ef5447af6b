-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local Account = {balance = 0}
function Account:new(o) o = o or {}; setmetatable(o, self); self.__index = self; return o end
function Account:deposit(v) self.balance = self.balance + v end
function Account:withdraw(v) if v > self.balance then error("insufficient funds", 2) end; self.balance = self.balance - v end
local Special = Account:new()
function Special:withdraw(v) if v - self.balance >= self.limit then error("over the limit") end; self.balance = self.balance - v end
local s, a = Special:new({limit = 100}), Account:new()
s:deposit(10); s:withdraw(50); print(s.balance, a.balance, Account.balance)
print(pcall(a.withdraw, a, 1))
print(pcall(s.withdraw, s, 1000))
