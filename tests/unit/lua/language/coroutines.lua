-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
local function numbers(n) return coroutine.wrap(function() for i = 1, n do coroutine.yield(i) end return "end" end) end
for x in numbers(3) do io.write(x, " "); if x == "end" then break end end
print()
local co = coroutine.create(function(a, b)
    print("begin", a, b)
    local c = coroutine.yield(a + b)
    print("got", c)
    local d, e = coroutine.yield(c * 2)
    print("got", d, e)
    return "done", 3
end)
print(coroutine.status(co), coroutine.running())
print(coroutine.resume(co, 1, 2))
print(coroutine.status(co), coroutine.resume(co, 10))
print(coroutine.resume(co, "x", "y"))
print(coroutine.status(co), coroutine.resume(co))
print(coroutine.resume(coroutine.create(function() error("broken") end)))
print(select("#", coroutine.resume(coroutine.create(function() error({code = 7}) end))))
print(pcall(coroutine.yield, 1))
