-- SPDX-License-Identifier: Apache-2.0
-- Copyright Oroforge contributors
io.write("without end of line")
local co = coroutine.wrap(function() pcall(os.exit, 7) print("never") end)
co()
print("never")
